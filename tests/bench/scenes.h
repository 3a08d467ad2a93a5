#pragma once

#include <string>

#include "solver/scene/scene.h"

namespace trajan::bench {

enum class Kind { explicit_steps, implicit_static, implicit_dynamic, modal };

/// What a benchmark runs: one word of each kind that a scene chooses.
struct Choice {
  std::string name;
  std::string scheme = "MUSL";
  std::string shape_functions = "linear";
  std::string transfer = "FLIP";
  std::string law = "linear_elastic";
  bool damage = false;
  bool contact = false;
  bool turned = false;    ///< discs that spin, once their rows of particles lie askew
  bool drifting = false;  ///< a block that moves through the cells
  bool loaded = false;    ///< by a force on one side that comes and goes
  Dimension dimension = Dimension::plane_strain;
  std::string precision = "DOUBLE";
  Kind kind = Kind::explicit_steps;
};

/// The colliding discs of Sulsky, Chen and Schreyer (1994), with room to fly apart however many steps are asked
/// for, of about so many particles; two to a cell's side.
Scene discs(const Choice& choice, double particles);

/// A square, a cube or (axisymmetric) a cylinder of unit side that stands on its lowest face and vibrates a
/// little.
Scene block(const Choice& choice, double particles);

/// A beam of length 8 and height 1 that is held at its left end: explicit steps while it vibrates along itself,
/// otherwise bent by a load at its end.
Scene bar(const Choice& choice, double particles);

}  // namespace trajan::bench
