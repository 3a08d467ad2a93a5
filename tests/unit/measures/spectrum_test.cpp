#include "solver/measures/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace trajan {
namespace {

constexpr double tau = 2 * std::numbers::pi;

std::vector<double> sampled(int samples, double duration, const std::function<double(double)>& signal) {
  std::vector<double> values;
  for (int i = 0; i < samples; ++i) values.push_back(signal(duration * i / (samples - 1)));
  return values;
}

/// Over one unit of time, so that frequencies and errors are in bins.
double frequency_of(const std::function<double(double)>& signal, int samples = 401, double lowest = 0,
                    double highest = 200) {
  return dominant_frequency(sampled(samples, 1, signal), 1.0 / (samples - 1), lowest, highest);
}

/// The parabola through the logarithms of three points a quarter bin apart on the main lobe of the
/// Blackman-Harris window is off by at most a few 1e-5 bins.
constexpr double interpolation = 1e-4;

TEST(DominantFrequency, OfASineIsFoundBetweenBins) {
  for (double frequency = 4; frequency < 100; frequency *= 1.137) {
    for (double phase = 0; phase < tau; phase += 0.7) {
      EXPECT_NEAR(frequency_of([&](double t) { return std::sin(tau * frequency * t + phase); }), frequency,
                  2 * interpolation)
          << frequency << " " << phase;
    }
  }
}

TEST(DominantFrequency, IsNotMovedByAMeanHoweverLarge) {
  EXPECT_NEAR(frequency_of([](double t) { return 1000 + std::cos(tau * 7.3 * t); }), 7.3, interpolation);
}

TEST(DominantFrequency, IsThatOfTheLargestOfSeveralSines) {
  const auto signal = [](double t) {
    return 0.8 * std::sin(tau * 11.37 * t) + std::sin(tau * 31.41 * t + 1) + 0.9 * std::sin(tau * 77.7 * t);
  };
  EXPECT_NEAR(frequency_of(signal), 31.41, interpolation);
  EXPECT_NEAR(frequency_of(signal, 401, 0, 25), 11.37, interpolation);
  EXPECT_NEAR(frequency_of(signal, 401, 50, 200), 77.7, interpolation);
}

TEST(DominantFrequency, OfADampedSineIsThatOfItsOscillation) {
  // The spectrum of a sine whose amplitude falls by 1/e over the signal stays symmetric about its peak
  // up to the mirror image, far below.
  EXPECT_NEAR(frequency_of([](double t) { return std::exp(-t) * std::sin(tau * 12.34 * t); }), 12.34, 1e-3);
}

TEST(DominantFrequency, OfFewPeriodsIsAsGoodAsItsDescriptionSays) {
  EXPECT_NEAR(frequency_of([](double t) { return std::cos(tau * 3 * t); }), 3, 3e-3);
  EXPECT_NEAR(frequency_of([](double t) { return std::cos(tau * 3.5 * t); }), 3.5, 3e-4);
}

TEST(DominantFrequency, IsInCyclesPerTimeOfTheGivenInterval) {
  const auto values = sampled(1001, 50, [](double t) { return std::sin(tau * 0.777 * t); });
  // Bins of 1/50.
  EXPECT_NEAR(dominant_frequency(values, 0.05, 0, 10), 0.777, interpolation / 50);
}

TEST(DominantFrequency, OfWhatDoesNotVaryIsZero) {
  EXPECT_EQ(frequency_of([](double) { return 0; }), 0);
  EXPECT_EQ(frequency_of([](double) { return 0.1; }), 0);
}

TEST(DominantFrequency, StaysWithinTheAskedRange) {
  const auto signal = [](double t) { return std::sin(tau * 20 * t); };
  // The flank of the peak is all that lies in these ranges.
  EXPECT_EQ(frequency_of(signal, 401, 21, 22), 21);
  EXPECT_EQ(frequency_of(signal, 401, 18, 19), 19);
  const double narrow = frequency_of(signal, 401, 19.99, 20.01);
  EXPECT_NEAR(narrow, 20, interpolation);
}

TEST(DominantFrequency, OfTheFewestSamplesIsFound) {
  EXPECT_NEAR(frequency_of([](double t) { return std::sin(tau * 4.2 * t); }, 16, 0, 7.5), 4.2, 1e-2);
}

}  // namespace
}  // namespace trajan
