#include "solver/simulation/make_scratch.h"

#include <algorithm>

#include "solver/transfers/transfer.h"

namespace trajan {
namespace {

template <class Number>
std::unique_ptr<TransferScratch<Number>> make(const Model& model, const TransferKernels& transfer) {
  const Transfer& kind = *find_transfer(model.numerics.transfer);
  const int axes = grid_axes(model.dimension);
  auto scratch = std::make_unique<TransferScratch<Number>>();
  scratch->prepare(static_cast<std::size_t>(quantities(kind.node_vectors, axes) * transfer.layout.window_nodes),
                   static_cast<std::size_t>(transfer.stencil_size),
                   kind.affine ? static_cast<std::size_t>(axes) : 0);
  return scratch;
}

}  // namespace

std::unique_ptr<Scratch> make_scratch(const Model& model, const TransferKernels& transfer,
                                      std::span<const BodyParticles> bodies) {
  if (model.numerics.precision != float_precision) return make<double>(model, transfer);
  auto scratch = make<float>(model, transfer);
  for (const BodyParticles& body : bodies)
    scratch->state.resize(std::max(scratch->state.size(), body.narrow_state.size()));
  return scratch;
}

}  // namespace trajan
