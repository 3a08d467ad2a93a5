#include "client/download.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "client/terminal.h"
#include "proto/crc32c.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot(const std::string& what, const fs::path& file) {
  throw CommandError(ExitCode::local_failure,
                     fmt::format("cannot {} {}: {}", what, file.string(), std::strerror(errno)));
}

/// The bytes that have come so far, in a file of their own.
class PartialFile {
 public:
  explicit PartialFile(fs::path path) : path_(std::move(path)) {
    file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file_ < 0) cannot("write", path_);
    size_ = static_cast<std::int64_t>(fs::file_size(path_));
  }
  ~PartialFile() { close(file_); }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  std::int64_t size() const { return size_; }
  void append(std::string_view data) {
    while (!data.empty()) {
      const ssize_t written = write(file_, data.data(), data.size());
      if (written < 0 && errno != EINTR) cannot("write", path_);
      if (written <= 0) continue;
      data.remove_prefix(static_cast<std::size_t>(written));
      size_ += written;
    }
  }
  void restart() {
    if (ftruncate(file_, 0) != 0) cannot("write", path_);
    size_ = 0;
  }

 private:
  fs::path path_;
  int file_ = -1;
  std::int64_t size_ = 0;
};

struct Announced {
  std::int64_t total_size = -1;
  std::string sha256;
};

void take(const v1::ReadResultResponse& response, PartialFile& partial, Announced& announced) {
  if (!response.sha256().empty()) announced = {response.total_size(), response.sha256()};
  const bool intact = crc32c(response.data()) == response.crc32c() && response.offset() == partial.size();
  if (!intact) throw CommandError(ExitCode::local_failure, "a part of the file came damaged", "fetch it again");
  partial.append(response.data());
}

/// One connection. False if it was lost and is worth another attempt.
bool read_once(Connection& connection, v1::ReadResultRequest request, PartialFile& partial, Announced& announced,
               InterruptWatch* interrupt) {
  grpc::ClientContext context;
  request.set_offset(partial.size());
  const auto reader = connection.jobs().ReadResult(&context, request);
  const InterruptReaction reaction(interrupt, [&context] { context.TryCancel(); });
  v1::ReadResultResponse response;
  const std::int64_t before = partial.size();
  while (reader->Read(&response)) take(response, partial, announced);
  const grpc::Status status = reader->Finish();
  if (interrupt != nullptr && interrupt->interrupted()) {
    throw CommandError(ExitCode::detached, "interrupted", "fetch it again to go on where it stopped");
  }
  if (status.error_code() == grpc::StatusCode::OUT_OF_RANGE && before > 0) {
    partial.restart();  // what was left here belongs to another file
    return false;
  }
  if (may_come_back(status) && partial.size() > before) return false;
  require_ok(status, context, connection.address());
  return true;
}

}  // namespace

std::string file_sha256(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) cannot("read", file);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr);
  std::vector<char> buffer(1 << 20);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    EVP_DigestUpdate(digest.get(), buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  unsigned char bytes[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  EVP_DigestFinal_ex(digest.get(), bytes, &size);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", bytes[i]);
  return text;
}

fs::path download(Connection& connection, const std::string& job_id, const std::string& name,
                  const fs::path& folder, InterruptWatch* interrupt) {
  std::error_code error;
  fs::create_directories(folder, error);
  const fs::path target = folder / name;
  const fs::path part = folder / fmt::format("{}.{}.part", name, job_id);
  v1::ReadResultRequest request;
  request.set_job_id(job_id);
  request.set_name(name);
  bool resumed = fs::exists(part);
  for (Announced announced;; resumed = false) {
    {
      PartialFile partial(part);
      if (resumed)
        say(fmt::format("going on with {} after {}", name, bytes_for_people(static_cast<double>(partial.size()))));
      for (Backoff backoff; !read_once(connection, request, partial, announced, interrupt); backoff.pause()) {
      }
    }
    if (file_sha256(part) == announced.sha256) break;
    fs::remove(part);
    if (!resumed)
      throw CommandError(ExitCode::local_failure, name + " came damaged: its SHA-256 is wrong", "fetch it again");
  }
  fs::rename(part, target, error);
  if (error)
    throw CommandError(ExitCode::local_failure,
                       fmt::format("cannot write {}: {}", target.string(), error.message()));
  return target;
}

}  // namespace trajan::client
