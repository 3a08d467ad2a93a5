#include "tests/unit/results/rehearsal.h"

#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "solver/model/validate.h"
#include "solver/results/handles.h"
#include "solver/results/measures_table.h"

namespace trajan::results::rehearsal {

TemporaryDirectory::TemporaryDirectory() {
  std::string pattern = (std::filesystem::temp_directory_path() / "trajan-results-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a temporary directory");
  path_ = pattern;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Model make_model(int samples, int snapshots, Dimension dimension) {
  Scene scene;
  scene.name = "rehearsal";
  scene.description = "two blocks";
  scene.units = "m, kg, s";
  const auto at = [dimension](double x, double y, double z) {
    return Vector{x, y, dimension == Dimension::solid ? z : 0.0};
  };
  scene.domain = {dimension, at(0, 0, 0), at(8, 4, 4), 0.5, {}, {}};
  scene.materials = {{"rubber", 1000, "linear_elastic", {{"youngs_modulus", 1e6}, {"poissons_ratio", 0.3}}}};
  scene.bodies = {{"left", "rubber", Box{at(1, 1, 1), at(3, 3, 3)}, 2, {}},
                  {"right", "rubber", Box{at(5, 1, 1), at(7, 3, 3)}, 2, {}}};
  scene.analysis.end_time = 2;
  scene.outputs.samples = samples;
  scene.outputs.snapshots = snapshots;
  scene.outputs.snapshot_fields = {Field::displacement, Field::stress, Field::deformation_gradient,
                                   Field::pressure};
  scene.outputs.probes = {
      {"tip", at(7, 2, 2), {Field::displacement, Field::stress}, "right"},
      {"middle", Region{Box{at(1, 1, 1), at(3, 3, 3)}}, {Field::velocity, Field::pressure}, "left"}};
  scene.measures = {{"deflection", "tip.displacement.y", FinalValue{}, 0, {}, "0.25", "a handbook, §1", 0.01},
                    {"peak_stress", "tip.stress.xx", ExtremeValue{}, 0, {}, "", "", {}}};
  return validate(scene);
}

Provenance provenance() { return {"name: \"rehearsal\"\n# größer\n", "1.2.3"}; }

double time_of(const Model& model, std::int64_t row) {
  return static_cast<double>(row) * model.end_time / static_cast<double>(model.outputs.samples);
}

double column_value(std::int64_t row, std::size_t column) {
  return std::sin(static_cast<double>(row) * 0.37 + static_cast<double>(column)) + static_cast<double>(row);
}

std::vector<double> rows_of(const HistoryBlock& block, std::size_t columns) {
  std::vector<double> values(block.time.size() * columns);
  block.copy_rows(0, block.rows(), values.data());
  return values;
}

double particle_value(std::int64_t row, std::int64_t particle, std::string_view what, std::size_t component) {
  return static_cast<double>(row) + 1e-3 * static_cast<double>(particle) + 10 * static_cast<double>(component) +
         1000 * static_cast<double>(what.size());
}

std::vector<MeasureValue> measure_values(const Model& model) {
  std::vector<MeasureValue> values;
  for (const Measure& measure : model.measures) {
    const double value = 0.2525;
    std::optional<double> error;
    if (measure.exact) error = value / *measure.exact - 1;
    values.push_back(
        {measure.name, measure.quantity, value, measure.exact, error, measure.tolerance, measure.source});
  }
  return values;
}

namespace {

std::vector<double> particle_array(const Model& model, std::int64_t row, std::string_view what,
                                   std::size_t components) {
  std::vector<double> values;
  for (std::int64_t p = 0; p < model.particle_count(); ++p)
    for (std::size_t c = 0; c < components; ++c) values.push_back(particle_value(row, p, what, c));
  return values;
}

Snapshot make_snapshot(const Model& model, std::int64_t row) {
  const std::size_t axes = vector_components(model.dimension).size();
  Snapshot snapshot{time_of(model, row),
                    particle_array(model, row, "position", axes),
                    particle_array(model, row, "velocity", axes),
                    {}};
  for (const RecordedField& field : model.outputs.snapshot_fields)
    snapshot.fields.push_back(particle_array(model, row, field.name, field.width()));
  return snapshot;
}

Checkpoint make_checkpoint(const Model& model, std::int64_t row) {
  std::vector<double> numbers(static_cast<std::size_t>(row) * 3);
  std::iota(numbers.begin(), numbers.end(), 0.5);
  return {row,
          10 * row,
          time_of(model, row),
          {{"velocity", numbers},
           {"order", std::vector<std::int64_t>{row, -1, 1LL << 40}},
           {"cells", std::vector<std::int32_t>{7}},
           {"nothing", std::vector<double>{}}}};
}

void require_equal(const Checkpoint& a, const Checkpoint& b) {
  const auto same_array = [](const Checkpoint::Array& x, const Checkpoint::Array& y) {
    return x.name == y.name && x.values == y.values;
  };
  if (a.sample != b.sample || a.step != b.step || a.time != b.time ||
      !std::equal(a.arrays.begin(), a.arrays.end(), b.arrays.begin(), b.arrays.end(), same_array))
    throw std::logic_error("the checkpoint came back different");
}

}  // namespace

void record(ResultWriter& writer, const Model& model, const Plan& plan) {
  const std::optional<Checkpoint> resumed = writer.resume_point();
  if (resumed) require_equal(*resumed, make_checkpoint(model, resumed->sample));
  const std::size_t columns = history_columns(model).size();
  std::vector<double> values(columns);
  for (std::int64_t row = resumed ? resumed->sample + 1 : 0; row <= model.outputs.samples; ++row) {
    for (std::size_t c = 0; c < columns; ++c) values[c] = column_value(row, c);
    writer.sample(row, time_of(model, row), values);
    const std::int64_t period = model.outputs.samples_per_snapshot;
    if (period > 0 && row % period == 0) writer.snapshot(row, make_snapshot(model, row));
    plan.after_sample(row);
    if (row % plan.samples_per_checkpoint == 0) {
      writer.checkpoint(make_checkpoint(model, row));
      plan.after_checkpoint(row);
    }
    if (row == plan.stop_after_row) return;
  }
}

FinishedFile run_to_end(const std::filesystem::path& directory, const Model& model, const Plan& plan) {
  const auto writer = ResultWriter::open(directory, model, provenance());
  record(*writer, model, plan);
  return writer->finish(Status::succeeded, measure_values(model), {});
}

namespace {

/// Paths of all datasets of plain numbers.
std::vector<std::string> number_datasets(hid_t file) {
  std::vector<std::string> paths;
  const auto add = [](hid_t root, const char* name, const H5O_info_t* info, void* list) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    const Handle dataset(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose, "open");
    const Handle type(H5Dget_type(dataset), H5Tclose, "type");
    if (H5Tget_class(type) != H5T_COMPOUND) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, add, &paths, H5O_INFO_BASIC), "visit");
  return paths;
}

struct Content {
  std::vector<hsize_t> size;
  std::vector<char> bytes;
  bool operator==(const Content&) const = default;
};

Content content(hid_t file, const std::string& path) {
  const Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path);
  const Handle space(H5Dget_space(dataset), H5Sclose, "space");
  const Handle type(H5Dget_type(dataset), H5Tclose, "type");
  Content result;
  result.size.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  check(H5Sget_simple_extent_dims(space, result.size.data(), nullptr), "size");
  result.bytes.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * H5Tget_size(type));
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.bytes.data()), "read " + path);
  return result;
}

bool same(const MeasureValue& a, const MeasureValue& b) {
  return a.name == b.name && a.quantity == b.quantity && a.value == b.value && a.exact == b.exact &&
         a.error == b.error && a.tolerance == b.tolerance && a.source == b.source;
}

}  // namespace

std::string difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  silence_hdf5();
  const Handle file_a = open_file(a, Access::read_closed), file_b = open_file(b, Access::read_closed);
  const std::vector<std::string> paths = number_datasets(file_a);
  if (paths != number_datasets(file_b)) return "the datasets' names";
  for (const std::string& path : paths)
    if (content(file_a, path) != content(file_b, path)) return path;
  const std::vector<MeasureValue> measures_a = read_measures(file_a), measures_b = read_measures(file_b);
  if (!std::equal(measures_a.begin(), measures_a.end(), measures_b.begin(), measures_b.end(), same))
    return "measures";
  return "";
}

}  // namespace trajan::results::rehearsal
