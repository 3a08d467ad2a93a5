#include "server/measure.h"

#include <google/protobuf/util/time_util.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <fstream>

#include "server/recorded_run.h"
#include "server/trial.h"
#include "solver/cost/measure_rates.h"
#include "solver/cost/run_time.h"
#include "solver/cost/sample_scenes.h"
#include "solver/model/validate.h"

namespace trajan::measuring {

namespace {

constexpr double seconds_for_rates = 6;
constexpr int courtesy = 10;  ///< of nice(2): a tenth of a core where others want it

/// Seconds that this thread has waited for a processor so far, being ready to run (proc(5), schedstat); 0 if the
/// system does not tell.
double delayed_seconds() {
  std::ifstream file("/proc/thread-self/schedstat");
  double running = 0, delayed = 0;
  file >> running >> delayed;
  return 1e-9 * delayed;
}

/// Seconds of wall time as on a machine that has a processor free, and of processor time, and bytes.
struct Spent {
  double wall = 0, core = 0, bytes = 0;
  Spent operator-(const Spent& other) const { return {wall - other.wall, core - other.core, bytes - other.bytes}; }
  Spent operator*(double factor) const { return {wall * factor, core * factor, bytes * factor}; }
  Spent operator/(double count) const { return *this * (1 / count); }
};

class Recording {
 public:
  Recording(const std::filesystem::path& directory, v1::Calibration& calibration)
      : directory_(directory), calibration_(calibration) {}

  /// One after the other, what is known already being subtracted.
  void measure() {
    const Spent plain = best(scene(1, 1, 1));
    keep("run", plain);
    keep("row", (best(scene(1, most_rows, 1)) - plain) / most_rows);
    const Spent frame = per_frame(1);
    keep("snapshot", frame);
    const Model model = validate(scene(side, 1, 1));
    const double bytes = snapshot_bytes(model);
    const Spent frame_byte = (per_frame(side) - frame) / bytes;
    keep("snapshot_byte", frame_byte);
    const Spent large = best(scene(side, 1, 1)) - plain - frame_byte * (2 * bytes);
    keep("particle", large / static_cast<double>(model.particle_count()));
    keep("running", {0, 0, large.bytes + plain.bytes - array_bytes(model, plan(model))});
  }

 private:
  static constexpr int many = 8, most_rows = 20000, side = 64;

  static Scene scene(int cells, int samples, int snapshots) {
    Scene scene = sample_block(Dimension::plane_strain, *find_material_kind("linear_elastic"), cells, 2);
    scene.analysis.end_time = 1e-3 * samples;
    scene.outputs.samples = samples;
    scene.outputs.snapshots = snapshots;
    return scene;
  }

  /// The least of three: what disturbs only delays. The first of all fills caches and free lists.
  Spent best(const Scene& scene) const {
    Spent best;
    for (int i = 0; i < 3; ++i) {
      const double delayed = delayed_seconds();
      const v1::Cost cost = record_run(scene, directory_ / "run", 1, {}).cost;
      const double wall = cost.wall_seconds() - (delayed_seconds() - delayed);
      if (i == 0 || wall < best.wall) best = {wall, cost.core_seconds(), static_cast<double>(cost.memory_bytes())};
    }
    return best;
  }

  Spent per_frame(int cells) const {
    Spent frame = (best(scene(cells, many, many)) - best(scene(cells, many, 1))) / (many - 1);
    frame.bytes = 0;
    return frame;
  }

  void keep(const char* name, const Spent& spent) {
    (*calibration_.mutable_seconds())[recording_rate(name)] = std::max(spent.wall, 0.0);
    (*calibration_.mutable_seconds())[processing_rate(name)] = std::max(spent.core, 0.0);
    (*calibration_.mutable_bytes())[recording_rate(name)] = std::max(spent.bytes, 0.0);
  }

  const std::filesystem::path& directory_;
  v1::Calibration& calibration_;
};

/// What nobody waits for any more ends with the server.
void end_with_the_server() { prctl(PR_SET_PDEATHSIG, SIGKILL); }

int leave(const std::filesystem::path& directory, const google::protobuf::Message& answer) {
  std::ofstream file(directory / answer_file, std::ios::binary);
  return answer.SerializeToOstream(&file) && file.flush() ? 0 : 1;
}

}  // namespace

int calibrate(const std::filesystem::path& directory) {
  end_with_the_server();
  [[maybe_unused]] const int priority = nice(courtesy);
  const RunCost cost(1);
  v1::Calibration calibration;
  Recording(directory, calibration).measure();
  for (const auto& [name, seconds] : measure_rates(seconds_for_rates))
    (*calibration.mutable_seconds())[name] = seconds;
  const v1::Cost spent = cost.so_far();
  calibration.set_machine(spent.machine());
  calibration.set_core_seconds(spent.core_seconds());
  calibration.set_solver_version(TRAJAN_VERSION);
  *calibration.mutable_measured() = google::protobuf::util::TimeUtil::GetCurrentTime();
  return leave(directory, calibration);
}

int try_scene(const std::filesystem::path& directory, double seconds, int threads) {
  end_with_the_server();
  v1::Scene scene;
  std::ifstream file(directory / question_file, std::ios::binary);
  if (!scene.ParseFromIstream(&file)) return 1;
  return leave(directory, trajan::try_scene(scene, directory / "run", seconds, threads));
}

}  // namespace trajan::measuring
