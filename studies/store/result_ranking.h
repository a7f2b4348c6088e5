// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "studies/document/study_document.h"
#include "studies/store/result_store.h"

namespace hapticell::studies {

/// The best variants of a store: feasible ones first by objective; then, where fewer are feasible, the others by how
/// little they miss. Equal ones by number.
Expected<std::vector<ResultRow>> bestRows(const ResultStore& store, std::size_t count);

/// The Pareto front over the objectives of the document: feasible variants that no other feasible one beats in one
/// objective without being worse in another. By the first objective. Of equal ones the first by number stays.
Expected<std::vector<ResultRow>> paretoRows(const ResultStore& store, const StudyDocument& document);

/// The same of rows in memory, as their indices; `columns` are those of the store. Errors: no objectives, or one that is
/// no column.
Expected<std::vector<std::size_t>> paretoIndices(const std::vector<ResultRow>& rows, const std::vector<Column>& columns,
                                                 const std::vector<Objective>& objectives);
/// The index of the best row by the order of bestRows(); nothing without rows.
std::optional<std::size_t> bestIndex(const std::vector<ResultRow>& rows);

/// The table as CSV: a header line, a row a variant, `.` as decimal point; numbers with all digits that they need.
Expected<std::string> csvOf(const ResultStore& store);

}  // namespace hapticell::studies
