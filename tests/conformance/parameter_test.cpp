#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/model/validate.h"
#include "tests/conformance/material_point.h"

/// The ranges of every law's parameters, as their tables state them, at the bounds to the last bit.
namespace trajan::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One case of each law: its ranges do not depend on the dimension.
std::vector<LawCase> laws() {
  std::vector<LawCase> cases;
  for (const LawCase& of : all_laws())
    if (cases.empty() || cases.back().kind != of.kind) cases.push_back(of);
  return cases;
}

class Parameters : public testing::TestWithParam<LawCase> {
 protected:
  const MaterialKind& kind() const { return *GetParam().kind; }
  bool is_damaged() const { return kind().name.starts_with(damage_prefix); }
  std::string law() const { return std::string(kind().name.substr(is_damaged() ? damage_prefix.size() : 0)); }
  /// Damage has a table of its own, behind that of its base.
  std::size_t of_base() const {
    return is_damaged() ? find_material_kind(law())->parameters.size() : kind().parameters.size();
  }
  std::string path(std::size_t parameter) const {
    return "materials[0]." + (parameter < of_base() ? law() : "damage") + "." +
           std::string(kind().parameters[parameter].name);
  }

  /// Whether a material of the first sample, but for this value, is refused for it.
  bool is_refused(std::size_t parameter, double value) const {
    Scene scene;
    scene.domain.dimension = GetParam().dimension;
    scene.numerics.scheme = GetParam().total_lagrangian ? "TLMPM" : "MUSL";
    scene.materials = {{"solid", 1, law(), {}}};
    if (is_damaged()) scene.materials[0].damage.emplace();
    const std::vector<double> sample = sample_parameters(kind())[0];
    for (std::size_t i = 0; i < sample.size(); ++i) {
      auto& values = i < of_base() ? scene.materials[0].parameters : *scene.materials[0].damage;
      values[std::string(kind().parameters[i].name)] = i == parameter ? value : sample[i];
    }
    try {
      validate(scene);
    } catch (const InvalidScene& invalid) {
      for (const Violation& violation : invalid.violations())
        if (violation.path == path(parameter)) {
          EXPECT_NE(violation.problem, "");
          EXPECT_THAT(violation.remedy, testing::StartsWith("give a number"));
          return true;
        }
    }
    return false;
  }
};
INSTANTIATE_TEST_SUITE_P(Registry, Parameters, testing::ValuesIn(laws()),
                         [](const auto& named) { return name_of(named.param); });

TEST_P(Parameters, AreInTheRangesOfTheirTable) {
  for (std::size_t i = 0; i < kind().parameters.size(); ++i) {
    const Parameter& of = kind().parameters[i];
    SCOPED_TRACE(path(i));
    for (const double never : {std::nan(""), infinity, -infinity}) EXPECT_TRUE(is_refused(i, never)) << never;
    EXPECT_FALSE(is_refused(i, sample_parameters(kind())[0][i]));
    const auto bound = [&](double at, bool allowed, double outwards) {
      if (std::isinf(at)) return;
      const double within = allowed ? at : std::nextafter(at, -outwards);
      const double beyond = allowed ? std::nextafter(at, outwards) : at;
      EXPECT_FALSE(is_refused(i, within)) << within;
      EXPECT_TRUE(is_refused(i, beyond)) << beyond;
    };
    bound(of.lowest, of.lowest_allowed, -infinity);
    bound(of.highest, of.highest_allowed, infinity);
  }
}

}  // namespace
}  // namespace trajan::test
