#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "solver/schemes/kernels.h"

/// What particles give and get that lie in strips must be what they give and get cell by cell. In floats and in a
/// plane kernels work on strips.
namespace trajan::strips_test {
namespace {

struct Particle {
  double at[2];  ///< in cells of the window, its own from 1 on
  float velocity[2], force[4], affine[4];
  double volume;
};

constexpr int side = 8;

/// Of the upper half of a tile, in the order of memory: for each row of cells one of each, then a second one of
/// each, and so on. Most cells have four, some others as many as chance has it.
std::vector<Particle> random_particles(double share_of_others) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(0, 1);
  std::uniform_int_distribution<int> some(0, 6);
  std::vector<Particle> particles;
  for (int y = 1; y <= 4; ++y) {
    int count[side];
    for (int& of_cell : count) of_cell = anywhere(random) < share_of_others ? some(random) : 4;
    for (int i = 0; i < 6; ++i)
      for (int x = 1; x <= side; ++x) {
        if (i >= count[x - 1] || particles.size() >= block_size) continue;
        Particle p{{x + anywhere(random), y + anywhere(random)}, {}, {}, {}, 1 + anywhere(random)};
        for (float& b : p.affine) b = static_cast<float>(0.25 * (anywhere(random) - 0.5));
        for (float& v : p.velocity) v = static_cast<float>(anywhere(random) - 0.5);
        for (float& f : p.force) f = static_cast<float>(anywhere(random) - 0.5);
        particles.push_back(p);
      }
  }
  return particles;
}

/// What particles have given to nodes and got from them.
struct Exchanged {
  bool by_strips;
  int full_strips;
  std::vector<double> sums, acceleration[2], velocity[2], gradient[4], affine[4];
};

struct How {
  const char* shape_functions;
  Margin margin;
  bool equal_masses, affine = false;
};

/// In doubles or floats.
template <class Number>
class Exchange {
 public:
  Exchange(const std::vector<Particle>& particles, const How& how)
      : how_(how),
        kernels_(*grid_kernels().transfer(how.shape_functions, Dimension::plane_strain, how.margin)),
        sums_(static_cast<std::size_t>(kernels_.layout.window_array(quantities(sum_vectors, 2)))) {
    scratch_.prepare(static_cast<std::size_t>(kernels_.layout.window_array(quantities(node_vectors, 2))), 0, 2);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> anywhere(-1, 1);
    for (Number& node : scratch_.window) node = anywhere(random);
    sweep_.cell = sweep_.inverse_cell = 1;
    body_.mass = 1.75, body_.density = 1.25;
    block_.count = static_cast<int>(particles.size());
    block_.body = &body_, block_.sweep = &sweep_, block_.scratch = &scratch_, block_.sums = sums_.data();
    for (const Particle& p : particles) volume_.push_back(p.volume);
    if (!how.equal_masses) block_.arrays[index(Attribute::reference_volume, 0)] = volume_.data();
    for (int a = 0; a < 2; ++a) {
      for (const Particle& p : particles) {
        position_[a].push_back(p.at[a] + begin_of_cells(kernels_.layout.reach));
        velocity_[a].push_back(p.velocity[a]);
      }
      block_.arrays[index(Attribute::position_x, a)] = position_[a].data();
      put(velocity_[a].data(), index(Attribute::velocity_x, a));
      block_.lowest[a] = 1, block_.highest[a] = side;
      // Far from the faces of the domain.
      sweep_.origin[a] = -100, block_.window_first[a] = 100;
      sweep_.faces[a] = 1000;
      body_.half_size[a] = 0.25;
    }
    for (int f = 0; f < 4; ++f) {
      for (const Particle& p : particles) affine_[f].push_back(p.affine[f]);
      put(affine_[f].data(), index(Attribute::affine_xx, f / 2 * 3 + f % 2));
    }
    auto* force = const_cast<BlockArray<Number>*>(scratch_.force_on_nodes());
    for (int f = 0; f < 4; ++f)
      for (std::size_t i = 0; i < particles.size(); ++i) force[f][static_cast<int>(i)] = particles[i].force[f];
  }

  /// Whether particles are found to be out of where the tile allows. They are worked on in its window.
  bool locates_out_of_window() {
    kernels_.locate(block_);
    const Layout& layout = kernels_.layout;
    for (int i = 0; i < block_.count; ++i) {
      EXPECT_THAT(scratch_.cell[i], testing::AllOf(testing::Ge(0), testing::Lt(layout.window_nodes)));
      for (int a = 0; a < 2; ++a)
        EXPECT_THAT(scratch_.place[a][i], testing::AllOf(testing::Ge(Number(0)), testing::Le(Number(2))));
    }
    return scratch_.trouble.left_window;
  }

