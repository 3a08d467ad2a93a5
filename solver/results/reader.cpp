#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "solver/results/handles.h"
#include "solver/results/histories.h"
#include "solver/results/results.h"

namespace trajan::results {

namespace {

class Reader : public HistoryReader {
 public:
  Reader(const std::filesystem::path& path, bool live)
      : path_(path),
        live_(live),
        file_(open_file(path, live ? Access::read_live : Access::read_closed)),
        histories_(Histories::open(file_, live ? Dataset::Checksums::ignore : Dataset::Checksums::verify)) {}

  const std::vector<std::string>& columns() const override { return histories_.columns(); }

  std::int64_t rows() override {
    return guarded([&] {
      if (live_) histories_.refresh_rows();
      return static_cast<std::int64_t>(histories_.rows());
    });
  }

  std::int64_t chunk_rows() const override { return static_cast<std::int64_t>(histories_.chunk_rows()); }

  void read(std::int64_t first, std::int64_t count, std::span<const std::size_t> selected,
            HistoryBlock& block) override {
    const std::int64_t available = rows();
    const std::int64_t begin = std::clamp<std::int64_t>(first, 0, available);
    const std::int64_t end = begin + std::min(count, available - begin);
    for (std::size_t column : selected)
      if (column >= columns().size()) throw std::out_of_range("there is no column " + std::to_string(column));
    guarded([&] {
      const auto from = static_cast<hsize_t>(begin), rows_read = static_cast<hsize_t>(end - begin);
      if (live_) histories_.refresh_values(from, rows_read, selected);
      histories_.read(from, rows_read, selected, block);
    });
  }

 private:
  template <typename Action>
  std::invoke_result_t<Action> guarded(const Action& action) {
    silence_hdf5();
    try {
      return action();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path_.string() + ": " + error.what());
    }
  }

  std::filesystem::path path_;
  bool live_;
  Handle file_;
  Histories histories_;
};

std::unique_ptr<HistoryReader> open_reader(const std::filesystem::path& path, bool live) {
  try {
    return std::make_unique<Reader>(path, live);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

}  // namespace

std::unique_ptr<HistoryReader> HistoryReader::open(const std::filesystem::path& directory) {
  silence_hdf5();
  const std::filesystem::path complete = directory / result_name;
  if (std::filesystem::exists(complete)) return open_reader(complete, false);
  try {
    return open_reader(directory / partial_name, true);
  } catch (const std::runtime_error&) {
    // It may have been completed and renamed just now.
    if (std::filesystem::exists(complete)) return open_reader(complete, false);
    throw;
  }
}

}  // namespace trajan::results
