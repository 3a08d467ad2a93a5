#pragma once

/// Code that is compiled several times, once for each instruction set, lives in an inline namespace that
/// is named after it, so that the linker never takes one set's copy of a function for another's.
#ifndef TRAJAN_INSTRUCTION_SET
#define TRAJAN_INSTRUCTION_SET baseline
#endif
