#pragma once

#include <string>

#include "client/table.h"
#include "trajan/v1/estimates.pb.h"

namespace trajan::client {

/// "MODEL", "PROBE", "HISTORY"
std::string source_name(v1::Figure::Source source);

/// One row for each figure, with its interval and source.
Table figure_table(const v1::Estimate& estimate);
/// Errors of measures.
Table error_table(const v1::Estimate& estimate);
/// What other settings would do.
Table neighbour_table(const v1::Estimate& estimate);

/// Jobs, what was expected of them and what they took.
Table audit_table(const v1::Audit& audit);
Table coverage_table(const v1::Audit& audit);

/// In a line: "0.21 s (0.15 to 0.29, MODEL), 0.18 core-seconds, 1.2 MiB".
std::string describe_expectation(const v1::Estimate& estimate);

}  // namespace trajan::client
