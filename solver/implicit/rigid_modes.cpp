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
    const Eigen::Index free = (solver.eigenvalues().array() <= no_resistance * largest).count();
    return free == 0 ? "" : describe(solver.eigenvectors().leftCols(free).transpose());
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
  /// Of motions in rows. Elimination leaves turns, and moves that no turn is needed for, in terms of the axes.
  std::string describe(Eigen::MatrixXd motions) const {
    const auto axes = static_cast<Eigen::Index>(
        std::ranges::count_if(modes_, [](const RigidMode& mode) { return mode.to < 0; }));
    const Eigen::Index turns = eliminate(motions, axes, motions.cols(), 0);
    const Eigen::Index moves = eliminate(motions, 0, axes, turns);
    if (moves > 0) {
      std::string along = "along " + direction(motions.row(turns).head(axes));
      for (Eigen::Index i = 1; i < moves; ++i) along += " and " + direction(motions.row(turns + i).head(axes));
      if (moves > 1 && moves == axes) along = "in every direction";
      return "can move freely " + along + (turns > 0 ? " and turn" : "");
    }
    if (turns > 1) return "can turn freely about a point";
    if (on_.axes() == 3) {  // turns from x to y are about z, and so on
      const Eigen::RowVectorXd turn = motions.row(0);
      return "can turn freely about an axis along " + direction(Eigen::RowVector3d(turn[4], turn[5], turn[3]));
    }
    // The point that stays where it is.
    return "can turn freely about " +
           point_text(rounded({centre_[0] - motions(0, 1) * size_, centre_[1] + motions(0, 0) * size_, 0}), 2);
  }
  /// Reduces rows from the `done`-th on by pivots in some columns, and returns how many there were.
  static Eigen::Index eliminate(Eigen::MatrixXd& rows, Eigen::Index first, Eigen::Index last, Eigen::Index done) {
    constexpr double nothing = 1e-6;
    const Eigen::Index begin = done;
    for (Eigen::Index column = first; column < last && done < rows.rows(); ++column) {
      Eigen::Index pivot;
      if (rows.col(column).tail(rows.rows() - done).cwiseAbs().maxCoeff(&pivot) < nothing) continue;
      rows.row(done).swap(rows.row(done + pivot));
      rows.row(done) /= rows(done, column);
      for (Eigen::Index row = 0; row < rows.rows(); ++row)
        if (row != done) rows.row(row) -= rows(row, column) * rows.row(done).eval();
      ++done;
    }
    return done - begin;
  }
  /// Of unit length.
  std::string direction(const Eigen::RowVectorXd& along) const {
    Vector v{};
    double* component[] = {&v.x, &v.y, &v.z};
    for (Eigen::Index i = 0; i < along.size(); ++i)
      *component[modes_[static_cast<std::size_t>(i)].from] = along[i] / along.norm();
    return point_text(rounded(v), on_.axes());
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
