#pragma once

#include <string>
#include <vector>

#include "solver/model/validate.h"
#include "solver/scene/scene.h"

namespace trajan {

/// A cantilever of length 8 and height 1 with cells of 0.25 in the domain (-1, -1) to (9, 2), an end load,
/// gravity, a point force, a disc above it, two probes and two measures. Valid.
Scene sample_scene();

/// The violations of a scene, in the order found; none if it is valid.
std::vector<Violation> violations_of(const Scene& scene);

/// The paths of these.
std::vector<std::string> paths_of(const Scene& scene);

}  // namespace trajan
