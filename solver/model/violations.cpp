#include "solver/model/violations.h"

#include <cmath>

#include "solver/model/names.h"

namespace trajan {

bool Violations::add(std::string path, std::string value, std::string problem, std::string remedy) {
  if (violations_.size() < most) {
    violations_.push_back({std::move(path), shortened(value), std::move(problem), std::move(remedy)});
  }
  return false;
}

bool Violations::finite(const std::string& path, double value) {
  return std::isfinite(value) || add(path, number_text(value), "not a finite number", "give a finite number");
}

bool Violations::positive(const std::string& path, double value) {
  return (std::isfinite(value) && value > 0) ||
         add(path, number_text(value), "must be finite and greater than 0", "give a positive number");
}

bool Violations::not_negative(const std::string& path, double value) {
  return (std::isfinite(value) && value >= 0) ||
         add(path, number_text(value), "must be finite and not negative", "give 0 or a positive number");
}

bool Violations::within(const std::string& path, double value, double lowest, double highest) {
  return (value >= lowest && value <= highest) ||
         add(path, number_text(value), "out of range",
             "give a value from " + number_text(lowest) + " to " + number_text(highest));
}

std::string indexed(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

}  // namespace trajan
