#include "solver/implicit/rigid_modes.h"

#include <Eigen/Dense>
#include <numeric>
#include <set>

#include "solver/model/names.h"

namespace trajan {
namespace {

/// Of the largest resistance to a rigid motion; less is none.
constexpr double no_resistance = 1e-9;

/// Nodes that particles connect, as a forest: roots stand for all.
class ConnectedNodes {
 public:
  explicit ConnectedNodes(const Discretization& on) : parent_(on.nodes()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::size_t p = 0; p < on.particles(); ++p)
      for (std::uint32_t n : on.particle(p).nodes) parent_[root(n)] = root(on.particle(p).nodes[0]);
  }
  std::uint32_t root(std::uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

using Point = std::array<double, 3>;

/// A rigid motion: a translation along an axis, or a turn from one axis towards another about a point.
struct RigidMode {
  int from = 0, to = -1;
  double at(int axis, const Point& place, const Point& centre, double size) const {
    if (to < 0) return axis == from ? 1.0 : 0.0;
    const auto f = static_cast<std::size_t>(from), t = static_cast<std::size_t>(to);
    if (axis == from) return -(place[t] - centre[t]) / size;
    return axis == to ? (place[f] - centre[f]) / size : 0.0;
  }
};

/// Where the grid repeats itself a body may hold on to its own image, and is not taken to turn.
std::vector<RigidMode> modes_of(const Model& model) {
  const Dimension dimension = model.dimension;
  const bool turns = std::ranges::none_of(model.grid.periodic, [](bool periodic) { return periodic; });
  if (dimension == Dimension::bar) return {{0}};
  if (dimension == Dimension::axisymmetric) return {{1}};
  if (dimension == Dimension::solid && turns) return {{0}, {1}, {2}, {0, 1}, {1, 2}, {2, 0}};
  if (dimension == Dimension::solid) return {{0}, {1}, {2}};
  if (turns) return {{0}, {1}, {0, 1}};
  return {{0}, {1}};
}

class FreeMotion {
 public:
  FreeMotion(const Model& model, const Discretization& on) : model_(model), on_(on), modes_(modes_of(model)) {}

  /// Of the component of this root; empty: none.
  std::string find(ConnectedNodes& components, std::uint32_t root, const Constraints& constraints) {
    frame(components, root);
    const auto count = static_cast<Eigen::Index>(modes_.size());
    Eigen::MatrixXd resistance = Eigen::MatrixXd::Zero(count, count);
    for (const Constraints::Row& row : constraints.rows()) {
      if (row.terms.empty() || components.root(node(row.terms[0].first)) != root) continue;
      Eigen::VectorXd c = Eigen::VectorXd::Zero(count);
      double sum = 0;
      for (const auto& [unknown, weight] : row.terms) {
        sum += std::abs(weight);
        for (Eigen::Index m = 0; m < count; ++m)
          c[m] += weight * modes_[static_cast<std::size_t>(m)].at(static_cast<int>(unknown) % on_.axes(),
                                                                  place(node(unknown)), centre_, size_);
      }
      resistance += c * c.transpose() / (sum * sum);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(resistance);
    const double largest = std::max(solver.eigenvalues()[count - 1], 1.0);
    if (solver.eigenvalues()[0] > no_resistance * largest) return "";
    return describe(solver.eigenvectors().col(0));
  }

 private:
  std::uint32_t node(std::uint32_t unknown) const { return unknown / static_cast<std::uint32_t>(on_.axes()); }
  Point place(std::uint32_t n) const {
    const auto index = on_.grid_index(n);
    const Vector& origin = model_.grid.origin;
    const double h = model_.grid.cell;
    return {origin.x + h * static_cast<double>(index[0]), origin.y + h * static_cast<double>(index[1]),
            origin.z + h * static_cast<double>(index[2])};
  }
  /// The middle and the size of a component.
  void frame(ConnectedNodes& components, std::uint32_t root) {
    Point lowest, highest;
    lowest.fill(HUGE_VAL);
    highest.fill(-HUGE_VAL);
    for (std::uint32_t n = 0; n < on_.nodes(); ++n) {
      if (components.root(n) != root) continue;
      const Point at = place(n);
      for (std::size_t i = 0; i < 3; ++i)
        lowest[i] = std::min(lowest[i], at[i]), highest[i] = std::max(highest[i], at[i]);
    }
    size_ = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      centre_[i] = 0.5 * (lowest[i] + highest[i]);
      size_ = std::max(size_, 0.5 * (highest[i] - lowest[i]));
    }
  }
  std::string describe(const Eigen::VectorXd& mode) const {
    const int axes = on_.axes();
    Vector along{};
    double* component[] = {&along.x, &along.y, &along.z};
    double turn = 0;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      const double part =
          std::abs(mode[static_cast<Eigen::Index>(m)]) < 1e-6 ? 0 : mode[static_cast<Eigen::Index>(m)];
      if (modes_[m].to < 0)
        *component[modes_[m].from] = part;
      else
        turn = std::max(turn, std::abs(part));
    }
    if (turn == 0) return "can move freely along " + point_text(rounded(along), axes);
    if (axes == 3) return "can turn freely";
    // The point that stays where it is.
    const double rate = mode[2] / size_;
    return "can turn freely about " +
           point_text(rounded({centre_[0] - along.y / rate, centre_[1] + along.x / rate, 0}), axes);
  }
  static Vector rounded(Vector v) {
    for (double* c : {&v.x, &v.y, &v.z}) *c = std::round(*c * 1e4) / 1e4 + 0.0;
    return v;
  }

  const Model& model_;
  const Discretization& on_;
  std::vector<RigidMode> modes_;
  Point centre_{};
  double size_ = 1;
};

}  // namespace

std::string find_free_motion(const Model& model, const Discretization& on, const Constraints& constraints) {
  ConnectedNodes components(on);
  FreeMotion motion(model, on);
  std::set<std::uint32_t> seen;
  for (std::size_t p = 0; p < on.particles(); ++p) {
    const std::uint32_t root = components.root(on.particle(p).nodes[0]);
    if (!seen.insert(root).second) continue;
    const std::string how = motion.find(components, root, constraints);
    if (!how.empty()) return "body " + quoted(model.bodies[on.body(p)].name) + " " + how;
  }
  return "";
}

}  // namespace trajan
