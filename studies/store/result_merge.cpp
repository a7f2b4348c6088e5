// SPDX-License-Identifier: Apache-2.0
#include "studies/store/result_merge.h"

#include <map>

namespace hapticell::studies {

namespace fs = std::filesystem;

namespace {

/// Rows that are written at once. Half: more transactions; twice: more memory.
constexpr std::size_t kBatch = 5000;

/// Copies all of a part's rows and units.
Expected<std::int64_t> copyPart(const ResultStore& part, const std::set<std::int64_t>& units, ResultStore& target) {
  std::vector<ResultRow> rows;
  std::int64_t count = 0;
  const auto flush = [&](const std::vector<std::int64_t>& complete) -> Expected<void> {
    HAPTICELL_TRY(target.add(rows, complete));
    count += static_cast<std::int64_t>(rows.size());
    rows.clear();
    return {};
  };
  HAPTICELL_TRY(part.forEachRow([&](const ResultRow& row) -> Expected<void> {
    rows.push_back(row);
    return rows.size() < kBatch ? Expected<void>() : flush({});
  }));
  HAPTICELL_TRY(flush({units.begin(), units.end()}));
  return count;
}

Expected<MergeSummary> fill(const std::vector<fs::path>& parts, ResultStore& target, bool may_lack) {
  MergeSummary summary;
  std::map<std::int64_t, fs::path> owners;
  for (const fs::path& file : parts) {
    const auto part = ResultStore::open(file, false);
    HAPTICELL_TRY(part);
    HAPTICELL_TRY(checkSameStudy(part->head(), target.head(), file));
    const auto units = part->completeUnits();
    HAPTICELL_TRY(units);
    for (const std::int64_t unit : *units) {
      const auto owner = owners.emplace(unit, file);
      if (owner.second) continue;
      return makeError({.file = file.string(),
                        .found = Text("variant %1 is also in %2", unit * part->head().per_unit,
                                      owner.first->second.string()),
                        .expected = "each chunk once",
                        .fix = "Leave one of the two files out."});
    }
    const auto rows = copyPart(*part, *units, target);
    HAPTICELL_TRY(rows);
    summary.rows += *rows;
    const auto runs = part->runs();
    HAPTICELL_TRY(runs);
    for (const RunRecord& run : *runs) {
      HAPTICELL_TRY(target.beginRun(run));
    }
  }
  summary.missing_units = target.head().units - static_cast<std::int64_t>(owners.size());
  if (summary.missing_units > 0 && !may_lack)
    return makeError({.file = target.file().string(),
                      .found = Text("%1 of %2 variants or searches are in no part", summary.missing_units,
                                    target.head().units),
                      .expected = "all of them",
                      .fix = "Add the missing chunks, or merge with --partial and let study run complete the result."});
  return summary;
}

}  // namespace

Expected<MergeSummary> mergeResults(const std::vector<fs::path>& parts, const fs::path& target, bool may_lack) {
  if (parts.empty()) return makeError({.found = "no parts to merge", .expected = "at least one results file"});
  const auto first = ResultStore::open(parts.front(), false);
  HAPTICELL_TRY(first);
  auto store = ResultStore::create(target, first->head());
  HAPTICELL_TRY(store);
  auto summary = fill(parts, *store, may_lack);
  if (!summary) {
    std::error_code ignored;
    fs::remove(target, ignored);
  }
  return summary;
}

}  // namespace hapticell::studies
