#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Accuracy against cost.
namespace trajan::accuracy {

/// A run: what it took, how far it was off, and by which method on which grid.
struct Point {
  double cost = 0;         ///< core-seconds
  double error = 0;        ///< magnitude
  std::size_t method = 0;  ///< number of its method
  double cell_size = 0;
};

/// For each point whether no other has a smaller error and a cost that is not higher, nor a lower cost and an
/// error that is not larger (Pareto's set).
std::vector<bool> pareto_set(std::span<const Point> points);

/// The cheapest point with an error of at most `tolerance` whose method does not exceed it on any finer grid
/// either, so that an error that only passes through zero does not count. None if there is none.
std::optional<std::size_t> cheapest(std::span<const Point> points, double tolerance);

}  // namespace trajan::accuracy
