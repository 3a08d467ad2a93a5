#pragma once

#include <filesystem>
#include <string>

#include "client/snapshot_file.h"

namespace trajan::client {

struct RenderStyle {
  /// Displacements are drawn so many times as large as they are; 0 draws the reference configuration.
  double deformation_scale = 1;
  /// From where a solid is looked at, see `projection`; empty: oblique.
  std::string view;
  /// Draws the other half of an axisymmetric scene too.
  bool mirrored = false;
};

/// Draws particles as discs of their own size, coloured by their values, with equal axes; of a bar the values
/// over x. Throws CommandError.
void draw_particles(const ParticlePicture& particles, const RenderStyle& style,
                    const std::filesystem::path& picture);

}  // namespace trajan::client
