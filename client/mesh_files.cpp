#include "client/mesh_files.h"

#include <fstream>
#include <optional>

namespace trajan::client {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// Looks for meshes in all of a scene.
class Embedding {
 public:
  Embedding(const std::filesystem::path& folder, std::size_t most_bytes) : folder_(folder), left_(most_bytes) {}

  void visit(Message& message, const std::string& path) {
    if (message.GetDescriptor() == v1::Mesh::descriptor()) return embed(static_cast<v1::Mesh&>(message), path);
    const auto& reflection = *message.GetReflection();
    std::vector<const FieldDescriptor*> fields;
    reflection.ListFields(message, &fields);
    for (const FieldDescriptor* field : fields) {
      if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
      const std::string place = path.empty() ? field->name() : path + "." + field->name();
      if (!field->is_repeated()) visit(*reflection.MutableMessage(&message, field), place);
      for (int i = 0; field->is_repeated() && i < reflection.FieldSize(message, field); ++i)
        visit(*reflection.MutableRepeatedMessage(&message, field, i), place + "[" + std::to_string(i) + "]");
    }
  }
  std::vector<MeshFileError> take_errors() { return std::move(errors_); }

 private:
  void embed(v1::Mesh& mesh, const std::string& path) {
    if (mesh.file().empty() || !mesh.stl().empty()) return;
    std::ifstream file(folder_ / mesh.file(), std::ios::binary);
    // One byte more than may be read tells a file that is too large.
    std::string content(left_ + 1, '\0');
    file.read(content.data(), static_cast<std::streamsize>(content.size()));
    content.resize(static_cast<std::size_t>(file.gcount()));
    std::string problem;
    if (content.empty()) problem = "the file cannot be read or is empty";
    if (content.size() > left_) problem = "the scene's mesh files are too large to be sent";
    if (!problem.empty()) {
      errors_.push_back({path + ".file", mesh.file(), problem});
      return;
    }
    left_ -= content.size();
    mesh.set_stl(std::move(content));
  }

  std::filesystem::path folder_;
  std::size_t left_;
  std::vector<MeshFileError> errors_;
};

}  // namespace

std::vector<MeshFileError> embed_mesh_files(v1::Scene& scene, const std::filesystem::path& folder,
                                            std::size_t most_bytes) {
  Embedding embedding(folder, most_bytes);
  embedding.visit(scene, "");
  return embedding.take_errors();
}

}  // namespace trajan::client
