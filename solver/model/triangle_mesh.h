#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/model/geometry.h"
#include "solver/model/stl.h"

namespace trajan {

/// What keeps triangles from being the surface of a body.
class MeshError : public std::runtime_error {
 public:
  MeshError(const std::string& problem, std::string remedy)
      : std::runtime_error(problem), remedy_(std::move(remedy)) {}
  const std::string& remedy() const { return remedy_; }

 private:
  std::string remedy_;
};

/// The surface of a body. A place lies inside if the surface winds around it, whichever way.
class TriangleMesh {
 public:
  /// The surface must be closed: along every edge there are as many triangles of one sense as of the other.
  /// Corners are the same only if their coordinates are. Throws MeshError.
  explicit TriangleMesh(std::vector<Triangle> triangles);

  const Box& bounds() const { return bounds_; }
  /// The parts of the line along x at (y, z) inside, longer by `slack` at both ends.
  Spans spans(double y, double z, double slack) const;
  /// Distance from the surface, negative inside. Takes time with the number of triangles.
  double signed_distance(Vector place) const;
  double volume() const;
  /// The triangles that the busiest line along x must look at.
  double work_of_a_line() const { return static_cast<double>(most_in_a_bin_); }

 private:
  struct Crossing {
    double x = 0;
    int sense = 0;  ///< +1: into the body if corners are counter-clockwise seen from outside
  };
  void check_closed() const;
  void fill_bins();
  std::size_t bin_of(double coordinate, double lower, double upper) const;
  std::vector<Crossing> crossings(double y, double z) const;

  std::vector<Triangle> triangles_;
  Box bounds_;
  std::size_t bins_ = 1;  ///< along y and along z
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> binned_;  ///< triangles that a bin's lines may meet
  std::size_t most_in_a_bin_ = 0;
};

}  // namespace trajan
