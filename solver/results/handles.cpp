#include "solver/results/handles.h"

#include <stdexcept>

namespace trajan::results {

namespace {

/// The innermost entry of the library's error stack is the one that names the cause.
herr_t take_first(unsigned, const H5E_error2_t* entry, void* text) {
  auto& reason = *static_cast<std::string*>(text);
  if (reason.empty() && entry->desc) reason = entry->desc;
  return 0;
}

[[noreturn]] void fail(const std::string& what) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &reason);
  throw std::runtime_error("cannot " + what + ": " + (reason.empty() ? "no reason given" : reason));
}

/// Not locked: readers must be able to open while the writer writes, and DirectoryLock keeps a second
/// writer out.
Handle access_properties(Access access) {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file access properties");
  check(H5Pset_file_locking(properties, false, true), "turn file locking off");
  if (access == Access::read_closed || access == Access::read_live) {
    // Who reads takes chunks as they lie in the file (Dataset::rows_from), and there may be thousands of datasets.
    check(H5Pset_cache(properties, 0, 0, 0, 0), "go without a cache of chunks");
  }
  if (access == Access::create || access == Access::repair) {
    check(H5Pset_libver_bounds(properties, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "choose the file format");
    // An object left open would keep the file open: that is a bug, and it shall show.
    check(H5Pset_fclose_degree(properties, H5F_CLOSE_SEMI), "choose how files close");
  }
  if (access == Access::repair) {
    // As the library's own h5clear does: the writer left its mark, and a kill between the superblock and
    // the data it counts leaves a file that is shorter than the superblock says.
    const hbool_t yes = true;
    check(H5Pset(properties, "clear_status_flags", &yes), "ask for cleared status flags");
    check(H5Pset(properties, "skip_eof_check", &yes), "ask for no check of the size");
  }
  return properties;
}

template <typename Value>
void set_scalar(hid_t object, const std::string& name, hid_t stored, hid_t memory, const Value* value) {
  const std::string what = "write attribute " + name;
  const htri_t exists = H5Aexists(object, name.c_str());
  check(exists, what);
  Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  Handle attribute(exists ? H5Aopen(object, name.c_str(), H5P_DEFAULT)
                          : H5Acreate2(object, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose, what);
  check(H5Awrite(attribute, memory, value), what);
}

template <typename Value>
Value get_scalar(hid_t object, const std::string& name) {
  const std::string what = "read attribute " + name;
  Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, what);
  Value value{};
  check(H5Aread(attribute, memory_type<Value>(), &value), what);
  return value;
}

}  // namespace

Handle::Handle(hid_t id, Closer closer, const std::string& what) : id_(id), closer_(closer) {
  if (id < 0) fail(what);
}

void Handle::close(const std::string& what) {
  if (id_ < 0) return;
  // A file that cannot be closed stays open in the library, and its handle can be closed again.
  check(closer_(id_), what);
  id_ = H5I_INVALID_HID;
}

void silence_hdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

void check(herr_t status, const std::string& what) {
  if (status < 0) fail(what);
}

Handle open_file(const std::filesystem::path& path, Access access) {
  const Handle properties = access_properties(access);
  const std::string what = "open the file";
  switch (access) {
    case Access::create:
      return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, properties), H5Fclose, what};
    case Access::repair:
      return {H5Fopen(path.c_str(), H5F_ACC_RDWR, properties), H5Fclose, what};
    case Access::read_closed:
      return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, properties), H5Fclose, what};
    case Access::read_live:
      break;
  }
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, properties), H5Fclose, what};
}

int file_descriptor(hid_t file) {
  void* descriptor = nullptr;
  check(H5Fget_vfd_handle(file, H5P_DEFAULT, &descriptor), "find the file's descriptor");
  return *static_cast<int*>(descriptor);
}

Handle make_group(hid_t parent, const std::string& name) {
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "make group " + name};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "open group " + name};
}

Handle string_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make the type of texts");
  check(H5Tset_size(type, H5T_VARIABLE), "make the type of texts");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "make the type of texts");
  return type;
}

void set_attribute(hid_t object, const std::string& name, const std::string& value) {
  const Handle type = string_type();
  const char* text = value.c_str();
  set_scalar(object, name, type, type, &text);
}

void set_attribute(hid_t object, const std::string& name, const std::vector<std::string>& values) {
  const std::string what = "write attribute " + name;
  std::vector<const char*> texts;
  for (const std::string& value : values) texts.push_back(value.c_str());
  const hsize_t size = texts.size();
  const Handle type = string_type();
  Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, what);
  Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  check(H5Awrite(attribute, type, texts.data()), what);
}

void set_attribute(hid_t object, const std::string& name, std::int64_t value) {
  set_scalar(object, name, stored_type<std::int64_t>(), memory_type<std::int64_t>(), &value);
}

void set_attribute(hid_t object, const std::string& name, double value) {
  set_scalar(object, name, stored_type<double>(), memory_type<double>(), &value);
}

std::string text_attribute(hid_t object, const std::string& name) {
  const std::string what = "read attribute " + name;
  Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, what);
  const Handle type = string_type();
  char* text = nullptr;
  check(H5Aread(attribute, type, &text), what);
  std::string value = text ? text : "";
  H5free_memory(text);
  return value;
}

std::int64_t integer_attribute(hid_t object, const std::string& name) {
  return get_scalar<std::int64_t>(object, name);
}

double number_attribute(hid_t object, const std::string& name) { return get_scalar<double>(object, name); }

}  // namespace trajan::results
