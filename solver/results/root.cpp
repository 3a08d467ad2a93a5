#include "solver/results/root.h"

#include <array>
#include <chrono>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "solver/results/digest.h"

namespace trajan::results {

namespace {

constexpr std::array<const char*, 4> status_names = {"running", "succeeded", "diverged", "cancelled"};

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

std::string dimension_name(Dimension dimension) {
  switch (dimension) {
    case Dimension::bar:
      return "bar";
    case Dimension::plane_stress:
      return "plane stress";
    case Dimension::plane_strain:
      return "plane strain";
    case Dimension::axisymmetric:
      return "axisymmetric";
    case Dimension::solid:
      return "solid";
    case Dimension::unspecified:
      break;
  }
  return "unspecified";
}

}  // namespace

void write_root(hid_t file, const Model& model, const Provenance& provenance) {
  set_attribute(file, "name", model.name);
  set_attribute(file, "description", model.description);
  set_attribute(file, "units", model.units);
  set_attribute(file, "dimension", dimension_name(model.dimension));
  set_attribute(file, "scene", provenance.scene_text);
  set_attribute(file, "scene_sha256", sha256(provenance.scene_text));
  set_attribute(file, "solver_version", provenance.solver_version);
  set_attribute(file, "created", utc_now());
  set_attribute(file, "status", std::string(status_names[0]));
  set_attribute(file, "divergence_cause", std::string());
  set_attribute(file, "divergence_remedy", std::string());
  set_attribute(file, "divergence_step", std::int64_t{-1});
  set_attribute(file, "divergence_time", std::numeric_limits<double>::quiet_NaN());
  set_attribute(file, "divergence_particle", std::int64_t{-1});
}

std::string run_identity(const Provenance& provenance) {
  return sha256(provenance.scene_text) + " " + provenance.solver_version;
}

std::string run_identity(hid_t file) {
  return text_attribute(file, "scene_sha256") + " " + text_attribute(file, "solver_version");
}

void write_end(hid_t file, Status status, const std::optional<Divergence>& divergence) {
  if (divergence) {
    set_attribute(file, "divergence_cause", divergence->cause);
    set_attribute(file, "divergence_remedy", divergence->remedy);
    set_attribute(file, "divergence_step", divergence->step);
    set_attribute(file, "divergence_time", divergence->time);
    set_attribute(file, "divergence_particle", divergence->particle);
  }
  set_attribute(file, "status", std::string(status_names[static_cast<std::size_t>(status)]));
}

Status read_status(hid_t file) {
  const std::string name = text_attribute(file, "status");
  for (std::size_t i = 0; i < status_names.size(); ++i)
    if (name == status_names[i]) return static_cast<Status>(i);
  throw std::runtime_error("cannot understand the status \"" + name + "\"");
}

std::optional<Divergence> read_divergence(hid_t file) {
  if (read_status(file) != Status::diverged) return std::nullopt;
  return Divergence{integer_attribute(file, "divergence_step"), number_attribute(file, "divergence_time"),
                    integer_attribute(file, "divergence_particle"), text_attribute(file, "divergence_cause"),
                    text_attribute(file, "divergence_remedy")};
}

}  // namespace trajan::results
