#pragma once

#include <filesystem>

#include "trajan/v1/estimates.pb.h"

namespace trajan {

/// Finds out what a whole run takes by runs for about so many seconds of wall time together: of the scene itself
/// from its beginning, as a worker would run it, and, if it does not reach its end, of the same scene with larger
/// cells to its end, which shows how the costs are spread over the time: time steps become shorter as bodies
/// stretch, contact and iterations begin. Files are written below the directory. Throws InvalidScene.
v1::Trial try_scene(const v1::Scene& scene, const std::filesystem::path& directory, double seconds, int threads);

}  // namespace trajan
