#pragma once

#include <condition_variable>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "server/store_database.h"

namespace trajan::store {

/// The durable state: one SQLite file. Changes are made by one writer thread that puts all changes that
/// wait into one transaction (group commit); a change is reported done only when it is on disk. Reads
/// see what is committed. Any thread may call.
class Store {
 public:
  using Change = std::function<void(Database&)>;
  /// Gets what `Change` threw, or why the commit failed; null if the change is on disk.
  using Done = std::function<void(std::exception_ptr)>;

  /// Opens or creates the file and brings it to the present schema. Throws std::runtime_error.
  explicit Store(const std::filesystem::path& file);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Finishes what was committed and refuses what comes later. Called by the destructor too.
  void close();

  /// Returns at once. `done` runs on the writer thread after the commit and must not wait for another
  /// commit. A change that throws is undone alone.
  void commit(Change change, Done done);
  /// Waits for the commit; throws what `change` threw.
  void commit(Change change);

  template <class Read>
  auto read(Read&& read) {
    const std::lock_guard lock(reader_mutex_);
    return std::forward<Read>(read)(reader_);
  }

 private:
  struct Pending {
    Change change;
    Done done;
    std::exception_ptr error;
  };
  void write_until_closed();
  void write(std::vector<Pending>& batch);

  Database writer_;
  Database reader_;
  std::mutex reader_mutex_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<Pending> pending_;
  bool closed_ = false;
  std::thread thread_;
};

}  // namespace trajan::store
