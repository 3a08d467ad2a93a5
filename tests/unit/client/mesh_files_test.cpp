#include "client/mesh_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace trajan::client {
namespace {

class MeshFiles : public ::testing::Test {
 protected:
  MeshFiles() {
    std::string name = (std::filesystem::temp_directory_path() / "trajan-mesh-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    std::ofstream(folder_ / "part.stl") << "solid part";
  }
  ~MeshFiles() override { std::filesystem::remove_all(folder_); }
  static v1::Mesh& mesh(v1::Scene& scene) {
    v1::Region& whole = *scene.add_bodies()->mutable_geometry();
    whole.mutable_difference()->add_regions()->mutable_box();
    return *whole.mutable_difference()->add_regions()->mutable_mesh();
  }
  std::filesystem::path folder_;
};

TEST_F(MeshFiles, AreReadFromTheFolderOfTheScene) {
  v1::Scene scene;
  mesh(scene).set_file("part.stl");
  EXPECT_TRUE(embed_mesh_files(scene, folder_, 10).empty());
  EXPECT_EQ(scene.bodies(0).geometry().difference().regions(1).mesh().stl(), "solid part");
}

TEST_F(MeshFiles, ThatCannotBeSentAreNamed) {
  v1::Scene scene;
  mesh(scene).set_file("part.stl");
  mesh(scene).set_file("no.stl");
  const auto errors = embed_mesh_files(scene, folder_, 9);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].path, "bodies[0].geometry.difference.regions[1].mesh.file");
  EXPECT_NE(errors[0].problem.find("too large"), std::string::npos);
  EXPECT_EQ(errors[1].path, "bodies[1].geometry.difference.regions[1].mesh.file");
  EXPECT_NE(errors[1].problem.find("cannot be read"), std::string::npos);
}

TEST_F(MeshFiles, AreLeftAloneWhereTheContentIsGiven) {
  v1::Scene scene;
  v1::Mesh& given = mesh(scene);
  given.set_file("no.stl");
  given.set_stl("content");
  EXPECT_TRUE(embed_mesh_files(scene, folder_, 10).empty());
  EXPECT_EQ(given.stl(), "content");
}

}  // namespace
}  // namespace trajan::client
