#include "client/progress_display.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/terminal.h"

namespace trajan::client {
namespace {

double share_done(const v1::Progress& progress) {
  if (progress.end_time() <= 0) return 0;
  return std::clamp(progress.time() / progress.end_time(), 0.0, 1.0);
}

std::string bar(double share, int width) {
  const auto full = static_cast<std::size_t>(share * width);
  std::string text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i) text += i < full ? "█" : "░";
  return text;
}

}  // namespace

std::string state_name(v1::JobState state) {
  std::string name = v1::JobState_Name(state);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  return name;
}

std::string progress_line(const std::string& scene, const v1::Progress& progress, int width) {
  const double share = share_done(progress);
  std::string facts = fmt::format("{:3.0f} %", std::floor(share * 100));
  if (progress.has_remaining()) {
    const auto seconds = static_cast<double>(progress.remaining().seconds()) + 1e-9 * progress.remaining().nanos();
    facts += fmt::format("  {} left", duration_for_people(seconds));
  }
  // What matters less comes later, and goes first if there is no room.
  const std::string more[] = {
      fmt::format("t {:.4g}/{:.4g}", progress.time(), progress.end_time()),
      fmt::format("step {}/{}", count_for_people(static_cast<double>(progress.step())),
                  count_for_people(static_cast<double>(progress.total_steps()))),
      fmt::format("{} particles/s", count_for_people(progress.particle_steps_per_second())),
      fmt::format("energy balance {:.1e}", progress.energy_balance_error()),
  };
  constexpr int bar_width = 20;
  const std::string start = scene + "  ";
  auto room = width - 1 - static_cast<int>(start.size() + facts.size()) - bar_width - 1;
  for (const std::string& fact : more) {
    room -= static_cast<int>(fact.size()) + 2;
    if (room < 0) break;
    facts += "  " + fact;
  }
  return start + bar(share, bar_width) + " " + facts;
}

ProgressDisplay::ProgressDisplay(bool redraws) : redraws_(redraws) {}

ProgressDisplay::~ProgressDisplay() { clear(); }

void ProgressDisplay::clear() {
  if (bar_is_shown_) fmt::print(stderr, "\r\033[K");
  bar_is_shown_ = false;
}

void ProgressDisplay::line(const std::string& text) {
  clear();
  say(text);
}

void ProgressDisplay::enter(v1::JobState state) {
  if (state == state_) return;
  state_ = state;
  if (state == v1::QUEUED || state == v1::CANCELLING || (state == v1::RUNNING && !redraws_)) {
    line(fmt::format("{}: {}", scene_, state_name(state)));
  }
}

void ProgressDisplay::job(const v1::Job& job) {
  if (lost_) line("connected again");
  lost_ = false;
  scene_ = job.scene_name();
  told_ = job.last_sequence();
  enter(job.state());
  if (job.has_progress() && job.state() == v1::RUNNING) show(job.progress());
  if (has_ended(job.state())) clear();
}

void ProgressDisplay::event(const v1::Event& event) {
  const bool is_news = event.sequence() > told_;
  if (event.has_state() && is_news) enter(event.state());
  if (event.has_progress() && is_news) show(event.progress());
  if (event.kind_case() == v1::Event::kMessage) line(fmt::format("{}: {}", scene_, event.message()));
}

void ProgressDisplay::show(const v1::Progress& progress) {
  if (redraws_) {
    fmt::print(stderr, "\r{}\033[K", progress_line(scene_, progress, terminal_width()));
    std::fflush(stderr);
    bar_is_shown_ = true;
    return;
  }
  const int tenths = static_cast<int>(share_done(progress) * 10);
  if (tenths <= tenths_) return;
  tenths_ = tenths;
  say(fmt::format("{}: {:3d} %  step {}  time {:.6g} of {:.6g}", scene_, tenths * 10, progress.step(),
                  progress.time(), progress.end_time()));
}

void ProgressDisplay::connection_lost() {
  if (!lost_) line("connection lost, trying again ...");
  lost_ = true;
}

}  // namespace trajan::client
