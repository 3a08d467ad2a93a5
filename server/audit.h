#pragma once

#include <optional>
#include <vector>

#include "trajan/v1/estimates.pb.h"

/// Estimates against what jobs took.
namespace trajan {

/// For each figure, of all sources together and of each by itself, how often it was right.
google::protobuf::RepeatedPtrField<v1::Coverage> coverages(const std::vector<v1::Prediction>& predictions);

/// The factor by which nine of ten wall times of the source were off at most, either way; nothing if there are too
/// few to say so.
std::optional<double> usual_factor(const std::vector<v1::Prediction>& predictions, v1::Figure::Source source);

}  // namespace trajan
