#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/store_studies.h"

namespace trajan {

/// A study without runs for a submit whose fidelity is a target. Methods are tried in the order of what is known
/// of them: first those that reached the tolerance before, the cheapest first (findings of the scene's family),
/// then as in `target_methods`. Throws ServiceError INVALID_ARGUMENT.
store::StudyPlan plan_target(const v1::SubmitJobRequest& request, const std::vector<v1::Finding>& findings);

/// What a target does once all of its runs have ended.
struct TargetStep {
  std::optional<store::PlannedRun> run;  ///< to be added; none: it is over
  std::optional<v1::Answer> answer;      ///< what there is so far; none before a run has succeeded
  std::string message;                   ///< about it, for people
};

/// Follows from the scene as it was submitted and the study alone. Two methods begin with two coarse grids each,
/// which tells what it would take either to reach the tolerance; then the one that would be cheaper climbs. A band
/// of two grids counts how far another method's answer is away; of one method alone it is believed after a third
/// grid.
TargetStep next_step(const v1::Scene& scene, const v1::Study& study);

}  // namespace trajan
