#include "solver/results/snapshots.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <stdexcept>

#include "solver/results/chunks.h"

namespace trajan::results {

namespace {

constexpr hsize_t steps_per_chunk = 128;
constexpr std::array<const char*, 4> topologies = {"Vertices", "Lines", "Polygons", "Strips"};

/// The datasets of Steps beside Values: one integer row per snapshot, telling where its data begin.
struct Offsets {
  std::string name;
  hsize_t components;
  bool advances;  ///< by the number of particles per snapshot; otherwise zero: stored once for all
};

RecordedField vector_field(Field field, const Model& model) {
  return {field, std::string(field_name(field)), vector_components(model.dimension), {}};
}

std::vector<RecordedField> stored_fields(const Model& model) {
  std::vector<RecordedField> fields = {vector_field(Field::velocity, model)};
  fields.insert(fields.end(), model.outputs.snapshot_fields.begin(), model.outputs.snapshot_fields.end());
  return fields;
}

/// VTK wants the components that a solid has.
std::span<const std::string_view> stored_components(const RecordedField& field) {
  return field_components(field.field, Dimension::solid);
}

std::vector<Offsets> offsets_of(const Model& model) {
  std::vector<Offsets> offsets = {{"PartOffsets", 0, false},
                                  {"PointOffsets", 0, true},
                                  {"CellOffsets", topologies.size(), false},
                                  {"ConnectivityIdOffsets", topologies.size(), false},
                                  {"PointDataOffsets/particle_number", 0, false},
                                  {"PointDataOffsets/body", 0, false}};
  for (const RecordedField& field : stored_fields(model))
    offsets.push_back({"PointDataOffsets/" + field.name, 0, true});
  return offsets;
}

hsize_t chunk_for(hsize_t rows) { return std::clamp<hsize_t>(rows, 1, rows_per_chunk); }

/// Stores value(0), …, value(count - 1), a chunk at a time.
template <typename T>
void write_constant(hid_t group, const std::string& name, hsize_t count, const std::function<T(hsize_t)>& value) {
  Dataset data = Dataset::create<T>(group, name, 0, chunk_for(count));
  std::vector<T> block;
  for (hsize_t first = 0; first < count; first += block.size()) {
    block.resize(std::min<hsize_t>(rows_per_chunk, count - first));
    for (hsize_t i = 0; i < block.size(); ++i) block[i] = value(first + i);
    data.write<T>(first, block);
  }
}

void write_topology(hid_t vtk, const std::string& name, hsize_t cells) {
  const Handle group = make_group(vtk, name);
  const auto identity = [](hsize_t i) { return static_cast<std::int64_t>(i); };
  const auto size = [&](hsize_t) { return static_cast<std::int64_t>(cells); };
  write_constant<std::int64_t>(group, "NumberOfCells", 1, size);
  write_constant<std::int64_t>(group, "NumberOfConnectivityIds", 1, size);
  write_constant<std::int64_t>(group, "Connectivity", cells, identity);
  write_constant<std::int64_t>(group, "Offsets", cells + 1, identity);
}

void write_type(hid_t vtk) {
  const std::string what = "write attribute Type", type_name = "PolyData";
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
  check(H5Tset_size(type, type_name.size()), what);
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), what);
  Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, what);
  Handle attribute(H5Acreate2(vtk, "Type", type, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  check(H5Awrite(attribute, type, type_name.data()), what);
}

void write_version(hid_t vtk) {
  const std::string what = "write attribute Version";
  const std::array<std::int64_t, 2> version = {2, 0};
  const hsize_t size = version.size();
  Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, what);
  Handle attribute(H5Acreate2(vtk, "Version", stored_type<std::int64_t>(), space, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose, what);
  check(H5Awrite(attribute, memory_type<std::int64_t>(), version.data()), what);
}

void write_identities(hid_t point_data, const Model& model) {
  const hsize_t particles = static_cast<hsize_t>(model.particle_count());
  write_constant<std::int64_t>(point_data, "particle_number", particles,
                               [](hsize_t i) { return static_cast<std::int64_t>(i); });
  write_constant<std::int32_t>(point_data, "body", particles, [&](hsize_t i) {
    const auto next =
        std::upper_bound(model.bodies.begin(), model.bodies.end(), static_cast<std::int64_t>(i),
                         [](std::int64_t number, const Body& body) { return number < body.first_particle; });
    return static_cast<std::int32_t>(next - model.bodies.begin()) - 1;
  });
  std::vector<std::string> names;
  for (const Body& body : model.bodies) names.push_back(body.name);
  Handle data(H5Dopen2(point_data, "body", H5P_DEFAULT), H5Dclose, "open dataset body");
  set_attribute(data, "names", names);
}

}  // namespace

