#include "solver/measures/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/unit/model/sample_scene.h"

namespace trajan {
namespace {

constexpr double end_time = 10;

/// The measure of a history of energies.work = history(t), with other columns that are all 99.
MeasureValue measured(const MeasureDefinition& definition, const std::function<double(double)>& history,
                      std::int32_t samples = 200) {
  Scene scene = sample_scene();
  scene.analysis.end_time = end_time;
  scene.outputs.samples = samples;
  scene.measures = {definition};
  const Model model = validate(scene);
  const std::size_t columns = history_columns(model).size();
  std::vector<double> time, values;
  for (std::int32_t i = 0; i <= samples; ++i) {
    time.push_back(i * end_time / samples);
    values.insert(values.end(), columns, 99);
    values[values.size() - columns + model.measures.at(0).column] = history(time.back());
  }
  return evaluate(model, time, values).at(0);
}

template <typename Kind>
MeasureDefinition measure_of_work(Kind kind) {
  MeasureDefinition definition;
  definition.name = "work";
  definition.quantity = "energies.work";
  definition.kind = kind;
  return definition;
}

TEST(Measure, FinalIsTheLastSampleThatCounts) {
  MeasureDefinition definition = measure_of_work(FinalValue{});
  EXPECT_EQ(measured(definition, [](double t) { return t; }).value, 10);
  definition.until = 4.99;
  EXPECT_DOUBLE_EQ(measured(definition, [](double t) { return t; }).value, 4.95);
  definition.until = 5;
  EXPECT_DOUBLE_EQ(measured(definition, [](double t) { return t; }).value, 5);
}

TEST(Measure, ExtremeIsLargestInItsSense) {
  const auto history = [](double t) { return t < 5 ? t : 2 * (5 - t); };
  EXPECT_EQ(measured(measure_of_work(ExtremeValue{}), history).value, -10);
  EXPECT_EQ(measured(measure_of_work(ExtremeValue{ExtremeKind::minimum}), history).value, -10);
  EXPECT_DOUBLE_EQ(measured(measure_of_work(ExtremeValue{ExtremeKind::maximum}), history).value, 4.95);
  MeasureDefinition late = measure_of_work(ExtremeValue{ExtremeKind::maximum});
  late.from = 6;
  EXPECT_DOUBLE_EQ(measured(late, history).value, -2);
}

TEST(Measure, MeanIsOverTime) {
  EXPECT_NEAR(measured(measure_of_work(MeanValue{}), [](double t) { return 3 * t + 1; }).value, 16, 1e-12);
  MeasureDefinition one = measure_of_work(MeanValue{});
  one.from = one.until.emplace(5);
  EXPECT_DOUBLE_EQ(measured(one, [](double t) { return 3 * t; }).value, 15);
}

TEST(Measure, MeanConvergesWithTheSquareOfTheInterval) {
  const auto error = [](std::int32_t samples) {
    return std::abs(measured(
                        measure_of_work(MeanValue{}), [](double t) { return t * t * t; }, samples)
                        .value -
                    250);
  };
  // The error of the trapezoid rule for a cubic is exactly proportional to the square.
  EXPECT_NEAR(std::log2(error(50) / error(100)), 2, 1e-6);
}

TEST(Measure, DominantFrequencyIsInCyclesPerTime) {
  const auto history = [](double t) { return std::sin(2 * std::numbers::pi * 1.2345 * t); };
  // Bins of 0.1, interpolated to 1e-4 of them.
  EXPECT_NEAR(measured(measure_of_work(DominantFrequency{}), history).value, 1.2345, 1e-5);
}

TEST(Measure, DeviationIsTheLargestDistanceInItsScale) {
  const MeasureDefinition definition = measure_of_work(Deviation{"2 * t", 4});
  const MeasureValue deviation = measured(definition, [](double t) { return 2 * t + (t == 5 ? -1 : 0.5); });
  EXPECT_DOUBLE_EQ(deviation.value, 0.25);
  EXPECT_EQ(deviation.exact, 0);
  EXPECT_EQ(deviation.error, deviation.value);
}

TEST(Measure, DeviationFromWhatIsNotDefinedIsInfinite) {
  // At a sample that lies between the times at which validation looks at formulas.
  EXPECT_EQ(measured(measure_of_work(Deviation{"sqrt(abs(t - 3) - 0.001)", 1}), [](double) { return 0; }).value,
            std::numeric_limits<double>::infinity());
}

TEST(Measure, ErrorIsRelativeToTheExactValueUnlessThatIsZero) {
  MeasureDefinition definition = measure_of_work(FinalValue{});
  EXPECT_FALSE(measured(definition, [](double) { return 3; }).error);
  definition.exact = "-L / 2";
  definition.tolerance = 0.5;
  definition.source = "a book";
  const MeasureValue relative = measured(definition, [](double) { return -5; });
  EXPECT_DOUBLE_EQ(relative.error.value(), -0.25);
  EXPECT_EQ(relative.exact, -4);
  EXPECT_EQ(relative.tolerance, 0.5);
  EXPECT_EQ(relative.source, "a book");
  EXPECT_EQ(relative.quantity, "energies.work");
  definition.exact = "0";
  EXPECT_EQ(measured(definition, [](double) { return -5; }).error, -5);
}

}  // namespace
}  // namespace trajan
