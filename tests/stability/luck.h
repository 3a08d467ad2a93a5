#pragma once

namespace trajan::stability {

/// Tries so many random valid scenes: momentum, balance of energy, the same bits on more threads and after a
/// restart, the same motion a whole cell away; or the run says why not. False: one broke its promise, which is
/// told on stderr with the smallest scene that does and how to run it again. The environment variable RC_PARAMS
/// has precedence (RapidCheck's, for example "seed=7 max_success=5000").
bool try_luck(int scenes);

}  // namespace trajan::stability