Snapshots Snapshots::create(hid_t file, const Model& model) {
  Snapshots snapshots;
  snapshots.particles_ = static_cast<hsize_t>(model.particle_count());
  const Handle vtk = make_group(file, "VTKHDF");
  write_version(vtk);
  write_type(vtk);
  write_constant<std::int64_t>(vtk, "NumberOfPoints", 1, [&](hsize_t) { return model.particle_count(); });
  for (const char* name : topologies) write_topology(vtk, name, name == topologies[0] ? snapshots.particles_ : 0);
  snapshots.points_ = Dataset::create<double>(vtk, "Points", 3, chunk_for(snapshots.particles_));

  const Handle point_data = make_group(vtk, "PointData");
  write_identities(point_data, model);
  snapshots.position_ = vector_field(Field::position, model);
  snapshots.kinds_ = stored_fields(model);
  for (const RecordedField& field : snapshots.kinds_) {
    const auto components = stored_components(field);
    snapshots.fields_.push_back(
        Dataset::create<double>(point_data, field.name, components.size(), chunk_for(snapshots.particles_)));
    if (components.empty()) continue;
    set_attribute(snapshots.fields_.back().id(), "components",
                  std::vector<std::string>(components.begin(), components.end()));
  }

  snapshots.steps_ = make_group(vtk, "Steps");
  make_group(snapshots.steps_, "PointDataOffsets");
  for (const Offsets& offsets : offsets_of(model)) {
    snapshots.offsets_.push_back(
        Dataset::create<std::int64_t>(snapshots.steps_, offsets.name, offsets.components, steps_per_chunk));
    snapshots.advances_.push_back(offsets.advances);
  }
  snapshots.parts_ = Dataset::create<std::int64_t>(snapshots.steps_, "NumberOfParts", 0, steps_per_chunk);
  snapshots.times_ = Dataset::create<double>(snapshots.steps_, "Values", 0, steps_per_chunk);
  set_attribute(snapshots.steps_, "NSteps", std::int64_t{0});
  return snapshots;
}

Snapshots Snapshots::open(hid_t file, const Model& model) {
  constexpr auto ignore = Dataset::Checksums::ignore;
  Snapshots snapshots;
  snapshots.particles_ = static_cast<hsize_t>(model.particle_count());
  const Handle vtk = open_group(file, "VTKHDF");
  snapshots.points_ = Dataset::open(vtk, "Points", ignore);
  snapshots.position_ = vector_field(Field::position, model);
  snapshots.kinds_ = stored_fields(model);
  for (const RecordedField& field : snapshots.kinds_)
    snapshots.fields_.push_back(Dataset::open(vtk, "PointData/" + field.name, ignore));
  snapshots.steps_ = open_group(vtk, "Steps");
  for (const Offsets& offsets : offsets_of(model)) {
    snapshots.offsets_.push_back(Dataset::open(snapshots.steps_, offsets.name, ignore));
    snapshots.advances_.push_back(offsets.advances);
  }
  snapshots.parts_ = Dataset::open(snapshots.steps_, "NumberOfParts", ignore);
  snapshots.times_ = Dataset::open(snapshots.steps_, "Values", ignore);
  return snapshots;
}

hsize_t Snapshots::count() const {
  return std::min(times_.rows(), static_cast<hsize_t>(integer_attribute(steps_, "NSteps")));
}

void Snapshots::write_field(hsize_t index, Dataset& data, const RecordedField& field,
                            std::span<const double> values) {
  const auto stored = stored_components(field);
  const std::size_t width = std::max<std::size_t>(stored.size(), 1);
  std::vector<std::size_t> places = {0};
  if (!field.components.empty()) places.clear();
  for (std::string_view component : field.components)
    places.push_back(std::find(stored.begin(), stored.end(), component) - stored.begin());
  assert(values.size() == particles_ * places.size());
  std::vector<double> block;
  for (hsize_t first = 0; first < particles_; first += rows_per_chunk) {
    const hsize_t count = std::min<hsize_t>(rows_per_chunk, particles_ - first);
    block.assign(count * width, 0.0);
    for (hsize_t p = 0; p < count; ++p)
      for (std::size_t c = 0; c < places.size(); ++c)
        block[p * width + places[c]] = values[(first + p) * places.size() + c];
    data.write<double>(index * particles_ + first, block);
  }
}

void Snapshots::write_arrays(hsize_t index, const Snapshot& snapshot) {
  assert(snapshot.fields.size() + 1 == fields_.size());
  write_field(index, points_, position_, snapshot.position);
  write_field(index, fields_[0], kinds_[0], snapshot.velocity);
  for (std::size_t f = 1; f < fields_.size(); ++f)
    write_field(index, fields_[f], kinds_[f], snapshot.fields[f - 1]);
  for (std::size_t o = 0; o < offsets_.size(); ++o) {
    const std::vector<std::int64_t> row(std::max<hsize_t>(offsets_[o].components(), 1),
                                        advances_[o] ? static_cast<std::int64_t>(index * particles_) : 0);
    offsets_[o].write<std::int64_t>(index, row);
  }
  parts_.write<std::int64_t>(index, std::array{std::int64_t{1}});
}

void Snapshots::write_time(hsize_t index, double time) { times_.write<double>(index, std::array{time}); }

void Snapshots::write_count(hsize_t count) { set_attribute(steps_, "NSteps", static_cast<std::int64_t>(count)); }

void Snapshots::cut(hsize_t count, hsize_t file_bytes) {
  write_count(count);
  times_.cut<double>(count, file_bytes);
  parts_.cut<std::int64_t>(count, file_bytes);
  for (Dataset& offsets : offsets_) offsets.cut<std::int64_t>(count, file_bytes);
  for (Dataset& field : fields_) field.cut<double>(count * particles_, file_bytes);
  points_.cut<double>(count * particles_, file_bytes);
}

}  // namespace trajan::results
