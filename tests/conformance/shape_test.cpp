#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

#include "solver/schemes/kernels.h"
#include "solver/schemes/scheme.h"

/// Every kind of shape functions in every dimension, by what particles gather from and scatter to one tile.
namespace trajan::shape_test {
namespace {

constexpr double cell = 0.25;
/// Sums of at most 64 products of weights that add up to one, with node values below 100 and derivatives that
/// divide by a domain of at least a fiftieth of a cell: so many epsilons of the number type.
template <class Number>
constexpr double rounding = 4.5e4 * std::numeric_limits<Number>::epsilon();

struct Case {
  std::string shape;
  Dimension dimension;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (std::string_view shape : shape_names())
    for (Dimension d : {Dimension::bar, Dimension::plane_strain, Dimension::axisymmetric, Dimension::solid})
      all.push_back({std::string(shape), d});
  return all;
}

/// One tile in the corner of the domain, or in its middle, with particles at random places in it.
template <class Number>
class TileOfParticles {
 public:
  static constexpr int count = 100;
  static constexpr bool wide = std::is_same_v<Number, double>;

  TileOfParticles(const Case& c, bool at_faces, Margin margin)
      : axes(grid_axes(c.dimension)),
        kernels(*(wide ? trajan::kernels().doubles : trajan::kernels().floats)
                     .transfer(c.shape, c.dimension, margin)) {
    const Layout& layout = kernels.layout;
    const bool drift = !at_faces && margin == Margin::one_cell;
    // The last of these lie on the lower face of the domain, before the first one of the tile that begins there.
    const bool below = at_faces && layout.reach == Reach::staggered, before = below && margin == Margin::none;
    sweep.cell = cell;
    sweep.inverse_cell = 1 / cell;
    for (int axis = 0; axis < axes; ++axis) {
      tile_at[axis] = before ? -1 : at_faces ? 0 : 3;
      sweep.origin[axis] = 1.5 + axis;
      // With a single tile between the faces both of them fold.
      sweep.faces[axis] = at_faces ? layout.side : 100 * layout.side;
      body.half_size[axis] = 0.25;
      block.window_first[axis] = tile_at[axis] * layout.side - 1;
      block.lowest[axis] = before ? layout.side : drift || below ? 0 : 1;
      block.highest[axis] = layout.side + (drift ? 1 : 0);
    }
    fill(at_faces);
    forget_results();
    scratch.cell[0] = 0;
    scratch.prepare(static_cast<std::size_t>(layout.window_array(quantities(node_vectors, axes))),
                    static_cast<std::size_t>(kernels.stencil_size), 0);
    sums.assign(static_cast<std::size_t>(layout.window_array(quantities(sum_vectors, axes))), 0.0);
    block.count = count;
    block.body = &body;
    block.sweep = &sweep;
    block.sums = sums.data();
    block.scratch = &scratch;
    kernels.locate(block);
  }

  double x(int axis, int i) const { return block.component(Attribute::position_x, axis)[i]; }
  /// Position of a node along an axis.
  double node_x(int axis, int from_tile) const {
    return sweep.origin[axis] + cell * (tile_at[axis] * kernels.layout.side + from_tile);
  }
  /// A linear field of position, one per quantity.
  double field(int which, const double* at) const {
    double value = 3 + which;
    for (int axis = 0; axis < axes; ++axis) value += slope(which, axis) * at[axis];
    return value;
  }
  static double slope(int which, int axis) { return 1.5 * which - 2 + axis; }

  void load_linear_fields() {
    const Layout& layout = kernels.layout;
    std::vector<std::vector<double>> nodes(static_cast<std::size_t>(layout.neighbours));
    Neighbours around{};
    for (int n = 0; n < layout.neighbours; ++n) {
      std::vector<double>& values = nodes[static_cast<std::size_t>(n)];
      values.resize(static_cast<std::size_t>(tile_array(quantities(node_vectors, axes))));
      for (int node = 0; node < tile_nodes; ++node) {
        double at[3] = {};
        for (int axis = 0, rest = n; axis < axes; ++axis, rest /= 3)
          at[axis] = node_x(axis, (rest % 3 - 1) * layout.side + node / layout.tile_stride(axis) % layout.side);
        for (int q = 0; q < quantities(node_vectors, axes); ++q)
          values[static_cast<std::size_t>(tile_array(q) + node)] = field(q, at);
      }
      around[n] = values.data();
    }
    kernels.load_window(scratch, around, ~0u >> (32 - quantities(node_vectors, axes)));
  }

