#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "tests/unit/results/rehearsal.h"

namespace trajan::results {
namespace {

using namespace rehearsal;

/// What a child process says before it is killed.
struct Acknowledged {
  std::atomic<std::int64_t> rows = 0;
  std::atomic<std::int64_t> checkpoint = -1;
  std::atomic<std::int64_t> resumed_from = -1;
};

class SharedMemory {
 public:
  SharedMemory()
      : memory_(mmap(nullptr, sizeof(Acknowledged), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    new (memory_) Acknowledged;
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  ~SharedMemory() { munmap(memory_, sizeof(Acknowledged)); }
  Acknowledged* operator->() { return static_cast<Acknowledged*>(memory_); }

 private:
  void* memory_;
};

/// Runs `work` in a process of its own, which ends with its return value, or 99 and the message on stderr.
pid_t in_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child != 0) return child;
  int status = 99;
  try {
    status = work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  _exit(status);
}

int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

bool exited_with(int status, int code) { return WIFEXITED(status) && WEXITSTATUS(status) == code; }

/// Goes on where the directory's writer was stopped, telling what is acknowledged, to the end.
int acknowledge_run(const std::filesystem::path& directory, const Model& model, SharedMemory& shared) {
  const auto writer = ResultWriter::open(directory, model, provenance(), std::chrono::milliseconds(0));
  shared->resumed_from = writer->durable_rows() - 1;
  Plan plan;
  plan.after_sample = [&](std::int64_t) { shared->rows = writer->durable_rows(); };
  plan.after_checkpoint = [&](std::int64_t sample) { shared->checkpoint = sample; };
  record(*writer, model, plan);
  writer->finish(Status::succeeded, measure_values(model), {});
  return 0;
}

/// The file must show at least the acknowledged rows, and every row that it shows must be right.
void expect_rows(const std::filesystem::path& directory, const Model& model, std::int64_t acknowledged) {
  const auto reader = HistoryReader::open(directory);
  const std::int64_t rows = reader->rows();
  ASSERT_GE(rows, acknowledged);
  std::vector<std::size_t> all(reader->columns().size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = c;
  HistoryBlock block;
  reader->read(0, rows, all, block);
  ASSERT_EQ(block.rows(), rows);
  const std::vector<double> values = rows_of(block, all.size());
  for (std::int64_t row = 0; row < rows; ++row) {
    ASSERT_EQ(block.time[row], time_of(model, row));
    for (std::size_t c = 0; c < all.size(); ++c) ASSERT_EQ(values[row * all.size() + c], column_value(row, c));
  }
}

TEST(Crash, KillsAtAnyMomentLoseNothingThatWasAcknowledged) {
  const TemporaryDirectory undisturbed, disturbed;
  const Model model = make_model(250, 50);
  run_to_end(undisturbed.path(), model);
  SharedMemory shared;
  std::mt19937 random(7);
  int kills = 0;
  for (int status = -1; !exited_with(status, 0);) {
    ASSERT_LT(kills, 500);
    const std::int64_t checkpoint = shared->checkpoint;
    shared->resumed_from = checkpoint;
    shared->rows = 0;
    const pid_t child = in_child([&] { return acknowledge_run(disturbed.path(), model, shared); });
    // Later kills come later, so that the run ends even on a slow machine.
    std::this_thread::sleep_for(
        std::chrono::microseconds(std::uniform_int_distribution(0, 20000 + 500 * kills)(random)));
    kill(child, SIGKILL);
    status = wait_for(child);
    ASSERT_TRUE(WIFSIGNALED(status) || exited_with(status, 0));
    EXPECT_GE(shared->resumed_from, checkpoint) << "the run started anew although it had a checkpoint";
    if (WIFSIGNALED(status)) ++kills;
    if (shared->rows > 0) expect_rows(disturbed.path(), model, shared->rows);
    if (std::filesystem::exists(disturbed.path() / result_name)) break;
  }
  EXPECT_GT(kills, 10);
  EXPECT_EQ(difference(undisturbed.path() / result_name, disturbed.path() / result_name), "");
  EXPECT_TRUE(finished_run(disturbed.path(), provenance()));
}

TEST(Crash, AReaderInAnotherProcessSeesOnlyRightRowsWhileTheyAreWritten) {
  const TemporaryDirectory directory;
  // Over two ends of chunks, with a commit at least every 90 rows.
  const Model model = make_model(9'000, 100);
  const pid_t child = in_child([&] {
    Plan plan;
    plan.samples_per_checkpoint = 1'000;
    run_to_end(directory.path(), model, plan);
    return 0;
  });
  std::unique_ptr<HistoryReader> reader;
  const std::vector<std::size_t> selected = {0, 5, 8};
  std::int64_t seen = 0, looks = 0;
  int status = 0;
  bool ended = false;
  HistoryBlock block;
  while (!ended) {
    ended = waitpid(child, &status, WNOHANG) == child;
    try {
      if (!reader) reader = HistoryReader::open(directory.path());
    } catch (const std::runtime_error&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;  // not there yet
    }
    const std::int64_t rows = reader->rows();
    ASSERT_GE(rows, seen);
    reader->read(seen, rows - seen, selected, block);
    ASSERT_EQ(block.rows(), rows - seen);
    const std::vector<double> values = rows_of(block, selected.size());
    for (std::size_t i = 0; i < block.time.size(); ++i) {
      const auto row = static_cast<std::int64_t>(i) + seen;
      ASSERT_EQ(block.time[i], time_of(model, row));
      for (std::size_t s = 0; s < selected.size(); ++s)
        ASSERT_EQ(values[i * selected.size() + s], column_value(row, selected[s]));
    }
    if (rows > seen) ++looks;
    seen = rows;
  }
  EXPECT_TRUE(exited_with(status, 0));
  EXPECT_GT(looks, 5);
  EXPECT_EQ(HistoryReader::open(directory.path())->rows(), model.outputs.samples + 1);
}

/// Where a run was interrupted: a partial file and a checkpoint.
void interrupt(const std::filesystem::path& directory, const Model& model) {
  const auto writer = ResultWriter::open(directory, model, provenance());
  Plan plan;
  plan.stop_after_row = 47;
  record(*writer, model, plan);
}

void overwrite(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

class Damage : public testing::TestWithParam<const char*> {};

TEST_P(Damage, LeftoversThatAreCutEmptyOrForeignDoNotStopARun) {
  const TemporaryDirectory undisturbed;
  const Model model = make_model(60, 12);
  run_to_end(undisturbed.path(), model);
  constexpr int parts = 8;
  for (int part = 0; part <= parts; ++part) {
    const TemporaryDirectory damaged;
    interrupt(damaged.path(), model);
    const std::filesystem::path victim = damaged.path() / GetParam();
    if (part == parts)
      overwrite(victim, std::string(5000, 'x'));
    else
      std::filesystem::resize_file(victim, std::filesystem::file_size(victim) * part / parts);
    run_to_end(damaged.path(), model);
    EXPECT_EQ(difference(undisturbed.path() / result_name, damaged.path() / result_name), "") << part;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Damage, testing::Values(partial_name, checkpoint_name));

TEST(Crash, ADamagedCompleteFileIsComputedAgain) {
  const TemporaryDirectory undisturbed, damaged;
  const Model model = make_model(60, 12);
  run_to_end(undisturbed.path(), model);
  for (const std::uintmax_t kept : {0, 100, 30000}) {
    const std::filesystem::path path = run_to_end(damaged.path(), model).path;
    std::filesystem::resize_file(path, kept);
    EXPECT_FALSE(finished_run(damaged.path(), provenance()));
    run_to_end(damaged.path(), model);
    EXPECT_EQ(difference(undisturbed.path() / result_name, path), "");
  }
}

TEST(Crash, AFileOfAnotherSceneIsNotContinued) {
  const TemporaryDirectory directory;
  const Model model = make_model(60, 12);
  interrupt(directory.path(), model);
  Provenance other = provenance();
  other.scene_text += "# changed";
  const auto writer = ResultWriter::open(directory.path(), model, other);
  EXPECT_FALSE(writer->resume_point());
  EXPECT_EQ(writer->durable_rows(), 0);
}

/// A file system whose files may have at most this size.
void limit_file_size(rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(Crash, AFullDiskIsAnErrorAndTheFileGoesOnLater) {
  const TemporaryDirectory undisturbed;
  const Model model = make_model(200, 20);
  run_to_end(undisturbed.path(), model);
  const auto size = static_cast<rlim_t>(std::filesystem::file_size(undisturbed.path() / result_name));
  for (rlim_t part = 1; part < 8; ++part) {
    const TemporaryDirectory directory;
    SharedMemory shared;
    const pid_t child = in_child([&] {
      limit_file_size(size * part / 8);
      try {
        acknowledge_run(directory.path(), model, shared);
      } catch (const std::runtime_error& error) {
        const std::string text = error.what();
        const bool tells = text.find("File too large") != std::string::npos &&
                           text.find(directory.path().string()) != std::string::npos;
        if (!tells) std::fprintf(stderr, "%s\n", text.c_str());
        return tells ? 7 : 8;
      }
      return 0;
    });
    ASSERT_TRUE(exited_with(wait_for(child), 7)) << part;
    if (shared->rows > 0) expect_rows(directory.path(), model, shared->rows);
    run_to_end(directory.path(), model);
    EXPECT_EQ(difference(undisturbed.path() / result_name, directory.path() / result_name), "");
  }
}

}  // namespace
}  // namespace trajan::results
