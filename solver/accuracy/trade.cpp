#include "solver/accuracy/trade.h"

#include <algorithm>

namespace trajan::accuracy {

namespace {

bool is_better(const Point& one, const Point& other) {
  return one.cost <= other.cost && one.error <= other.error && (one.cost < other.cost || one.error < other.error);
}

}  // namespace

std::vector<bool> pareto_set(std::span<const Point> points) {
  std::vector<bool> members;
  for (const Point& point : points)
    members.push_back(std::ranges::none_of(points, [&](const Point& other) { return is_better(other, point); }));
  return members;
}

std::optional<std::size_t> cheapest(std::span<const Point> points, double tolerance) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool holds = std::ranges::all_of(points, [&](const Point& other) {
      const bool finer_or_same = other.method == points[i].method && other.cell_size <= points[i].cell_size;
      return !finer_or_same || other.error <= tolerance;
    });
    if (holds && (!best || points[i].cost < points[*best].cost)) best = i;
  }
  return best;
}

}  // namespace trajan::accuracy
