#pragma once

#include <filesystem>
#include <string>

#include "client/snapshot_file.h"

namespace trajan::client {

struct RenderStyle {
  std::string field;
  /// Displacements are drawn so many times as large as they are; 0 draws the reference configuration.
  double deformation_scale = 1;
};

/// Draws particles as discs of their own size, coloured by a field, with equal axes. Throws CommandError.
void draw_particles(const ParticlePicture& particles, const RenderStyle& style,
                    const std::filesystem::path& picture);

}  // namespace trajan::client
