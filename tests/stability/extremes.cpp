#include "tests/stability/extremes.h"

#include <algorithm>
#include <cmath>

namespace trajan::stability {

bool Attempt::says_why() const {
  if (!model) return !diagnosis.empty();
  return result.divergence && result.divergence->step > 0 && !result.divergence->cause.empty() &&
         !result.divergence->remedy.empty();
}

std::vector<double> Attempt::history(const std::string& column) const {
  const std::size_t index = test::column(*model, column);
  std::vector<double> values;
  for (const std::vector<double>& row : memory.rows) values.push_back(row[index]);
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
  if (attempt.result.divergence)
    attempt.diagnosis = attempt.result.divergence->cause + "; " + attempt.result.divergence->remedy;
  return attempt;
}

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
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
  if (!tried.finished()) {
    const bool expected = tried.model ? extreme.may_stop
                                      : !extreme.refused_for.empty() &&
                                            tried.diagnosis.find(extreme.refused_for) != std::string::npos;
    if (!tried.says_why() || !expected) return row;
    row.verdict = tried.model ? Verdict::stopped : Verdict::refused;
    return row;
  }
  row.figure = extreme.figure(tried);
  if (std::abs(*row.figure) <= extreme.bound) row.verdict = Verdict::holds;
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
