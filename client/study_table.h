#pragma once

#include <iosfwd>

#include "client/table.h"
#include "trajan/v1/studies.pb.h"

namespace trajan::client {

/// One row for each run: its settings, its measures with their errors against exact values, and what it took.
Table run_table(const v1::Study& study);

/// One row for each measure of a ladder: order, band and what smaller cells approach.
Table convergence_table(const v1::Study& study);

/// One row for each tolerance: the cheapest run of a tradeoff.
Table cheapest_table(const v1::Study& study);

/// Of a target: value and band, the settings that gave it, what it took. Nothing if no run has succeeded.
void print_answer(std::ostream& out, const v1::Study& study);

/// All that a study has found. As JSON it is the message itself; other formats have the table of runs, and people
/// read what follows from it below.
void print_study_table(std::ostream& out, const v1::Study& study, OutputFormat output);

}  // namespace trajan::client
