#include "tests/bench/cases.h"

namespace trajan::bench {

const std::vector<Case>& cases() {
  constexpr Dimension solid = Dimension::solid, axisymmetric = Dimension::axisymmetric;
  using enum Kind;
  static const std::vector<Case> all = {
      {{.name = "discs/MUSL"}, discs},
      {{.name = "discs/MUSL/float", .precision = "FLOAT"}, discs},
      {{.name = "discs/MUSL/turned", .turned = true}, discs},
      {{.name = "discs/USL", .scheme = "USL"}, discs},
      {{.name = "discs/MUSL/neo_hookean", .law = "neo_hookean"}, discs},
      {{.name = "discs/MUSL/contact", .contact = true}, discs},
      {{.name = "discs/MUSL/gimp", .shape_functions = "gimp"}, discs},
      {{.name = "discs/MUSL/quadratic_bspline", .shape_functions = "quadratic_bspline"}, discs},
      {{.name = "discs/MUSL/quadratic_bspline/float",
        .shape_functions = "quadratic_bspline",
        .precision = "FLOAT"},
       discs},
      {{.name = "discs/MUSL/quadratic_bspline/APIC", .shape_functions = "quadratic_bspline", .transfer = "APIC"},
       discs},
      {{.name = "discs/MUSL/cubic_bspline", .shape_functions = "cubic_bspline"}, discs},
      {{.name = "bar/TLMPM", .scheme = "TLMPM"}, bar},
      {{.name = "bar/TLMPM/neo_hookean", .scheme = "TLMPM", .law = "neo_hookean"}, bar},
      {{.name = "bar/TLMPM/neo_hookean/loaded", .scheme = "TLMPM", .law = "neo_hookean", .loaded = true}, bar},
      {{.name = "bar/TLMPM/neo_hookean/float", .scheme = "TLMPM", .law = "neo_hookean", .precision = "FLOAT"},
       bar},
      {{.name = "block/TLMPM/neo_hookean/float",
        .scheme = "TLMPM",
        .law = "neo_hookean",
        .dimension = solid,
        .precision = "FLOAT"},
       block},
      {{.name = "bar/TLMPM/quadratic_bspline", .scheme = "TLMPM", .shape_functions = "quadratic_bspline"}, bar},
      {{.name = "block/MUSL", .dimension = solid}, block},
      {{.name = "block/MUSL/drifting", .drifting = true, .dimension = solid}, block},
      {{.name = "block/MUSL/float", .dimension = solid, .precision = "FLOAT"}, block},
      {{.name = "block/MUSL/quadratic_bspline/float",
        .shape_functions = "quadratic_bspline",
        .dimension = solid,
        .precision = "FLOAT"},
       block},
      {{.name = "block/TLMPM/neo_hookean", .scheme = "TLMPM", .law = "neo_hookean", .dimension = solid}, block},
      {{.name = "block/TLMPM/neo_hookean/loaded",
        .scheme = "TLMPM",
        .law = "neo_hookean",
        .loaded = true,
        .dimension = solid},
       block},
      {{.name = "block/MUSL/quadratic_bspline", .shape_functions = "quadratic_bspline", .dimension = solid},
       block},
      {{.name = "block/MUSL/quadratic_bspline/APIC",
        .shape_functions = "quadratic_bspline",
        .transfer = "APIC",
        .dimension = solid},
       block},
      {{.name = "block/MUSL/cubic_bspline", .shape_functions = "cubic_bspline", .dimension = solid}, block},
      {{.name = "column/TLMPM/damage", .scheme = "TLMPM", .damage = true, .dimension = axisymmetric}, block},
      {{.name = "column/MUSL/damage", .damage = true, .dimension = axisymmetric}, block},
      {{.name = "bar/implicit_static", .scheme = "TLMPM", .law = "neo_hookean", .kind = implicit_static}, bar},
      {{.name = "bar/implicit_dynamic", .scheme = "TLMPM", .law = "neo_hookean", .kind = implicit_dynamic}, bar},
      {{.name = "bar/modal", .scheme = "TLMPM", .law = "neo_hookean", .kind = modal}, bar},
  };
  return all;
}

}  // namespace trajan::bench
