#pragma once

#include <string>
#include <vector>

#include "server/store_database.h"
#include "trajan/v1/studies.pb.h"

/// What runs taught about families of scenes; kept when the jobs are removed. Changes must run inside
/// Store::commit.
namespace trajan::store {

/// Of a job that has succeeded: a finding for each of its measures, with the error where the exact value is known.
void keep_findings(Database& database, const v1::Job& job);

/// Adds to the findings of a study's runs what the study says of their errors.
void keep_findings(Database& database, const v1::Study& study);

/// Of a family (see server/scene_digest.h) on a machine (see Cost), or on all machines if that is empty.
std::vector<v1::Finding> findings(Database& database, const std::string& family, const std::string& machine);

}  // namespace trajan::store
