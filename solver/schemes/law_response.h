#pragma once

#include <cstdint>
#include <string_view>

#include "solver/executors/block.h"
#include "solver/scene/scene.h"

/// What implicit analyses ask of a constitutive law: the response of particles to a finite step and its
/// derivative. A step is given by its displacement gradient G with respect to the configuration in which shape
/// functions are evaluated: the reference configuration in total Lagrangian analyses, F = F_n + G; that at the
/// beginning of the step in updated ones, F = (1 + G) F_n. G has n components per particle: the N x N ones of the
/// grid's axes, row by row, and in axisymmetric scenes then the hoop, the increment of the radial displacement
/// over the radius in that configuration.
namespace trajan {

struct LawResponse {
  const double* gradient = nullptr;  ///< count x n
  /// count x n: the work of the particle's stress per component of G, in hyperelastic laws the derivative of
  /// its energy; reference volume (of the particle, thickness included; axisymmetric: per radian) times stress.
  double* force = nullptr;
  /// count x n x n, the derivative of the force (row) by G (column); nullptr: not asked for.
  double* tangent = nullptr;
  /// Counts of particles are added to these. The numbers of such particles mean nothing.
  std::int64_t inverted = 0;  ///< no positive volume at the end of the step
  std::int64_t unsolved = 0;  ///< no stretch was found that frees the rest of its stress
};

/// A law, for one dimension and one configuration.
struct LawResponseKernels {
  int components;             ///< n
  bool geometrically_linear;  ///< the law takes all configurations for one
  /// From the state that particles carry, which it leaves as it is. `dt`: the time that the step takes.
  /// Tangents are the exact derivatives of the forces, with what plasticity and damage do within the step, and
  /// with stresses across planes and bars held at zero.
  void (*respond)(const Block&, double dt, LawResponse&);
  /// Makes the end of the step the state that the law needs (LawKernels::attributes).
  void (*commit)(Block&, double dt, const double* gradient);
};

/// By the law's name, damaged ones included (solver/materials/material.h); nullptr: there is no such law.
const LawResponseKernels* law_response(std::string_view law, Dimension, bool total_lagrangian);

}  // namespace trajan
