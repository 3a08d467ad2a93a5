#include "tests/stability/extremes.h"

#include <algorithm>
#include <cmath>

#include "solver/model/names.h"

namespace trajan::stability {

bool Attempt::says_why() const {
  if (!model) return !diagnosis.empty();
  const bool seeks_equilibrium = std::holds_alternative<QuasiStatic>(model->analysis);
  const auto says = [&](const auto& what) {
    const bool has_place = seeks_equilibrium ? what.cause.find("body \"") != std::string::npos
                                             : what.particle >= 0 && what.particle < model->particle_count();
    return what.step >= 0 && has_place && !what.cause.empty() && !what.remedy.empty();
  };
  return result.divergence ? says(*result.divergence)
                           : !result.warnings.empty() && std::ranges::all_of(result.warnings, says);
}

std::vector<double> Attempt::history(const std::string& column) const {
  const std::size_t index = test::column(*model, column);
  std::vector<double> values;
  for (std::size_t row = 0; row < memory.rows.size(); ++row) {
    const auto spoils = [&](const Warning& warning) {
      return warning.time > 0 && memory.times[row] >= warning.time;
    };
    const bool doubtful = std::ranges::any_of(result.warnings, spoils);
    if (row == 0 || !doubtful) values.push_back(memory.rows[row][index]);
  }
  return values;
}

Attempt attempt(const Scene& scene, const ModelChange& change) {
  Attempt attempt;
  try {
    attempt.model = validate(scene);
  } catch (const InvalidScene& invalid) {
    attempt.diagnosis = invalid.what();
    return attempt;
  }
  if (change) change(*attempt.model);
  attempt.result = run(*attempt.model, {}, attempt.memory, nullptr);
  const auto tell = [&](const auto& what) {
    if (!attempt.diagnosis.empty()) attempt.diagnosis += "; ";
    attempt.diagnosis += "at time " + number_text(what.time) + ": " + what.cause + "; " + what.remedy;
  };
  for (const Warning& warning : attempt.result.warnings) tell(warning);
  if (attempt.result.divergence) tell(*attempt.result.divergence);
  return attempt;
}

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::warned:
      return "warned";
    case Verdict::stopped:
      return "stopped";
    case Verdict::refused:
      return "refused";
    case Verdict::wrong:
      break;
  }
  return "WRONG";
}

Row judge(const Extreme& extreme) {
  const Attempt tried = attempt(extreme.scene, extreme.change);
  Row row;
  row.diagnosis = tried.diagnosis;
  const bool doubtful = !tried.finished() || !tried.result.warnings.empty();
  if (doubtful && (!tried.says_why() || row.diagnosis.find(extreme.says) == std::string::npos)) return row;
  if (!tried.finished()) {
    const bool expected = tried.model ? extreme.may_stop
                                      : !extreme.refused_for.empty() &&
                                            tried.diagnosis.find(extreme.refused_for) != std::string::npos;
    if (expected) row.verdict = tried.model ? Verdict::stopped : Verdict::refused;
    return row;
  }
  if (!extreme.figure) return row;
  row.figure = extreme.figure(tried);
  const bool warned_first = !tried.result.warnings.empty() && tried.result.warnings[0].time == 0;
  if (!(std::abs(*row.figure) <= extreme.bound || warned_first) ||
      (doubtful && !extreme.may_stop && !extreme.may_warn))
    return row;
  row.verdict = doubtful ? Verdict::warned : Verdict::holds;
  return row;
}

double energy_gain(const Attempt& attempt) {
  const std::vector<double> total = attempt.history("energies.total");
  return std::ranges::max(total) / total.front() - 1;
}

double imbalance(const Attempt& attempt) {
  double worst = 0;
  for (double error : attempt.history("energies.balance_error")) worst = std::max(worst, std::abs(error));
  return worst;
}

}  // namespace trajan::stability
