#pragma once

#include <cstdint>
#include <optional>
#include <variant>

/// Kinds of analyses, as scenes ask for them.
namespace trajan {

enum class LinearSolver { unspecified, automatic, direct, iterative };
enum class MassMatrix { unspecified, consistent, lumped };

struct Newton {
  double tolerance = 1e-8;
  std::int32_t most_iterations = 20;
  std::int32_t most_cuts = 10;
  double growth = 2;
  LinearSolver linear_solver = LinearSolver::automatic;
};

struct ArcLength {
  std::int32_t steps = 100;
};

struct ExplicitDynamics {};

struct Relaxation {
  double tolerance = 1e-5;
  std::int64_t most_steps = 1000000;
};

struct QuasiStatic {
  std::int32_t load_steps = 10;
  Newton newton = {};
  std::optional<ArcLength> arc_length = {};
};

struct Newmark {
  double beta = 0.25;
  double gamma = 0.5;
};

struct GeneralizedAlpha {
  double spectral_radius = 0.8;
};

struct ImplicitDynamics {
  std::int32_t time_steps = 100;
  Newton newton = {};
  std::variant<GeneralizedAlpha, Newmark> method = {};
  MassMatrix mass = MassMatrix::consistent;
};

struct Modal {
  MassMatrix mass = MassMatrix::consistent;
};

struct Buckling {};

using AnalysisKind = std::variant<ExplicitDynamics, Relaxation, QuasiStatic, ImplicitDynamics, Modal, Buckling>;

struct Analysis {
  double end_time = 0;
  double damping = 0;
  AnalysisKind kind = {};
};

}  // namespace trajan
