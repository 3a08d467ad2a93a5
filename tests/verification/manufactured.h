#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/scene/scene.h"

/// Errors of scenes whose motion is known everywhere at all times.
namespace trajan::verification {

/// A scene of the gallery with a manufactured body force, and its exact motion.
struct ManufacturedSolution {
  const char* scene;
  /// The largest displacement: errors are in units of it.
  double largest_displacement;
  /// The largest cells of a study of convergence.
  double coarsest;
  Vector (*displacement)(Vector reference, double time);
};

/// Axis-aligned displacement (Wallstedt & Guilkey 2008) and generalized vortex (Kamojjala et al. 2015); derived
/// and checked in tests/references/manufactured.py.
std::span<const ManufacturedSolution> manufactured_solutions();

/// The root of the mean square over all particles of the distance to the exact displacement, the largest over the
/// scene's snapshots, in units of the largest displacement. Throws what run_scene throws.
double displacement_error(Scene scene, const ManufacturedSolution& solution);

/// The scene by another scheme, other shape functions and another transfer.
Scene with_numerics(Scene scene, const std::string& scheme, const std::string& shape_functions,
                    const std::string& transfer);

}  // namespace trajan::verification
