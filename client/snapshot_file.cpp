#include "client/snapshot_file.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>

#include "client/exit_code.h"
#include "client/suggestion.h"

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
std::vector<Number> read_rows(hid_t file, const std::string& name, hsize_t first, hsize_t count,
                              std::size_t& components) {
  const Handle data(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle space(H5Dget_space(data), H5Sclose, name);
  hsize_t size[2] = {0, 1};
  if (H5Sget_simple_extent_ndims(space) > 2) throw CommandError(ExitCode::not_found, name + " is not a table");
  H5Sget_simple_extent_dims(space, size, nullptr);
  if (count == 0) count = size[0];
  if (first + count > size[0]) throw CommandError(ExitCode::not_found, name + " ends too early");
  components = size[1];
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

/// One value for each particle from the stored components: a component by its name, or the magnitude.
std::vector<double> pick(const std::vector<double>& stored, std::size_t components, const std::string& component) {
  static const std::vector<std::string> vector_names{"x", "y", "z"};
  static const std::vector<std::string> tensor_names{"xx", "yy", "zz", "xy", "yz", "xz"};
  constexpr std::size_t tensor_components = 6;
  const bool tensor = components == tensor_components;
  const std::vector<std::string>& names = tensor ? tensor_names : vector_names;
  const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), component) - names.begin());
  if (!component.empty() && place >= components) {
    throw CommandError(ExitCode::not_found, fmt::format("there is no component \"{}\"", component),
                       suggest(component, names, "the components are"));
  }
  std::vector<double> values;
  for (std::size_t i = 0; i + components <= stored.size(); i += components) {
    const double* row = &stored[i];
    values.push_back(!component.empty() ? row[place] : tensor ? von_mises(row) : norm(row, components));
  }
  return values;
}

std::vector<std::array<double, 2>> in_plane(const std::vector<double>& stored, std::size_t components) {
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i + components <= stored.size(); i += components)
    points.push_back({stored[i], stored[i + 1]});
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
  const std::string name = field.substr(0, field.find('.'));
  const std::string component = field.size() > name.size() ? field.substr(name.size() + 1) : "";
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw CommandError(ExitCode::not_found, fmt::format("the snapshots have no field \"{}\"", name),
                       suggest(name, names, "the fields are"));
  }
  std::size_t components = 0;
  ParticlePicture picture;
  const auto times = read_rows<double>(file, "VTKHDF/Steps/Values", 0, 0, components);
  const hsize_t step = nearest_step(times, time);
  picture.time = times[step];
  const auto particles =
      static_cast<hsize_t>(read_rows<std::int64_t>(file, "VTKHDF/NumberOfPoints", 0, 0, components).front());
  const auto rows = [&](const std::string& data) {
    return read_rows<double>(file, "VTKHDF/" + data, step * particles, particles, components);
  };
  const auto points = rows("Points");
  picture.position = in_plane(points, components);
  const auto values = rows("PointData/" + name);
  picture.values = pick(values, components, component);
  if (std::find(names.begin(), names.end(), "displacement") != names.end()) {
    const auto displacement = rows("PointData/displacement");
    picture.displacement = in_plane(displacement, components);
  }
  picture.units = read_text(file, "units");
  picture.scene_text = read_text(file, "scene");
  return picture;
}

}  // namespace trajan::client
