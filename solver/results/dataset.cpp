#include "solver/results/dataset.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "solver/results/fletcher32.h"

namespace trajan::results {

namespace {

/// Made once: there may be thousands of datasets.
hid_t transfer_properties(Dataset::Checksums checksums) {
  static const hid_t ignoring = [] {
    const hid_t properties = H5Pcreate(H5P_DATASET_XFER);
    check(H5Pset_edc_check(properties, H5Z_DISABLE_EDC), "go without checksums");
    return properties;
  }();
  return checksums == Dataset::Checksums::verify ? H5P_DEFAULT : ignoring;
}

}  // namespace

Dataset Dataset::create(hid_t parent, const std::string& name, hid_t type, hsize_t components,
                        hsize_t chunk_rows) {
  const std::string what = "make dataset " + name;
  const int rank = components ? 2 : 1;
  const std::array<hsize_t, 2> size = {0, components}, largest = {H5S_UNLIMITED, components},
                               chunk = {chunk_rows, components};
  Handle space(H5Screate_simple(rank, size.data(), largest.data()), H5Sclose, what);
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  check(H5Pset_chunk(properties, rank, chunk.data()), what);
  check(H5Pset_fletcher32(properties), what);
  Dataset result;
  result.name_ = name;
  result.dataset_ =
      Handle(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose, what);
  result.components_ = components;
  result.chunk_rows_ = chunk_rows;
  return result;
}

Dataset Dataset::open(hid_t parent, const std::string& name, Checksums checksums) {
  const std::string what = "open dataset " + name;
  Dataset result;
  result.name_ = name;
  result.dataset_ = Handle(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, what);
  result.checksums_ = checksums;
  Handle space(H5Dget_space(result.dataset_), H5Sclose, what);
  Handle properties(H5Dget_create_plist(result.dataset_), H5Pclose, what);
  std::array<hsize_t, 2> size{}, chunk{};
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1 || rank > 2 || H5Pget_layout(properties) != H5D_CHUNKED)
    throw std::runtime_error("cannot " + what + ": it is not a chunked table");
  check(H5Sget_simple_extent_dims(space, size.data(), nullptr), what);
  check(H5Pget_chunk(properties, rank, chunk.data()), what);
  result.components_ = rank == 2 ? size[1] : 0;
  result.chunk_rows_ = chunk[0];
  return result;
}

hsize_t Dataset::rows() const {
  std::array<hsize_t, 2> size{};
  Handle space(H5Dget_space(dataset_), H5Sclose, "ask for the size of " + name_);
  check(H5Sget_simple_extent_dims(space, size.data(), nullptr), "ask for the size of " + name_);
  return size[0];
}

void Dataset::refresh() { check(H5Drefresh(dataset_), "refresh " + name_); }

void Dataset::require_rows(hsize_t needed, hsize_t file_bytes) const {
  if (rows() < needed)
    throw std::runtime_error("cannot keep " + std::to_string(needed) + " rows of " + name_ + ": it has " +
                             std::to_string(rows()));
  for (hsize_t row = 0; row < needed; row += chunk_rows_) {
    const std::array<hsize_t, 2> place = {row, 0};
    unsigned skipped_filters = 0;
    haddr_t address = HADDR_UNDEF;
    hsize_t size = 0;
    check(H5Dget_chunk_info_by_coord(dataset_, place.data(), &skipped_filters, &address, &size),
          "find the rows of " + name_);
    if (address == HADDR_UNDEF || address + size > file_bytes)
      throw std::runtime_error("cannot keep the rows of " + name_ + ": the file was cut off");
  }
}

void Dataset::resize(hsize_t rows) {
  const std::array<hsize_t, 2> size = {rows, components_};
  check(H5Dset_extent(dataset_, size.data()), "resize " + name_);
}

Handle Dataset::select(hsize_t first, hsize_t count) const {
  Handle space(H5Dget_space(dataset_), H5Sclose, "select rows of " + name_);
  const std::array<hsize_t, 2> start = {first, 0}, size = {count, components_};
  check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
        "select rows of " + name_);
  return space;
}

Handle Dataset::memory_space(hsize_t count) const {
  const std::array<hsize_t, 2> size = {count, components_};
  return {H5Screate_simple(components_ ? 2 : 1, size.data(), nullptr), H5Sclose, "select rows of " + name_};
}

void Dataset::write(hsize_t first, hsize_t count, hid_t type, const void* values) {
  if (count == 0) return;
  held_ = {};
  if (rows() < first + count) resize(first + count);
  check(
      H5Dwrite(dataset_, type, memory_space(count), select(first, count), transfer_properties(checksums_), values),
      "write " + name_);
}

void Dataset::read(hsize_t first, hsize_t count, hid_t type, void* values) const {
  if (count == 0) return;
  check(
      H5Dread(dataset_, type, memory_space(count), select(first, count), transfer_properties(checksums_), values),
      "read " + name_);
}

std::span<const double> Dataset::rows_from(hsize_t first, hsize_t end, hsize_t committed) {
  const hsize_t chunk_start = first / chunk_rows_ * chunk_rows_;
  end = std::min(end, chunk_start + chunk_rows_);
  if (!holds(first, end)) hold_chunk(chunk_start, committed);
  return std::span(held_.values).subspan((first - held_.first) * width(), (end - first) * width());
}

void Dataset::hold_chunk(hsize_t first, hsize_t committed) {
  static_assert(std::endian::native == std::endian::little, "as in the file");
  const std::string what = "read rows of " + name_;
  const std::size_t numbers = chunk_rows_ * width();
  const std::array<hsize_t, 2> place = {first, 0};
  hsize_t bytes = 0;
  std::uint32_t skipped_filters = 0, checksum = 0;
  held_.first = held_.end = 0;
  held_.values.resize(numbers + 1);
  check(H5Dget_chunk_storage_size(dataset_, place.data(), &bytes), what);
  if (bytes != numbers * sizeof(double) + sizeof(checksum))
    throw std::runtime_error("cannot " + what + ": " + std::to_string(bytes) +
                             " bytes are no chunk with its checksum");
  check(H5Dread_chunk(dataset_, H5P_DEFAULT, place.data(), &skipped_filters, held_.values.data()), what);
  std::memcpy(&checksum, &held_.values[numbers], sizeof(checksum));
  if (checksums_ == Checksums::verify &&
      fletcher32(std::as_bytes(std::span(held_.values).first(numbers))) != checksum)
    throw std::runtime_error("cannot " + what + ": their checksum is wrong");
  held_.first = first;
  held_.end = std::min(committed, first + chunk_rows_);
}

}  // namespace trajan::results
