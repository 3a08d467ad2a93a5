#include "client/spectrum.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace trajan::client {

Spectrum amplitude_spectrum(std::span<const double> time, std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  std::vector<double> windowed(values.size());
  double window_sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double window = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / count);
    windowed[i] = window * (values[i] - mean);
    window_sum += window;
  }
  std::vector<std::complex<double>> bins;
  Eigen::FFT<double>().fwd(bins, windowed);
  const double duration = (time.back() - time.front()) * count / (count - 1);
  Spectrum spectrum;
  for (std::size_t i = 0; i <= values.size() / 2; ++i) {
    spectrum.frequency.push_back(static_cast<double>(i) / duration);
    spectrum.amplitude.push_back(2 * std::abs(bins[i]) / window_sum);
  }
  return spectrum;
}

}  // namespace trajan::client
