#pragma once

#include <span>
#include <vector>

namespace trajan::client {

/// Amplitudes over frequencies from 0 to half the sampling rate.
struct Spectrum {
  std::vector<double> frequency;
  std::vector<double> amplitude;
};

/// The one-sided amplitude spectrum of evenly spaced samples, mean removed, under a Hann window that is
/// scaled so that a sine of amplitude A between the window's ends has the peak A. At least 4 samples.
Spectrum amplitude_spectrum(std::span<const double> time, std::span<const double> values);

}  // namespace trajan::client
