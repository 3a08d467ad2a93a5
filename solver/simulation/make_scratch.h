#pragma once

#include <memory>
#include <span>

#include "solver/schemes/kernels.h"
#include "solver/simulation/particles.h"

namespace trajan {

/// Working memory of a thread, in the number type that the model's particles have.
std::unique_ptr<Scratch> make_scratch(const Model& model, const TransferKernels& transfer,
                                      std::span<const BodyParticles> bodies);

}  // namespace trajan
