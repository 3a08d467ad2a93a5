#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "tests/stability/all_cases.h"

/// The same motion in other units and at other places.
namespace trajan::stability {

namespace {

/// One unit of the scene in those that it is given in.
struct Units {
  double length = 1, mass = 1, time = 1;
};

std::string times(const char* number, double factor) {
  char text[64];
  std::snprintf(text, sizeof text, "%s*%.17g", number, factor);
  return text;
}

Vector scaled(const Vector& vector, double factor) {
  return {vector.x * factor, vector.y * factor, vector.z * factor};
}

/// Two discs that meet (Sulsky, Chen and Schreyer 1994), until they part.
Scene discs(const Units& units, const char* law) {
  Scene scene = test::discs(0.0625);
  const double length = units.length, speed = units.length / units.time;
  scene.domain.cell_size *= length;
  scene.domain.upper = scaled(scene.domain.upper, length);
  scene.domain.thickness = length;
  scene.materials[0].law = law;
  scene.materials[0].density *= units.mass / (length * length * length);
  scene.materials[0].parameters["youngs_modulus"] *= units.mass / (length * units.time * units.time);
  for (BodyDefinition& body : scene.bodies) {
    auto& disc = std::get<Disc>(body.geometry);
    disc.centre = scaled(disc.centre, length);
    disc.radius *= length;
  }
  scene.bodies[0].initial_velocity = {times("0.1", speed), times("0.1", speed)};
  scene.bodies[1].initial_velocity = {times("-0.1", speed), times("-0.1", speed)};
  scene.analysis.end_time *= units.time;
  return scene;
}

const char* const energies[] = {"energies.kinetic", "energies.strain", "energies.total"};

/// Largest difference of energies from those of the scene in its own units, over the largest energy.
double difference(const Attempt& run, const Units& units, const char* law) {
  const Attempt own = attempt(discs({}, law));
  const double unit = units.mass * std::pow(units.length / units.time, 2);
  double largest = 0, worst = 0;
  for (const char* name : energies) {
    const std::vector<double> there = run.history(name), here = own.history(name);
    for (std::size_t i = 0; i < here.size(); ++i) {
      largest = std::max(largest, std::abs(here[i]));
      worst = std::max(worst, std::abs(there[i] / unit - here[i]));
    }
  }
  return worst / largest;
}

void add_units(std::vector<Extreme>& extremes, const char* name, const Units& units, double bound) {
  for (const char* law : {"linear_elastic", "neo_hookean"}) {
    Extreme extreme;
    extreme.name = std::string("discs, ") + law + ", " + name;
    extreme.claim = "difference of the energies";
    extreme.bound = bound;
    extreme.scene = discs(units, law);
    extreme.figure = [units, law](const Attempt& run) { return difference(run, units, law); };
    extremes.push_back(extreme);
  }
}

/// The first axial mode of a bar, `cells` cells from the origin.
Scene bar_at(const char* scheme, double cells) {
  Scene scene = test::bar(scheme, "linear_elastic", 0.5, 0.1);
  const double by = 0.5 * cells;
  const auto move = [by](Box box) {
    return Box{{box.lower.x + by, box.lower.y}, {box.upper.x + by, box.upper.y}};
  };
  scene.domain.lower.x += by;
  scene.domain.upper.x += by;
  scene.bodies[0].geometry = move(std::get<Box>(scene.bodies[0].geometry));
  scene.bodies[0].initial_velocity.x = times("0.1*sin(pi*(x-0.5", cells) + ")/20)";
  scene.boundaries[0].nodes = move(Box{{0, -2}, {0, 3}});
  scene.outputs.probes[0].where = Vector{10 + by, 0.5};
  return scene;
}

void add_distance(std::vector<Extreme>& extremes, const char* scheme) {
  constexpr double cells = 1e6, epsilon = std::numeric_limits<double>::epsilon();
  Extreme extreme;
  extreme.name = std::string("bar 10^6 cells from the origin, ") + scheme;
  extreme.claim = "difference of the tip's displacement, in amplitudes";
  // Positions are rounded to eps * 10^6 cells, in each of 480 steps at worst to the same side; the amplitude is
  // 0.13 cells.
  extreme.bound = 480 * epsilon * cells / 0.13;
  extreme.scene = bar_at(scheme, cells);
  extreme.figure = [scheme](const Attempt& run) {
    const std::vector<double> near = attempt(bar_at(scheme, 0)).history("tip.displacement.x");
    const std::vector<double> far = run.history("tip.displacement.x");
    double worst = 0;
    for (std::size_t i = 0; i < near.size(); ++i) worst = std::max(worst, std::abs(near[i] - far[i]));
    return worst / (0.1 / (0.05 * M_PI * 10));
  };
  extremes.push_back(extreme);
}

}  // namespace

std::vector<Extreme> scales(Size) {
  std::vector<Extreme> extremes;
  add_units(extremes, "lengths 2^40", {std::ldexp(1.0, 40), 1, 1}, 0);
  add_units(extremes, "lengths 2^-40", {std::ldexp(1.0, -40), 1, 1}, 0);
  add_units(extremes, "masses 2^40", {1, std::ldexp(1.0, 40), 1}, 0);
  add_units(extremes, "times 2^-40", {1, 1, std::ldexp(1.0, -40)}, 0);
  add_units(extremes, "all units", {std::ldexp(1.0, 13), std::ldexp(1.0, -31), std::ldexp(1.0, 27)}, 0);
  // Rounding differs. What it does grows with the number of cell crossings; a gap of 1e-6 opens only where a
  // particle changes its cell a step earlier.
  for (double scale : {1e-12, 1e12}) {
    add_units(extremes, scale < 1 ? "lengths 1e-12" : "lengths 1e12", {scale, 1, 1}, 1e-6);
    add_units(extremes, scale < 1 ? "masses and times 1e-12" : "masses and times 1e12", {1, scale, scale}, 1e-6);
  }
  for (const char* scheme : {"USL", "MUSL", "TLMPM"}) add_distance(extremes, scheme);
  return extremes;
}

}  // namespace trajan::stability
