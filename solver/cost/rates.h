#pragma once

#include <map>
#include <string>
#include <string_view>

#include "solver/scene/scene.h"

/// What pieces of work take on a machine.
namespace trajan {

/// Seconds of one thread, by name, for example "plane_strain/linear/MUSL/particle". Whoever counts work
/// (solver/cost/run_time.h) and whoever measures rates (solver/cost/measure_rates.h) name them by these functions.
using Rates = std::map<std::string, double>;

/// To be raised when rates come, go or mean something else, or steps have become faster, so that machines are
/// measured anew.
constexpr int rates_version = 10;

/// An explicit step with transfer FLIP and an elastic law in rate form: each "step", each of its "tile"s (see
/// `weighted_tiles`) and "particle"s.
std::string step_rate(Dimension, const Numerics&, std::string_view of);
/// What another transfer takes more, per particle.
std::string transfer_rate(Dimension, const Numerics&);
/// What another law takes more, or the same law with stresses that are held at zero, per particle.
std::string law_rate(Dimension, bool total_lagrangian, std::string_view law);
/// What contact between bodies takes more, per particle of a layer.
std::string contact_rate(Dimension, std::string_view shape_functions);
/// A character of a body force's formula, per particle that it is evaluated for.
std::string formula_rate();
/// A sample of histories, whose energies are those of a law, per particle.
std::string sample_rate(Dimension, bool total_lagrangian, std::string_view law);
/// An iteration of Newton's method with a neo-Hookean law: its "assembly" per particle, its "factors" per unit of
/// `factor_work`.
std::string iteration_rate(Dimension, std::string_view shape_functions, std::string_view of);
/// What another law takes more in it, per particle.
std::string tangent_rate(Dimension, std::string_view law);
/// A search for modes, in iterations of Newton's method on the same grid.
std::string modes_rate();
/// What a step takes more per byte of particles that does not stay in the cache.
std::string memory_rate();
/// What more threads than one wait for each other in an explicit step.
std::string waiting_rate();
/// Recording and what goes with it: a "run" from its beginning to its finished file without what follows, each
/// "particle" of it; a "snapshot" and each "snapshot_byte"; each "row" of histories. Of wall time, with waiting
/// for the disk, and of processor time. Of memory: what a "run" of next to nothing holds at most, and what one
/// holds beside its arrays while it is "running".
std::string recording_rate(std::string_view of);
std::string processing_rate(std::string_view of);

}  // namespace trajan
