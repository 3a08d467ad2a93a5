#pragma once

#include "solver/cost/rates.h"

namespace trajan {

/// Measures the rates of this machine by runs of small blocks: explicit steps of every dimension, shape function
/// and scheme, every transfer, every law, contact, samples, iterations of Newton's method and modes. Takes about
/// `seconds` of one core; what other programs do on it does not count. What cannot be combined has no rate.
Rates measure_rates(double seconds);

}  // namespace trajan
