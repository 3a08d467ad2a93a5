#include "server/scene_digest.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <openssl/sha.h>

#include <algorithm>

namespace trajan {

namespace {

std::string sha256(const std::string& bytes) {
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest);
  std::string text;
  for (const unsigned char byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

}  // namespace

std::string deterministic_bytes(const google::protobuf::Message& message) {
  std::string bytes;
  {
    google::protobuf::io::StringOutputStream stream(&bytes);
    google::protobuf::io::CodedOutputStream coded(&stream);
    coded.SetSerializationDeterministic(true);
    message.SerializeToCodedStream(&coded);
  }
  return bytes;
}

std::string scene_digest(const v1::Scene& scene) {
  return sha256(std::string(TRAJAN_VERSION) + '\n' + deterministic_bytes(scene));
}

std::string family_digest(v1::Scene scene) {
  scene.clear_name();
  scene.clear_description();
  scene.clear_units();
  scene.mutable_domain()->clear_cell_size();
  scene.clear_numerics();
  scene.mutable_analysis()->clear_kind();
  for (v1::Body& body : *scene.mutable_bodies()) body.clear_particles_per_cell_side();
  for (v1::Constant& constant : *scene.mutable_constants()) {
    if (constant.name() == "cell") constant.clear_value();
  }
  return sha256(deterministic_bytes(scene));
}

namespace {

/// What a scene leaves out has its default.
v1::Numerics with_defaults(v1::Numerics numerics) {
  if (numerics.scheme().empty()) numerics.set_scheme("MUSL");
  if (numerics.shape_functions().empty()) numerics.set_shape_functions("linear");
  if (numerics.transfer().empty()) numerics.set_transfer("FLIP");
  if (numerics.locking_remedy().empty()) numerics.set_locking_remedy("none");
  if (!numerics.has_time_step() && !numerics.has_time_step_fraction()) numerics.set_time_step_fraction(0.5);
  return numerics;
}

}  // namespace

v1::Settings settings_of(const v1::Scene& scene) {
  constexpr int default_particles = 2;
  constexpr int default_samples = 200;
  v1::Settings settings;
  settings.set_cell_size(scene.domain().cell_size());
  settings.set_particles_per_cell_side(default_particles);
  if (!scene.bodies().empty() && scene.bodies(0).has_particles_per_cell_side())
    settings.set_particles_per_cell_side(scene.bodies(0).particles_per_cell_side());
  *settings.mutable_numerics() = with_defaults(scene.numerics());
  *settings.mutable_analysis() = scene.analysis();
  if (settings.analysis().kind_case() == v1::Analysis::KIND_NOT_SET)
    settings.mutable_analysis()->mutable_explicit_dynamics();
  settings.set_samples(scene.outputs().has_samples() ? scene.outputs().samples() : default_samples);
  if (scene.outputs().has_snapshots()) settings.set_snapshots(scene.outputs().snapshots());
  return settings;
}

}  // namespace trajan
