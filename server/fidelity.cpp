#include "server/fidelity.h"

#include <cmath>

#include "proto/field_change.h"
#include "server/errors.h"
#include "server/study_dials.h"

namespace trajan {

namespace {

void change(v1::Scene& scene, const v1::Setting& setting) {
  for (const std::string& text : setting.changes()) change_field(scene, text);
}

void take_over(v1::Scene& scene, const v1::Settings& settings) {
  if (!std::isfinite(settings.cell_size()) || settings.cell_size() < 0)
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "SETTINGS",
                       "fidelity.settings.cell_size must be positive");
  if (settings.cell_size() > 0) change(scene, with_cell_size(scene, settings.cell_size()));
  if (settings.particles_per_cell_side() > 0 && !scene.bodies().empty())
    scene.mutable_bodies(0)->set_particles_per_cell_side(settings.particles_per_cell_side());
  if (settings.has_numerics()) *scene.mutable_numerics() = settings.numerics();
  if (settings.has_analysis()) *scene.mutable_analysis() = settings.analysis();
  if (settings.samples() > 0) scene.mutable_outputs()->set_samples(settings.samples());
  if (settings.has_snapshots()) scene.mutable_outputs()->set_snapshots(settings.snapshots());
}

}  // namespace

void resolve_fidelity(const v1::Fidelity& fidelity, v1::Scene& scene) {
  if (fidelity.has_settings()) take_over(scene, fidelity.settings());
  if (fidelity.preset() == v1::PREVIEW) change(scene, with_cell_size(scene, 2 * scene.domain().cell_size()));
  if (fidelity.preset() == v1::REFERENCE) change(scene, with_cell_size(scene, scene.domain().cell_size() / 2));
}

}  // namespace trajan
