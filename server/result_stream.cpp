#include "server/result_stream.h"

#include <openssl/evp.h>

#include <fstream>

#include "proto/crc32c.h"
#include "server/store_jobs.h"
#include "solver/results/digest.h"
#include "solver/results/results.h"

namespace trajan {

namespace {

/// SHA-256 of bytes that come piece by piece.
class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
  }
  void add(const std::string& bytes) { EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()); }
  /// Hexadecimal. Call once.
  std::string value() {
    unsigned char bytes[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    EVP_DigestFinal_ex(context_.get(), bytes, &size);
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += "0123456789abcdef"[bytes[i] >> 4];
      text += "0123456789abcdef"[bytes[i] & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

[[noreturn]] void throw_no_file(const std::string& job, const std::string& name) {
  throw ServiceError(grpc::StatusCode::NOT_FOUND, "NO_SUCH_FILE", "job " + job + " has no file \"" + name + "\"");
}

class ResultStream final : public Stream<v1::ReadResultResponse> {
 public:
  ResultStream(grpc::CallbackServerContext* context, v1::ReadResultRequest request, std::int64_t job,
               store::Store& store, Hub& hub, TaskQueue& queue, std::filesystem::path jobs_directory)
      : Stream(context, job, hub, queue),
        request_(std::move(request)),
        store_(store),
        jobs_directory_(std::move(jobs_directory)),
        offset_(request_.offset()) {}

 private:
  Next next(v1::ReadResultResponse& response) final {
    const bool first = !file_.is_open();
    if (first) {
      open();
      response.set_total_size(size_);
      response.set_sha256(sha256_);
    }
    if (offset_ == size_ && !first) {
      verify();
      return Next::finish;
    }
    read_chunk(response);
    return Next::write;
  }

  void open() {
    const v1::Job job =
        store_.read([&](store::Database& database) { return store::get_job(database, this->job()); });
    if (!store::has_ended(job.state())) {
      throw ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "NOT_ENDED",
                         "job " + job.job_id() + " has not ended");
    }
    directory_ = store::files_of(jobs_directory_, job);
    const std::string name = request_.name().empty() ? results::result_name : request_.name();
    if (name == results::result_name && job.has_result()) {
      size_ = job.result().size();
      sha256_ = job.result().sha256();
    } else if (name == results::xdmf_name && std::filesystem::exists(directory_ / name)) {
      size_ = static_cast<std::int64_t>(std::filesystem::file_size(directory_ / name));
      sha256_ = results::sha256_of_file(directory_ / name);
    } else {
      throw_no_file(job.job_id(), name);
    }
    if (offset_ < 0 || offset_ > size_) {
      throw ServiceError(grpc::StatusCode::OUT_OF_RANGE, "OFFSET",
                         name + " has " + std::to_string(size_) + " bytes");
    }
    file_.open(directory_ / name, std::ios::binary);
    file_.seekg(offset_);
  }

  void read_chunk(v1::ReadResultResponse& response) {
    constexpr std::int64_t most = 1 << 20;
    std::string& data = *response.mutable_data();
    data.resize(static_cast<std::size_t>(std::min(most, size_ - offset_)));
    if (!file_.read(data.data(), std::ssize(data))) throw_damaged();
    digest_.add(data);
    response.set_offset(offset_);
    response.set_crc32c(crc32c(data));
    offset_ += std::ssize(data);
  }

  void verify() {
    const bool whole = request_.offset() == 0 && !sha256_.empty();
    if (whole && digest_.value() != sha256_) throw_damaged();
  }

  [[noreturn]] void throw_damaged() {
    throw ServiceError(grpc::StatusCode::DATA_LOSS, "FILE_DAMAGED",
                       "the file of job " + std::to_string(job()) + " does not match its digest");
  }

  const v1::ReadResultRequest request_;
  store::Store& store_;
  const std::filesystem::path jobs_directory_;
  std::filesystem::path directory_;  ///< of the file
  std::ifstream file_;
  Digest digest_;
  std::int64_t offset_;
  std::int64_t size_ = 0;
  std::string sha256_;
};

}  // namespace

grpc::ServerWriteReactor<v1::ReadResultResponse>* read_result(grpc::CallbackServerContext* context,
                                                              const v1::ReadResultRequest& request,
                                                              store::Store& store, Hub& hub, TaskQueue& queue,
                                                              const std::filesystem::path& jobs_directory) {
  const std::int64_t job = store::job_number(request.job_id());
  return Stream<v1::ReadResultResponse>::start(
      std::make_shared<ResultStream>(context, request, job, store, hub, queue, jobs_directory));
}

}  // namespace trajan
