#include "tests/service/result_files.h"

#include <hdf5.h>

#include <map>
#include <vector>

namespace trajan::test {

namespace {

/// Extents, then the raw bytes in the file's own type; but only the extents of tables with texts, which
/// are read as pointers.
std::string contents(hid_t dataset) {
  const hid_t space = H5Dget_space(dataset);
  const hid_t type = H5Dget_type(dataset);
  const auto points = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  std::string text;
  for (const hsize_t extent : extents) text += std::to_string(extent) + " ";
  const std::size_t head = text.size();
  if (H5Tget_class(type) != H5T_COMPOUND && H5Tis_variable_str(type) == 0) {
    text.resize(head + points * H5Tget_size(type));
    if (points > 0) H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data() + head);
  }
  H5Tclose(type);
  H5Sclose(space);
  return text;
}

herr_t collect(hid_t file, const char* name, const H5O_info_t* info, void* datasets) {
  if (info->type != H5O_TYPE_DATASET) return 0;
  const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
  static_cast<std::map<std::string, std::string>*>(datasets)->emplace(name, contents(dataset));
  H5Dclose(dataset);
  return 0;
}

std::map<std::string, std::string> datasets(const std::filesystem::path& path) {
  std::map<std::string, std::string> found;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file < 0) return found;
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_NATIVE, collect, &found, H5O_INFO_BASIC);
  H5Fclose(file);
  return found;
}

}  // namespace

std::string compare_datasets(const std::filesystem::path& left, const std::filesystem::path& right) {
  const auto a = datasets(left);
  const auto b = datasets(right);
  if (a.empty()) return "no datasets in " + left.string();
  if (a.size() != b.size()) return "not the same number of datasets";
  std::string difference;
  for (const auto& [name, bytes] : a) {
    const auto other = b.find(name);
    if (other == b.end() || other->second != bytes) difference += name + " differs\n";
  }
  return difference;
}

}  // namespace trajan::test
