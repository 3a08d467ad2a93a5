#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <iostream>

#include "client/commands/all.h"
#include "client/download.h"
#include "client/particle_picture.h"
#include "client/private_server.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

struct Render {
  std::string source;
  std::string time = "last";
  std::string picture;
  std::string field = "stress";
  RenderStyle style;
};

std::optional<double> parse_time(const std::string& text) {
  if (text == "last") return std::nullopt;
  double time = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw CommandError(ExitCode::usage, fmt::format("\"{}\" is not a time", text), "write a number or last");
  }
  return time;
}

/// The result file of a job: where the server keeps it if that is on this machine, otherwise downloaded.
fs::path result_of_job(const GlobalOptions& global, const std::string& job, const fs::path& folder) {
  Connection connection = connect(global);
  v1::GetJobRequest request;
  request.set_job_id(resolve_job(connection, job));
  const v1::Job described = connection.call(&v1::Jobs::Stub::GetJob, request);
  if (!described.has_result()) {
    throw CommandError(ExitCode::not_found, fmt::format("job {} has no result file yet", described.job_id()));
  }
  const fs::path here = described.result().path();
  std::error_code unreadable;
  if (!here.empty() && fs::is_regular_file(here, unreadable)) return here;
  return download(connection, described.job_id(), described.result().name(), folder, nullptr);
}

ExitCode render(const GlobalOptions& global, const Render& asked) {
  const std::optional<double> time = parse_time(asked.time);
  const TemporaryFolder folder;
  const bool is_file = fs::is_regular_file(asked.source);
  const fs::path file = is_file ? fs::path(asked.source) : result_of_job(global, asked.source, folder.path());
  const fs::path beside = is_file ? fs::path(asked.source).parent_path() : fs::path();
  const std::string stem = is_file ? "particles" : asked.source + "-particles";
  const fs::path picture =
      asked.picture.empty() ? beside / fmt::format("{}-{}.png", stem, asked.field) : fs::path(asked.picture);
  draw_particles(read_snapshot(file, asked.field, time), asked.style, picture);
  std::cout << picture.string() << '\n';
  return ExitCode::success;
}

}  // namespace

void declare_render(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Render>();
  app.add_option("source", asked->source, "A job's id, last, or a result.vtkhdf")->required();
  app.add_option("--field", asked->field,
                 "stress (von Mises), stress.xx, velocity (speed), velocity.x, displacement.y, damage, ...")
      ->capture_default_str();
  app.add_option("--time", asked->time, "Of the snapshot: the nearest to this time, or last")
      ->capture_default_str();
  app.add_option("--deformation", asked->style.deformation_scale,
                 "Draw displacements so many times as large; 0 draws the reference configuration")
      ->capture_default_str();
  app.add_option("--view", asked->style.view, "From where to look at a solid: x, y, z or oblique (default)");
  app.add_flag("--mirror", asked->style.mirrored, "Draw the other half of an axisymmetric scene too");
  app.add_option("-O,--picture", asked->picture, "The picture: .png, .svg or .pdf")->type_name("FILE");
  set_action(app, global, action, asked, render);
}

}  // namespace trajan::client
