#pragma once

#include <filesystem>

/// The measuring commands of trajand, which the server runs as processes (server/measurer.h).
namespace trajan::measuring {

inline constexpr const char* question_file = "question";
inline constexpr const char* answer_file = "answer";

/// Measures this machine at low priority, about eight seconds of one core, and leaves a v1::Calibration in the
/// directory's answer file. Returns the exit code.
int calibrate(const std::filesystem::path& directory);

/// Runs the v1::Scene in the question file for at most so many seconds of wall time and leaves a v1::Trial.
/// Returns the exit code.
int try_scene(const std::filesystem::path& directory, double seconds, int threads);

}  // namespace trajan::measuring
