// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "studies/store/result_store.h"

namespace hapticell::cli {

/// The version that rows of studies name: the program's and its commit.
std::string studyVersion();

/// `number`, `values{}`, `results{}`, `feasible`, `violation`, `objective`, and `note` where there is one.
nlohmann::ordered_json rowJson(const studies::ResultHead& head, const studies::ResultRow& row);
nlohmann::ordered_json rowsJson(const studies::ResultHead& head, const std::vector<studies::ResultRow>& rows);

/// What a results file holds: counts, least, mean and greatest of each column, runs.
Expected<nlohmann::ordered_json> summaryJson(const studies::ResultStore& store);

}  // namespace hapticell::cli
