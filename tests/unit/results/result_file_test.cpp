#include <gtest/gtest.h>

#include <fstream>

#include "solver/results/digest.h"
#include "solver/results/handles.h"
#include "tests/unit/results/rehearsal.h"

namespace trajan::results {
namespace {

using namespace rehearsal;

std::vector<std::size_t> all_columns(const HistoryReader& reader) {
  std::vector<std::size_t> all(reader.columns().size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = c;
  return all;
}

TEST(Results, ThisHdf5LibraryMayBeCalledByManyThreads) {
  hbool_t safe = false;
  ASSERT_GE(H5is_library_threadsafe(&safe), 0);
  EXPECT_TRUE(safe);
}

/// Rows `first` … of these columns must be what was recorded, in this order.
void expect_columns(const HistoryBlock& block, const Model& model, std::int64_t first,
                    std::span<const std::size_t> columns) {
  const std::vector<double> values = rows_of(block, columns.size());
  for (std::int64_t row = 0; row < block.rows(); ++row) {
    ASSERT_EQ(block.time[row], time_of(model, first + row));
    for (std::size_t c = 0; c < columns.size(); ++c)
      ASSERT_EQ(values[row * columns.size() + c], column_value(first + row, columns[c])) << row << " " << c;
  }
}

TEST(Results, HistoriesComeBackAsTheyWereRecordedWhateverPartIsReadNext) {
  const TemporaryDirectory directory;
  const Model model = make_model(9'000, 0);  // two chunks and a part of one
  Plan plan;
  plan.samples_per_checkpoint = 10'000;
  run_to_end(directory.path(), model, plan);
  const auto reader = HistoryReader::open(directory.path());
  EXPECT_EQ(reader->columns(), history_columns(model));
  EXPECT_EQ(reader->rows(), 9'001);
  ASSERT_EQ(reader->chunk_rows(), 4096);
  const std::vector<std::size_t> all = all_columns(*reader);
  HistoryBlock block;
  struct Part {
    std::int64_t first, count, rows;
  };
  // All; within a chunk, on from there, over its end; back; the last row, beyond the end.
  for (const Part part : {Part{0, 10'000, 9'001},
                          {4'000, 50, 50},
                          {4'050, 46, 46},
                          {4'090, 4'200, 4'200},
                          {7, 1, 1},
                          {9'000, 10, 1},
                          {9'001, 10, 0},
                          {20'000, 10, 0}}) {
    reader->read(part.first, part.count, all, block);
    ASSERT_EQ(block.rows(), part.rows) << part.first;
    expect_columns(block, model, part.first, all);
  }
}

TEST(Results, SelectedColumnsComeInTheOrderOfTheSelection) {
  const TemporaryDirectory directory;
  const Model model = make_model(20, 0);
  run_to_end(directory.path(), model);
  const auto reader = HistoryReader::open(directory.path());
  HistoryBlock block;
  for (const std::vector<std::size_t>& selected : {std::vector<std::size_t>{6, 1, 9}, {1, 0}, {1, 2, 3}, {2}}) {
    reader->read(18, 10, selected, block);
    ASSERT_EQ(block.rows(), 3);
    expect_columns(block, model, 18, selected);
  }
}

TEST(Results, AHistoryWithAWrongBitIsNotRead) {
  const TemporaryDirectory directory;
  const Model model = make_model(100, 0);
  const FinishedFile finished = run_to_end(directory.path(), model);
  const double value = column_value(70, 3);
  std::string bytes;
  {
    std::ifstream file(finished.path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  const std::size_t place = bytes.find(std::string(reinterpret_cast<const char*>(&value), sizeof(value)));
  ASSERT_NE(place, std::string::npos);
  bytes[place] = static_cast<char>(bytes[place] ^ 1);
  std::ofstream(finished.path, std::ios::binary) << bytes;
  const auto reader = HistoryReader::open(directory.path());
  HistoryBlock block;
  const std::vector<std::size_t> damaged = {3}, whole = {9};
  EXPECT_NO_THROW(reader->read(0, 10, whole, block));
  try {
    reader->read(0, 10, damaged, block);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("checksum"), std::string::npos) << error.what();
  }
}

TEST(Results, AFinishedFileHasItsDigestAndLeavesNothingElse) {
  const TemporaryDirectory directory;
  const FinishedFile finished = run_to_end(directory.path(), make_model(20, 4));
  EXPECT_TRUE(finished.complete);
  EXPECT_EQ(finished.path, directory.path() / result_name);
  EXPECT_EQ(finished.size, static_cast<std::int64_t>(std::filesystem::file_size(finished.path)));
  EXPECT_EQ(finished.sha256, sha256_of_file(finished.path));
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(directory.path())) ++files;
  EXPECT_EQ(files, 1u);
}

TEST(Results, TheDigestIsThatOfTheStandardsExample) {
  // FIPS 180-2, appendix B.1.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Results, AFinishedRunIsFoundWithItsMeasures) {
  const TemporaryDirectory directory;
  const Model model = make_model(20, 4);
  EXPECT_FALSE(finished_run(directory.path(), provenance()));
  const FinishedFile finished = run_to_end(directory.path(), model);
  const std::optional<FinishedRun> found = finished_run(directory.path(), provenance());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, Status::succeeded);
  EXPECT_EQ(found->file.sha256, finished.sha256);
  ASSERT_EQ(found->measures.size(), model.measures.size());
  EXPECT_EQ(found->measures[0].source, "a handbook, §1");
  EXPECT_EQ(found->measures[0].error, measure_values(model)[0].error);
  EXPECT_FALSE(found->measures[1].exact);
  Provenance other = provenance();
  other.solver_version = "1.2.4";
  EXPECT_FALSE(finished_run(directory.path(), other));
}

TEST(Results, ADivergedRunKeepsItsRowsAndSaysWhy) {
  const TemporaryDirectory directory;
  const Model model = make_model(20, 4);
  {
    const auto writer = ResultWriter::open(directory.path(), model, provenance());
    Plan plan;
    plan.stop_after_row = 12;
    record(*writer, model, plan);
    const FinishedFile finished =
        writer->finish(Status::diverged, {}, Divergence{123, 0.5, 17, "det F <= 0", "a smaller step"});
    EXPECT_FALSE(finished.complete);
  }
  const std::optional<FinishedRun> found = finished_run(directory.path(), provenance());
  ASSERT_TRUE(found && found->divergence);
  EXPECT_EQ(found->divergence->step, 123);
  EXPECT_EQ(found->divergence->particle, 17);
  EXPECT_EQ(found->divergence->cause, "det F <= 0");
  EXPECT_EQ(found->divergence->remedy, "a smaller step");
  EXPECT_TRUE(found->measures.empty());
  EXPECT_EQ(HistoryReader::open(directory.path())->rows(), 13);
}

TEST(Results, TheWriterReadsBackWhatItRecordedAlsoAfterAResume) {
  const TemporaryDirectory directory;
  const Model model = make_model(20, 4);
  {
    const auto writer = ResultWriter::open(directory.path(), model, provenance());
    Plan plan;
    plan.stop_after_row = 17;
    record(*writer, model, plan);
    writer->warn({"energy", 12, 0.5, 3, {}, "it comes from nowhere", "a smaller step"});
    writer->suspend();
  }
  const auto writer = ResultWriter::open(directory.path(), model, provenance());
  EXPECT_EQ(writer->durable_rows(), 15);
  // What is said again, with another number, and what does not fit.
  writer->warn({"energy", 15, 0.75, 4, {}, "it comes from nowhere again", "a smaller step"});
  writer->warn({"locking", 0, 0, 0, {}, std::string(510, 'a') + "\u00fc and more", "a remedy"});
  ASSERT_EQ(writer->warnings().size(), 2u);
  record(*writer, model);
  std::vector<double> time, values;
  writer->histories(time, values);
  ASSERT_EQ(time.size(), 21u);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t columns = history_columns(model).size();
    ASSERT_EQ(values[i], column_value(static_cast<std::int64_t>(i / columns), i % columns));
  }
  writer->finish(Status::succeeded, {}, {});
  const std::vector<Warning> found = finished_run(directory.path(), provenance())->warnings;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].cause, "it comes from nowhere");
  EXPECT_EQ(found[0].step, 12);
  EXPECT_EQ(found[0].time, 0.5);
  EXPECT_EQ(found[0].particle, 3);
  EXPECT_EQ(found[0].remedy, "a smaller step");
  EXPECT_EQ(found[1].cause, std::string(510, 'a')) << "no half of a character";
}

TEST(Results, ASuspendedAndResumedRunEqualsAnUndisturbedOne) {
  const TemporaryDirectory undisturbed, disturbed;
  const Model model = make_model(60, 12);
  run_to_end(undisturbed.path(), model);
  for (std::int64_t stop : {0, 3, 7, 20, 21, 34, 35, 59}) {
    const auto writer = ResultWriter::open(disturbed.path(), model, provenance(), std::chrono::milliseconds(0));
    Plan plan;
    plan.stop_after_row = stop;
    record(*writer, model, plan);
    writer->suspend();
  }
  run_to_end(disturbed.path(), model);
  EXPECT_EQ(difference(undisturbed.path() / result_name, disturbed.path() / result_name), "");
}

TEST(Results, ARunThatEndsEarlierThanItsInterruptedPredecessorHasNoRowsOfIt) {
  const TemporaryDirectory directory;
  const Model model = make_model(60, 12);
  {
    const auto writer = ResultWriter::open(directory.path(), model, provenance());
    Plan plan;
    plan.samples_per_checkpoint = 30;
    plan.stop_after_row = 57;
    record(*writer, model, plan);
    writer->suspend();
  }
  {
    const auto writer = ResultWriter::open(directory.path(), model, provenance());
    Plan plan;
    plan.stop_after_row = 33;
    record(*writer, model, plan);
    writer->finish(Status::cancelled, {}, {});
  }
  const Handle file = open_file(directory.path() / result_name, Access::read_closed);
  EXPECT_EQ(HistoryReader::open(directory.path())->rows(), 34);
  EXPECT_EQ(integer_attribute(open_group(file, "VTKHDF/Steps"), "NSteps"), 7);  // samples 0, 5, …, 30
}

TEST(Results, SamplesAreCommittedTogetherAndAtTheLatestByACheckpoint) {
  const TemporaryDirectory directory;
  const Model model = make_model(20, 0);
  const auto writer = ResultWriter::open(directory.path(), model, provenance(), std::chrono::hours(1));
  Plan plan;
  plan.samples_per_checkpoint = 10;
  std::vector<std::int64_t> durable;
  plan.after_sample = [&](std::int64_t) { durable.push_back(writer->durable_rows()); };
  record(*writer, model, plan);
  EXPECT_EQ(durable[0], 0);
  for (std::int64_t row = 1; row <= 10; ++row) EXPECT_EQ(durable[row], 1) << row;
  for (std::int64_t row = 11; row <= 20; ++row) EXPECT_EQ(durable[row], 11) << row;
  EXPECT_EQ(writer->durable_rows(), 21);
}

TEST(Results, TwoWritersNeverShareADirectory) {
  const TemporaryDirectory directory;
  const Model model = make_model(20, 4);
  const auto writer = ResultWriter::open(directory.path(), model, provenance());
  EXPECT_THROW(ResultWriter::open(directory.path(), model, provenance()), std::runtime_error);
}

TEST(Results, ReadingWhereNothingIsSaysWhichFileIsMissing) {
  const TemporaryDirectory directory;
  try {
    HistoryReader::open(directory.path());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(partial_name), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

TEST(Results, TheXdmfFileNamesEverySnapshotsTime) {
  const TemporaryDirectory directory;
  const FinishedFile finished = run_to_end(directory.path(), make_model(20, 4));
  std::ifstream file(write_xdmf(finished.path));
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const char* time : {"0", "0.5", "1", "1.5", "2"})
    EXPECT_NE(text.find(std::string("<Time Value=\"").append(time).append("\"/>")), std::string::npos) << time;
}

}  // namespace
}  // namespace trajan::results
