#include "solver/materials/laws.h"
#include "solver/materials/material.h"

namespace trajan {
namespace {

constexpr MaterialKind kinds[] = {
#define TRAJAN_KIND(Law) {Law::name, Law::source, Law::parameters, &Law::wave_speed},
    TRAJAN_FOR_EACH_LAW(TRAJAN_KIND)
#undef TRAJAN_KIND
};

}  // namespace

std::span<const MaterialKind> material_kinds() { return kinds; }

const MaterialKind* find_material_kind(std::string_view name) {
  for (const MaterialKind& kind : kinds)
    if (kind.name == name) return &kind;
  return nullptr;
}

}  // namespace trajan
