#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Small owning handles over the HDF5 C library. Every failure is a std::runtime_error that says what was
/// tried and why the library could not do it. The library's own printing of errors is off on any thread
/// that has called `silence_hdf5`; the entry points of this folder do so.
namespace trajan::results {

/// Owns one HDF5 identifier.
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Handle() = default;
  /// Throws if `id` is not valid; `what` ends the sentence "cannot …".
  Handle(hid_t id, Closer closer, const std::string& what);
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(other.closer_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(closer_, other.closer_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) closer_(id_);
  }
  operator hid_t() const { return id_; }
  /// Closes now. Throws where the destructor would be silent.
  void close(const std::string& what);

 private:
  hid_t id_ = H5I_INVALID_HID;
  Closer closer_ = nullptr;
};

void silence_hdf5();

/// Throws std::runtime_error "cannot <what>: <the library's reason>" if `status` is negative.
void check(herr_t status, const std::string& what);

/// How a file is opened.
enum class Access {
  create,       ///< anew, to be written
  repair,       ///< for writing, although its last writer did not close it
  read_closed,  ///< for reading, closed by its writer
  read_live     ///< for reading while its writer may be at work
};
Handle open_file(const std::filesystem::path& path, Access access);

/// The file descriptor below an open file. Valid as long as the file is open.
int file_descriptor(hid_t file);

Handle make_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);

/// The type of T in memory, and as stored in a file (little endian).
template <typename T>
hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
}
template <typename T>
hid_t stored_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
  if constexpr (std::is_same_v<T, std::int32_t>) return H5T_STD_I32LE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
}
/// UTF-8, any length.
Handle string_type();

/// Attributes. `set_` makes or overwrites one; overwriting works in single-writer-multiple-reader mode too.
void set_attribute(hid_t object, const std::string& name, const std::string& value);
void set_attribute(hid_t object, const std::string& name, const std::vector<std::string>& values);
void set_attribute(hid_t object, const std::string& name, std::int64_t value);
void set_attribute(hid_t object, const std::string& name, double value);
std::string text_attribute(hid_t object, const std::string& name);
std::int64_t integer_attribute(hid_t object, const std::string& name);
double number_attribute(hid_t object, const std::string& name);

}  // namespace trajan::results
