#include "solver/model/names.h"
#include "solver/model/overloaded.h"
#include "solver/model/validator.h"

/// What has no meaning where states of rest are looked for.
namespace trajan {
namespace {

bool is_zero(const VectorExpression& vector) {
  for (const auto* component : {&vector.x, &vector.y, &vector.z})
    if (*component && (*component)->find_first_not_of(" 0.+-") != std::string::npos) return false;
  return true;
}

/// Why a boundary has no place in a relaxation; empty: it has.
const char* objection(const BoundaryDefinition& boundary) {
  constexpr const char* moves = "a relaxation cannot follow a boundary that moves";
  const auto if_moves = [&](const VectorExpression& motion) { return is_zero(motion) ? "" : moves; };
  return std::visit(Overloaded{[&](const PrescribedVelocity& c) { return if_moves(c.velocity); },
                               [&](const PrescribedDisplacement& c) { return if_moves(c.displacement); },
                               [&](const RigidPlane& c) { return if_moves(c.contact.displacement); },
                               [&](const RigidBall& c) { return if_moves(c.contact.displacement); },
                               [&](const Hinge& c) { return if_moves(c.displacement); },
                               [](const Absorbing&) { return "at rest there are no waves to absorb"; },
                               [](const auto&) { return ""; }},
                    boundary.condition);
}

}  // namespace

void Validator::check_kind(const Relaxation& analysis) {
  violations_.within("analysis.relaxation.tolerance", analysis.tolerance, 1e-12, 0.1);
  violations_.within("analysis.relaxation.most_steps", static_cast<double>(analysis.most_steps), 1, 1e9);
  if (scene_.analysis.damping > 0)
    violations_.add("analysis.damping", number_text(scene_.analysis.damping), "a relaxation damps by itself",
                    "leave it out");
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
    if (!is_zero(scene_.bodies[i].initial_velocity))
      violations_.add(indexed("bodies", i) + ".initial_velocity", "", "a relaxation begins at rest",
                      "leave it out");
  for (std::size_t i = 0; i < scene_.boundaries.size(); ++i)
    if (const std::string problem = objection(scene_.boundaries[i]); !problem.empty())
      violations_.add(indexed("boundaries", i), scene_.boundaries[i].name, problem,
                      "choose another kind of analysis, or leave the motion out");
}

}  // namespace trajan
