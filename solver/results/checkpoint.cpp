#include "solver/results/checkpoint.h"

#include <algorithm>
#include <stdexcept>

#include "solver/results/durable.h"
#include "solver/results/handles.h"

namespace trajan::results {

namespace {

constexpr hsize_t values_per_chunk = 65536;

/// Arrays keep their order.
Handle make_arrays_group(hid_t file) {
  const std::string what = "make group arrays";
  Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, what);
  check(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), what);
  return {H5Gcreate2(file, "arrays", H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose, what};
}

template <typename T>
void write_array(hid_t group, const std::string& name, const std::vector<T>& values) {
  const std::string what = "write array " + name;
  const hsize_t size = values.size();
  Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, what);
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  if (size > 0) {
    const hsize_t chunk = std::min(size, values_per_chunk);
    check(H5Pset_chunk(properties, 1, &chunk), what);
    check(H5Pset_fletcher32(properties), what);
  }
  Handle dataset(H5Dcreate2(group, name.c_str(), stored_type<T>(), space, H5P_DEFAULT, properties, H5P_DEFAULT),
                 H5Dclose, what);
  if (size > 0) check(H5Dwrite(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
}

template <typename T>
std::vector<T> read_array(hid_t dataset, std::size_t size) {
  std::vector<T> values(size);
  if (size > 0)
    check(H5Dread(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read an array");
  return values;
}

Checkpoint::Array read_array(hid_t group, const std::string& name) {
  const std::string what = "read array " + name;
  Handle dataset(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, what);
  Handle space(H5Dget_space(dataset), H5Sclose, what);
  Handle type(H5Dget_type(dataset), H5Tclose, what);
  const auto size = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  if (H5Tget_class(type) == H5T_FLOAT) return {name, read_array<double>(dataset, size)};
  if (H5Tget_size(type) == sizeof(std::int64_t)) return {name, read_array<std::int64_t>(dataset, size)};
  return {name, read_array<std::int32_t>(dataset, size)};
}

std::vector<std::string> names_in_order(hid_t group) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, add, &names), "list the arrays");
  return names;
}

void write_file(const std::filesystem::path& path, const std::string& identity, const Checkpoint& checkpoint) {
  Handle file = open_file(path, Access::create);
  try {
    set_attribute(file, "identity", identity);
    set_attribute(file, "sample", checkpoint.sample);
    set_attribute(file, "step", checkpoint.step);
    set_attribute(file, "time", checkpoint.time);
    const Handle group = make_arrays_group(file);
    for (const Checkpoint::Array& array : checkpoint.arrays)
      std::visit([&](const auto& values) { write_array(group, array.name, values); }, array.values);
    check(H5Fflush(file, H5F_SCOPE_LOCAL), "write the file");
  } catch (...) {
    divert_to_memory(file_descriptor(file));
    throw;
  }
  file.close("close the file");
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const std::string& identity,
                      const Checkpoint& checkpoint) {
  std::filesystem::path unfinished = path;
  unfinished += ".part";
  try {
    write_file(unfinished, identity, checkpoint);
    publish(unfinished, path);
  } catch (const std::runtime_error& error) {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path, const std::string& identity) {
  try {
    const Handle file = open_file(path, Access::read_closed);
    if (text_attribute(file, "identity") != identity) return std::nullopt;
    Checkpoint checkpoint{
        integer_attribute(file, "sample"), integer_attribute(file, "step"), number_attribute(file, "time"), {}};
    const Handle group = open_group(file, "arrays");
    for (const std::string& name : names_in_order(group)) checkpoint.arrays.push_back(read_array(group, name));
    return checkpoint;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace trajan::results
