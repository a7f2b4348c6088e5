// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "studies/questions/question.h"
#include "studies/variants/value_range.h"

namespace hapticell::studies {

/// The result of one variant. Holds no times, so that rows are equal to the bit wherever they were made.
struct ResultRow {
  std::int64_t number = 0;
  std::vector<Value> values;    ///< One a variation.
  std::vector<Answer> answers;  ///< One a column.
  bool feasible = false;        ///< All requirements are met, and all that they need was answered.
  double violation = 0.0;       ///< By how much requirements are missed, added up; 0 if feasible.
  Answer objective;             ///< The weighted sum, less is better; empty where a part has no answer.
  std::string note;             ///< Why something has no answer; empty: nothing.
  bool operator==(const ResultRow&) const = default;
};

/// What a results file is about, and what its rows must agree in.
struct ResultHead {
  std::string name;     ///< Of the study.
  std::string study;    ///< Text of the document.
  std::string file;     ///< Absolute path of the document when it was run.
  std::string digest;   ///< Of the document and of all files that it needs.
  std::string version;  ///< Of the program.
  std::uint64_t seed = 0;
  std::int64_t variants = 0;  ///< In all (of a search: at most).
  std::int64_t units = 0;
  std::int64_t per_unit = 1;
  std::vector<Column> values;  ///< What varies.
  std::vector<Column> answers;
};

/// One run that added rows. Times and machines are here alone.
struct RunRecord {
  std::int64_t chunk = 1, chunks = 1;
  std::string host, started;  ///< ISO 8601, UTC.
  double seconds = 0.0;
  std::int64_t jobs = 1;
  std::int64_t rows = 0;  ///< That it made.
  bool complete = false;
};

}  // namespace hapticell::studies