  Exchanged all() {
    kernels_.locate(block_);
    EXPECT_FALSE(scratch_.trouble.left_window);
    const AffineKernels& affine = kernels_.affine;
    if (how_.affine)
      for (Stage stage : {affine.find_levers, affine.scatter_state, affine.scatter_momentum, affine.kick,
                          affine.gather, kernels_.gather_gradient})
        stage(block_);
    else
      for (Stage stage : {kernels_.scatter_state, kernels_.scatter_momentum, kernels_.gather_acceleration,
                          kernels_.gather_motion})
        stage(block_);
    Exchanged all{scratch_.by_strips, scratch_.full_strips.size, {sums_.begin(), sums_.end()}, {}, {}, {}, {}};
    const auto copy = [&](const BlockArray<Number>& from) {
      return std::vector<double>(from.values, from.values + block_.count);
    };
    for (int a = 0; a < 2; ++a) {
      all.acceleration[a] = copy(scratch_.acceleration[a]);
      all.velocity[a] = copy(scratch_.velocity[a]);
    }
    for (int g = 0; g < 4; ++g) {
      all.gradient[g] = copy(scratch_.gradient_of_grid()[g]);
      all.affine[g].assign(affine_[g].begin(), affine_[g].end());
    }
    return all;
  }

 private:
  static const GridKernels& grid_kernels() {
    return std::is_same_v<Number, float> ? trajan::kernels().floats : trajan::kernels().doubles;
  }
  static std::size_t index(Attribute first, int axis) {
    return static_cast<std::size_t>(first) + static_cast<std::size_t>(axis);
  }
  void put(float* values, std::size_t at) { block_.floats[at] = values; }
  void put(double* values, std::size_t at) { block_.arrays[at] = values; }

  How how_;
  const TransferKernels& kernels_;
  TransferScratch<Number> scratch_;
  SweepConstants sweep_;
  BodyConstants body_;
  AlignedDoubles sums_;
  std::vector<double> position_[2], volume_;
  std::vector<Number> velocity_[2], affine_[4];
  Block block_;
};

class Strips : public testing::TestWithParam<std::tuple<double, How>> {};
INSTANTIATE_TEST_SUITE_P(
    SharesOfOthers, Strips,
    testing::Combine(testing::Values(0.0, 0.05, 0.3, 1.0),
                     testing::Values(How{"linear", Margin::none, true}, How{"linear", Margin::one_cell, true},
                                     How{"linear", Margin::none, false}, How{"gimp", Margin::one_cell, true},
                                     How{"quadratic_bspline", Margin::none, true},
                                     How{"quadratic_bspline", Margin::one_cell, false},
                                     How{"quadratic_bspline", Margin::one_cell, true, true},
                                     How{"cubic_bspline", Margin::none, true, true},
                                     How{"cubic_bspline", Margin::none, true},
                                     How{"cubic_bspline", Margin::one_cell, true})));

TEST_P(Strips, GiveAndGetWhatTheirParticlesDoInDoubles) {
  const auto& [others, how] = GetParam();
  const std::vector<Particle> particles = random_particles(others);
  const Exchanged strips = Exchange<float>(particles, how).all(), exact = Exchange<double>(particles, how).all();
  EXPECT_FALSE(exact.by_strips);
  if (__builtin_cpu_supports("avx2")) {
    EXPECT_TRUE(strips.by_strips);
    EXPECT_GE(strips.full_strips, others == 1 ? 0 : others > 0 ? 1 : 16);
  }
  // A node's sums have some 64 terms of about one, each rounded some five times.
  constexpr double rounding = 320 * std::numeric_limits<float>::epsilon();
  EXPECT_THAT(strips.sums, testing::Pointwise(testing::DoubleNear(rounding), exact.sums));
  const auto expect_same = [](const std::vector<double>& got, const std::vector<double>& expected) {
    // Products of two weights and a number of about one, up to sixteen of them, and what places are rounded to.
    EXPECT_THAT(got,
                testing::Pointwise(testing::DoubleNear(32 * std::numeric_limits<float>::epsilon()), expected));
  };
  for (int a = 0; a < 2; ++a) {
    expect_same(strips.acceleration[a], exact.acceleration[a]);
    expect_same(strips.velocity[a], exact.velocity[a]);
  }
  for (int g = 0; g < 4; ++g) {
    expect_same(strips.gradient[g], exact.gradient[g]);
    expect_same(strips.affine[g], exact.affine[g]);
  }
}

template <class Number>
void expect_found_out(const How& how) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Particle> inside = random_particles(0.3);
  EXPECT_FALSE((Exchange<Number>(inside, how).locates_out_of_window()));
  // The window's own cells are those from 1 to 8.
  for (double wild : {0.999, 9.001, -3.0, 40.0, -1e9, 1e9, -1e300, 1e300, -infinity, infinity,
                      std::numeric_limits<double>::quiet_NaN()})
    for (int axis : {0, 1}) {
      std::vector<Particle> particles = inside;
      particles[particles.size() / 2].at[axis] = wild;
      EXPECT_TRUE((Exchange<Number>(particles, how).locates_out_of_window())) << wild << " along " << axis;
    }
}

TEST(Places, OutOfAWindowAreFoundOutHoweverFarTheyAre) {
  for (const char* functions : {"linear", "quadratic_bspline", "cubic_bspline"})
    for (Margin margin : {Margin::none, Margin::one_cell}) {
      SCOPED_TRACE(functions);
      expect_found_out<float>({functions, margin, true});
      expect_found_out<double>({functions, margin, true});
    }
}

}  // namespace
}  // namespace trajan::strips_test
