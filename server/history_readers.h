#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "solver/results/results.h"

namespace trajan {

/// A result file that is open for the streams of one job. HDF5 shares what it knows of a file between
/// all that open it in a process, also what has become stale; so there is one reader for each file, and
/// whoever finds it stale closes it for all.
class SharedReader {
 public:
  explicit SharedReader(std::filesystem::path directory) : directory_(std::move(directory)) {}

  /// Opens the file unless it is open. A file is repaired by every attempt at its job and replaced when the
  /// job ends: whoever had it open before does not see what came after. Throws as HistoryReader::open.
  results::HistoryReader& get(int attempt, bool ended) {
    if (attempt != attempt_ || ended != ended_) close();
    if (!reader_) reader_ = results::HistoryReader::open(directory_);
    attempt_ = attempt;
    ended_ = ended;
    return *reader_;
  }
  void close() { reader_.reset(); }

 private:
  const std::filesystem::path directory_;
  std::unique_ptr<results::HistoryReader> reader_;
  int attempt_ = 0;
  bool ended_ = false;
};

/// The open files by directory; each is closed with the last stream that uses it. One thread.
class HistoryReaders {
 public:
  std::shared_ptr<SharedReader> share(const std::filesystem::path& directory) {
    std::erase_if(readers_, [](const auto& entry) { return entry.second.expired(); });
    auto reader = readers_[directory].lock();
    if (!reader) readers_[directory] = reader = std::make_shared<SharedReader>(directory);
    return reader;
  }

 private:
  std::map<std::filesystem::path, std::weak_ptr<SharedReader>> readers_;
};

}  // namespace trajan
