#include "solver/measures/spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace trajan {

namespace {

/// Bins of the padded spectrum per bin of the signal: interpolation by a parabola is then good to 1e-4 of
/// them.
constexpr std::size_t padding = 4;

std::vector<double> blackman_harris(std::size_t size) {
  std::vector<double> window(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double s = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size - 1);
    window[i] = 0.35875 - 0.48829 * std::cos(s) + 0.14128 * std::cos(2 * s) - 0.01168 * std::cos(3 * s);
  }
  return window;
}

/// The values without their mean, windowed and padded to a power of two. The mean is weighted with the
/// window, so that nothing is left at frequency 0 to leak into its neighbours.
std::vector<double> prepared(std::span<const double> values) {
  const std::vector<double> window = blackman_harris(values.size());
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += window[i] * values[i];
    weight += window[i];
  }
  std::vector<double> signal(std::bit_ceil(padding * values.size()), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) signal[i] = window[i] * (values[i] - sum / weight);
  return signal;
}

std::vector<double> amplitudes(std::vector<double> signal) {
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> spectrum;
  transform.fwd(spectrum, signal);
  std::vector<double> magnitudes(spectrum.size());
  std::ranges::transform(spectrum, magnitudes.begin(), [](std::complex<double> value) { return std::abs(value); });
  return magnitudes;
}

/// Offset, in bins, of the top of the parabola through the logarithms of three neighbours.
double peak_offset(double before, double at, double after) {
  if (before <= 0 || after <= 0) return 0;
  const double a = std::log(before), b = std::log(at), c = std::log(after);
  const double curvature = a - 2 * b + c;
  return curvature < 0 ? (a - c) / (2 * curvature) : 0;
}

}  // namespace

double dominant_frequency(std::span<const double> values, double interval, double lowest, double highest) {
  const auto [least, most] = std::ranges::minmax(values);
  // What is left of a constant after its mean is removed is rounding.
  if (most - least <= 1e-13 * std::max(std::abs(least), std::abs(most))) return 0;
  const std::vector<double> signal = prepared(values);
  const double bin = 1 / (interval * static_cast<double>(signal.size()));
  const std::vector<double> amplitude = amplitudes(signal);

  const std::size_t end = amplitude.size() - 1;
  const auto clipped = [&](double index) {
    return static_cast<std::size_t>(std::clamp(index, 1.0, static_cast<double>(end - 1)));
  };
  const std::size_t first = clipped(std::floor(lowest / bin));
  const std::size_t last = clipped(std::ceil(highest / bin));
  const auto is_peak = [&](std::size_t k) {
    return amplitude[k] >= amplitude[k - 1] && amplitude[k] >= amplitude[k + 1];
  };
  std::size_t best = 0;
  for (std::size_t k = first; k <= last; ++k) {
    if (is_peak(k) && (best == 0 || amplitude[k] > amplitude[best])) best = k;
  }
  if (best == 0) return amplitude[first] >= amplitude[last] ? lowest : highest;
  const double offset = peak_offset(amplitude[best - 1], amplitude[best], amplitude[best + 1]);
  return std::clamp((static_cast<double>(best) + offset) * bin, lowest, highest);
}

}  // namespace trajan
