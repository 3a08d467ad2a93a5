#include "client/snapshot_file.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>

#include "client/exit_code.h"
#include "proto/suggestion.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

/// An HDF5 object that is closed at the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id_ < 0) throw CommandError(ExitCode::not_found, "the result file has no " + what);
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Rows [first, first + count) of a dataset of numbers, row-major; all of them if count is 0.
template <typename Number>
std::vector<Number> read_rows(hid_t file, const std::string& name, hsize_t first, hsize_t count) {
  const Handle data(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle space(H5Dget_space(data), H5Sclose, name);
  hsize_t size[2] = {0, 1};
  if (H5Sget_simple_extent_ndims(space) > 2) throw CommandError(ExitCode::not_found, name + " is not a table");
  H5Sget_simple_extent_dims(space, size, nullptr);
  if (count == 0) count = size[0];
  if (first + count > size[0]) throw CommandError(ExitCode::not_found, name + " ends too early");
  const hsize_t start[2] = {first, 0};
  const hsize_t block[2] = {count, size[1]};
  const Handle memory(H5Screate_simple(2, block, nullptr), H5Sclose, name);
  std::vector<Number> values(count * size[1]);
  const hid_t type = std::is_same_v<Number, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
  if (count == 0) return values;
  H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, block, nullptr);
  if (H5Dread(data, type, memory, space, H5P_DEFAULT, values.data()) < 0) {
    throw CommandError(ExitCode::local_failure, name + " of the result file is damaged");
  }
  return values;
}

std::string read_text(hid_t file, const char* name) {
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name);
  if (H5Tis_variable_str(type) <= 0) return {};
  char* text = nullptr;
  if (H5Aread(attribute, type, &text) < 0 || text == nullptr) return {};
  std::string copy(text);
  H5free_memory(text);
  return copy;
}

/// The names of a field's components; none: it is a number.
std::vector<std::string> component_names(hid_t file, const std::string& data) {
  if (H5Aexists_by_name(file, data.c_str(), "components", H5P_DEFAULT) <= 0) return {};
  const Handle attribute(H5Aopen_by_name(file, data.c_str(), "components", H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         data);
  const Handle type(H5Aget_type(attribute), H5Tclose, data);
  const Handle space(H5Aget_space(attribute), H5Sclose, data);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (H5Tis_variable_str(type) <= 0 || count <= 0) return {};
  std::vector<char*> texts(static_cast<std::size_t>(count));
  if (H5Aread(attribute, type, texts.data()) < 0) return {};
  std::vector<std::string> names(texts.begin(), texts.end());
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, texts.data());
  return names;
}

std::vector<std::string> field_names(hid_t file) {
  const Handle group(H5Gopen2(file, "VTKHDF/PointData", H5P_DEFAULT), H5Gclose, "snapshots");
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
  return names;
}

/// The von Mises stress of a tensor xx, yy, zz, xy, yz, xz.
double von_mises(const double* s) {
  const double normal =
      (s[0] - s[1]) * (s[0] - s[1]) + (s[1] - s[2]) * (s[1] - s[2]) + (s[2] - s[0]) * (s[2] - s[0]);
  return std::sqrt(normal / 2 + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

double norm(const double* v, std::size_t components) {
  double sum = 0;
  for (std::size_t i = 0; i < components; ++i) sum += v[i] * v[i];
  return std::sqrt(sum);
}

/// A field and, if one was asked for, its component.
struct FieldPart {
  std::string field;
  std::string component;
};

FieldPart parse_field(const std::string& text) {
  const std::size_t dot = text.find('.');
  return {text.substr(0, dot), dot == std::string::npos ? "" : text.substr(dot + 1)};
}

std::string label_of(const FieldPart& part, std::size_t components) {
  if (!part.component.empty()) return part.field + "." + part.component;
  if (part.field == "stress") return "von Mises stress";
  if (part.field == "velocity") return "speed";
  std::string name = part.field;
  std::replace(name.begin(), name.end(), '_', ' ');
  return components == 1 ? name : "magnitude of " + name;
}

/// One value for each particle from the stored components: a component by its name, or the magnitude.
std::vector<double> pick(const std::vector<double>& stored, const std::vector<std::string>& components,
                         const FieldPart& part) {
  const auto place = static_cast<std::size_t>(std::find(components.begin(), components.end(), part.component) -
                                              components.begin());
  if (!part.component.empty() && place == components.size()) {
    throw CommandError(
        ExitCode::not_found, fmt::format("{} has no component \"{}\"", part.field, part.component),
        components.empty() ? "it is a single number" : suggest(part.component, components, "the components are"));
  }
  const std::size_t width = std::max<std::size_t>(components.size(), 1);
  std::vector<double> values;
  for (std::size_t i = 0; i + width <= stored.size(); i += width) {
    const double* row = &stored[i];
    values.push_back(!part.component.empty()  ? row[place]
                     : part.field == "stress" ? von_mises(row)
                     : width == 1             ? *row
                                              : norm(row, width));
  }
  return values;
}

std::vector<Point> points_of(const std::vector<double>& stored) {
  std::vector<Point> points;
  for (std::size_t i = 0; i + 3 <= stored.size(); i += 3)
    points.push_back({stored[i], stored[i + 1], stored[i + 2]});
  return points;
}

hsize_t nearest_step(const std::vector<double>& times, std::optional<double> time) {
  if (times.empty()) {
    throw CommandError(ExitCode::not_found, "the result file has no snapshots",
                       "ask for some: outputs { snapshots: 10 }");
  }
  if (!time) return times.size() - 1;
  const auto nearest = std::min_element(
      times.begin(), times.end(), [&](double a, double b) { return std::abs(a - *time) < std::abs(b - *time); });
  return static_cast<hsize_t>(nearest - times.begin());
}

}  // namespace

ParticlePicture read_snapshot(const fs::path& path, const std::string& field, std::optional<double> time) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are told by exceptions
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                    "valid HDF5 in " + path.string());
  const std::vector<std::string> names = field_names(file);
  const FieldPart part = parse_field(field);
  if (std::find(names.begin(), names.end(), part.field) == names.end()) {
    throw CommandError(ExitCode::not_found, fmt::format("the snapshots have no field \"{}\"", part.field),
                       suggest(part.field, names, "the fields are"));
  }
  ParticlePicture picture;
  const auto times = read_rows<double>(file, "VTKHDF/Steps/Values", 0, 0);
  const hsize_t step = nearest_step(times, time);
  const auto particles =
      static_cast<hsize_t>(read_rows<std::int64_t>(file, "VTKHDF/NumberOfPoints", 0, 0).front());
  const auto rows = [&](const std::string& data, hsize_t first) {
    return read_rows<double>(file, "VTKHDF/" + data, first, particles);
  };
  // What does not change is stored once.
  const bool constant = part.field == "body" || part.field == "particle_number";
  const auto components = component_names(file, "VTKHDF/PointData/" + part.field);
  picture.time = times[step];
  picture.dimension = read_text(file, "dimension");
  picture.position = points_of(rows("Points", step * particles));
  picture.values = pick(rows("PointData/" + part.field, constant ? 0 : step * particles), components, part);
  picture.field = field;
  picture.label = label_of(part, std::max<std::size_t>(components.size(), 1));
  if (std::find(names.begin(), names.end(), "displacement") != names.end())
    picture.displacement = points_of(rows("PointData/displacement", step * particles));
  picture.units = read_text(file, "units");
  return picture;
}

}  // namespace trajan::client
