#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/model/validate.h"
#include "tests/unit/simulation/scenes.h"

/// What happens to scenes where numerical methods break: each run stays within its bound, or warns before it
/// leaves it, or is refused or stopped with a diagnosis. Never a wrong number in silence.
namespace trajan::stability {

/// What became of a scene.
struct Attempt {
  std::optional<Model> model;  ///< empty: refused
  RunResult result;
  test::Memory memory;
  std::string diagnosis;  ///< why it was refused, stopped or warned: cause and remedy

  bool finished() const { return model && result.end == RunEnd::finished; }
  /// Whether a run that was refused, stopped or warned says where (field, or step and particle; a body, where an
  /// equilibrium was sought), why and what to do.
  bool says_why() const;
  /// The history of a column, up to where the run itself says that it is doubtful (all of it, if from the
  /// beginning). Throws std::invalid_argument if there is none of this name.
  std::vector<double> history(const std::string& column) const;
  double last(const std::string& column) const { return history(column).back(); }
};

/// A change of a valid model that no scene can ask for, such as a time step beyond the limit.
using ModelChange = std::function<void(Model&)>;

/// Validates and runs on one thread.
Attempt attempt(const Scene& scene, const ModelChange& change = {});

/// How much of a case is tried: what continuous integration affords, or all of it.
enum class Size { quick, whole };

/// One scene at an extreme, and what must hold of it.
struct Extreme {
  std::string name;
  std::string claim;             ///< what the figure is
  double bound = 0;              ///< of the figure's magnitude
  bool may_stop = false;         ///< or warn; the figure is of what was before
  bool may_warn = false;         ///< likewise
  std::string says = {};         ///< what its diagnosis must say; empty: anything
  std::string refused_for = {};  ///< the field that may be refused; empty: none
  Scene scene;
  std::function<double(const Attempt&)> figure;  ///< empty: the run must not come to its end
  ModelChange change = {};
};

/// A kind of extremes: one file each.
struct Case {
  std::string_view name;
  std::vector<Extreme> (*extremes)(Size);
};
const std::vector<Case>& cases();

enum class Verdict { holds, warned, stopped, refused, wrong };
std::string_view name(Verdict verdict);

struct Row {
  Verdict verdict = Verdict::wrong;
  std::optional<double> figure;
  std::string diagnosis;
};
Row judge(const Extreme& extreme);

/// \name Figures
/// @{
/// The largest energy of the history over the first one, minus 1.
double energy_gain(const Attempt& attempt);
/// The largest energies.balance_error.
double imbalance(const Attempt& attempt);
/// @}

}  // namespace trajan::stability