  int axes;
  const TransferKernels& kernels;
  int tile_at[3] = {};
  SweepConstants sweep;
  BodyConstants body;
  TransferScratch<Number> scratch;
  Block block;
  AlignedDoubles sums;
  std::vector<std::vector<double>> arrays;
  std::vector<std::vector<float>> floats;

 private:
  /// What a stage does not write is no number, whatever a tile before this one left in the same memory.
  void forget_results() {
    const auto forget = [](BlockArray<Number>& result) {
      std::fill_n(result.data(), count, std::numeric_limits<Number>::quiet_NaN());
    };
    for (int ab = 0; ab < 9; ++ab) forget(scratch.gradient_of_grid()[ab]);
    for (int a = 0; a < 3; ++a) forget(scratch.acceleration[a]), forget(scratch.velocity[a]);
  }
  void fill(bool at_faces) {
    arrays.assign(attribute_count, std::vector<double>(count, 0.0));
    for (int a = 0; a < attribute_count; ++a)
      block.arrays[static_cast<std::size_t>(a)] = arrays[static_cast<std::size_t>(a)].data();
    block.arrays[static_cast<int>(Attribute::reference_volume)] = nullptr;
    floats.assign(attribute_count, std::vector<float>(count, 0.0F));
    for (int a = 0; a < attribute_count; ++a)
      block.floats[static_cast<std::size_t>(a)] = floats[static_cast<std::size_t>(a)].data();
    body.mass = 2;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0, 1), little(-0.2, 0.2);
    for (int i = 0; i < count; ++i) {
      for (int axis = 0; axis < axes; ++axis) {
        const double begin = begin_of_cells(kernels.layout.reach), least = -block.window_first[axis];
        double lowest = block.lowest[axis] + begin, highest = block.highest[axis] + 1 + begin;
        if (at_faces) lowest = std::max(lowest, least), highest = std::min(highest, least + sweep.faces[axis]);
        double place = lowest + (highest - lowest) * anywhere(random);
        if (i == 0) place = lowest;
        if (i == 1) place = lowest + 1e-9;
        if (i == 2) place = highest - 1e-9;
        if (i == 3) place = std::min(lowest + 0.5, highest - 1e-9);
        block.component(Attribute::position_x, axis)[i] =
            sweep.origin[axis] + cell * (block.window_first[axis] + place);
        block.component<Number>(Attribute::velocity_x, axis)[i] = static_cast<Number>(axis - 0.5);
      }
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          block.component<Number>(Attribute::deformation_xx, 3 * a + b)[i] =
              static_cast<Number>((wide && a == b ? 1.0 : 0.0) + little(random));
      for (int ab = 0; ab < 9; ++ab) {
        scratch.force[ab][i] = little(random);
        if constexpr (!wide) scratch.narrow_force[ab][i] = static_cast<Number>(scratch.force[ab][i]);
      }
    }
  }
};

class Shape : public testing::TestWithParam<std::tuple<Case, bool, Margin>> {
 protected:
  template <class Number>
  TileOfParticles<Number> tile() const {
    return {std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
  }
};

template <class Number>
void gather_linear_fields(TileOfParticles<Number> tile) {
  tile.load_linear_fields();
  tile.kernels.gather_acceleration(tile.block);
  tile.kernels.gather_motion(tile.block);
  for (int i = 0; i < tile.count; ++i) {
    double at[3] = {};
    for (int axis = 0; axis < tile.axes; ++axis) at[axis] = tile.x(axis, i);
    for (int a = 0; a < tile.axes; ++a) {
      EXPECT_NEAR(tile.scratch.acceleration[a][i], tile.field(quantity(node_acceleration, a, tile.axes), at),
                  rounding<Number>);
      EXPECT_NEAR(tile.scratch.velocity[a][i], tile.field(quantity(node_velocity, a, tile.axes), at),
                  rounding<Number>);
      for (int b = 0; b < tile.axes; ++b)
        EXPECT_NEAR(tile.scratch.gradient_of_grid()[a * tile.axes + b][i],
                    tile.slope(quantity(node_mapped_velocity, a, tile.axes), b), rounding<Number> / cell)
            << "particle " << i << ", component " << a << ", derivative " << b;
    }
  }
  EXPECT_FALSE(tile.scratch.trouble.left_window);
}

/// Mass and its centre, momentum, and forces that are in balance: their sum is none, their virial the particles'.
template <class Number>
void scatter_mass_momentum_and_forces(TileOfParticles<Number> tile) {
  tile.kernels.scatter_state(tile.block);
  const Layout& layout = tile.kernels.layout;
  const int axes = tile.axes;
  double mass = 0, centre[3] = {}, momentum[3] = {}, force[3] = {}, virial[9] = {};
  for (int node = 0; node < std::pow(layout.window_side, axes); ++node) {
    double at[3] = {};
    for (int axis = 0; axis < axes; ++axis)
      at[axis] = tile.node_x(axis, node / layout.window_stride(axis) % layout.window_side - layout.below);
    const auto sum = [&](int which) {
      return tile.sums[static_cast<std::size_t>(layout.window_array(which) + node)];
    };
    mass += sum(quantity_mass);
    for (int a = 0; a < axes; ++a) {
      centre[a] += sum(quantity_mass) * at[a];
      momentum[a] += sum(quantity(sum_momentum, a, axes));
      force[a] += sum(quantity(sum_force, a, axes));
      for (int b = 0; b < axes; ++b) virial[3 * a + b] -= sum(quantity(sum_force, a, axes)) * at[b];
    }
  }
  const double total = 2.0 * tile.count;
  EXPECT_NEAR(mass, total, rounding<Number> * total);
  for (int a = 0; a < axes; ++a) {
    double expected_centre = 0, expected_momentum = 0;
    for (int i = 0; i < tile.count; ++i) {
      expected_centre += 2 * tile.x(a, i);
      expected_momentum +=
          2 * static_cast<double>(tile.block.template component<Number>(Attribute::velocity_x, a)[i]);
    }
    EXPECT_NEAR(centre[a], expected_centre, rounding<Number> * total * 100);
    EXPECT_NEAR(momentum[a], expected_momentum, rounding<Number> * total);
    EXPECT_NEAR(force[a], 0, rounding<Number> * total);
    for (int b = 0; b < axes; ++b) {
      double expected = 0;
      // Forces were given over the cell size.
      for (int i = 0; i < tile.count; ++i) expected += cell * tile.scratch.force[a * axes + b][i];
      EXPECT_NEAR(virial[3 * a + b], expected, rounding<Number> * total * 100);
    }
  }
}

TEST_P(Shape, GathersLinearFieldsExactly) {
  gather_linear_fields(tile<double>());
  gather_linear_fields(tile<float>());
}

TEST_P(Shape, ScattersMassCentreMomentumAndVirial) {
  scatter_mass_momentum_and_forces(tile<double>());
  scatter_mass_momentum_and_forces(tile<float>());
}

std::string name_of(const testing::TestParamInfo<std::tuple<Case, bool, Margin>>& tested) {
  static const char* const names[] = {"", "Bar", "PlaneStress", "PlaneStrain", "Axisymmetric", "Solid"};
  const Case& c = std::get<0>(tested.param);
  return c.shape + names[static_cast<int>(c.dimension)] + (std::get<1>(tested.param) ? "AtFaces" : "Inside") +
         (std::get<2>(tested.param) == Margin::none ? "WithoutMargin" : "");
}

INSTANTIATE_TEST_SUITE_P(Registry, Shape,
                         testing::Combine(testing::ValuesIn(cases()), testing::Bool(),
                                          testing::Values(Margin::one_cell, Margin::none)),
                         name_of);

}  // namespace
}  // namespace trajan::shape_test
