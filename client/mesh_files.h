#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trajan/v1/scene.pb.h"

namespace trajan::client {

/// A mesh file that could not be put into a scene.
struct MeshFileError {
  std::string path;  ///< of the field, for example "bodies[0].geometry.mesh.file"
  std::string file;
  std::string problem;
};

/// Reads the files that the scene's meshes name into the scene, since a server cannot see them. Relative names
/// begin at `folder`. At most `most_bytes` are read in all. A mesh that has its content already keeps it.
std::vector<MeshFileError> embed_mesh_files(v1::Scene& scene, const std::filesystem::path& folder,
                                            std::size_t most_bytes);

}  // namespace trajan::client
