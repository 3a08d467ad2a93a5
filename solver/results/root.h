#pragma once

#include <optional>

#include "solver/results/handles.h"
#include "solver/results/results.h"

/// The root attributes: what was computed, by what, and how it ended.
namespace trajan::results {

/// Before the file goes to single-writer-multiple-reader mode. The end is `running` then.
void write_root(hid_t file, const Model& model, const Provenance& provenance);
/// SHA-256 of the scene's text and the solver's version: two runs of the same identity have the same bits.
std::string run_identity(const Provenance& provenance);
/// Of an existing file.
std::string run_identity(hid_t file);

void write_end(hid_t file, Status status, const std::optional<Divergence>& divergence);
Status read_status(hid_t file);
std::optional<Divergence> read_divergence(hid_t file);

}  // namespace trajan::results
