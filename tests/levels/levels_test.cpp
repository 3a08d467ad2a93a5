#include <gtest/gtest.h>

#include <algorithm>

#include "solver/model/validate.h"
#include "solver/simulation/simulation.h"
#include "tests/bench/cases.h"
#include "tests/levels/v3_kernels.h"

namespace trajan {

inline namespace TRAJAN_INSTRUCTION_SET {
extern const Kernels compiled_kernels;
}

namespace {
const Kernels* chosen = &compiled_kernels;
}

/// In the place of the solver's own choice.
const Kernels& kernels() { return *chosen; }

namespace {

std::vector<BodyParticles> copies(const std::vector<BodyParticles>& bodies) {
  std::vector<BodyParticles> made(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    made[b].arrays = bodies[b].arrays;
    made[b].floats = bodies[b].floats;
  }
  return made;
}

/// What particles carry after some steps, by kernels of this instruction set.
std::vector<BodyParticles> state_after_steps(const bench::Case& of, const Kernels& kernels_of) {
  chosen = &kernels_of;
  const Model model = validate(of.make(of.choice, 2000));
  Simulation simulation(model, 1);
  for (int i = 0; i < 20; ++i) simulation.step();
  return copies(simulation.executor().bodies());
}

TEST(Levels, HaveCodeOfTheirOwn) {
  const auto locate = [](const Kernels& of) {
    return of.doubles.transfer("linear", Dimension::solid, Margin::one_cell)->locate;
  };
  EXPECT_NE(locate(compiled_kernels), locate(x86_64_v3::compiled_kernels));
  EXPECT_STREQ(x86_64_v3::compiled_kernels.instruction_set, "x86_64_v3");
}

class LevelsBits : public testing::TestWithParam<bench::Case> {};

/// No multiply-adds are fused unless code asks for it, which is the same on both, and no sum depends on how many
/// numbers a register holds.
TEST_P(LevelsBits, AreTheSame) {
  const std::vector<BodyParticles> here = state_after_steps(GetParam(), compiled_kernels);
  const std::vector<BodyParticles> there = state_after_steps(GetParam(), x86_64_v3::compiled_kernels);
  for (std::size_t b = 0; b < here.size(); ++b)
    for (int a = 0; a < attribute_count; ++a) {
      EXPECT_EQ(here[b].arrays[a], there[b].arrays[a]) << attribute_name(static_cast<Attribute>(a));
      EXPECT_EQ(here[b].floats[a], there[b].floats[a]) << attribute_name(static_cast<Attribute>(a));
    }
}

std::vector<bench::Case> cases_of_few_kernels() {
  std::vector<bench::Case> few;
  for (const bench::Case& one : bench::cases())
    if (x86_64_v3::can_step(one.choice)) few.push_back(one);
  return few;
}

INSTANTIATE_TEST_SUITE_P(Benchmark, LevelsBits, testing::ValuesIn(cases_of_few_kernels()), [](const auto& of) {
  std::string name = of.param.choice.name;
  std::ranges::replace(name, '/', '_');
  return name;
});

}  // namespace
}  // namespace trajan
