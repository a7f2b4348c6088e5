// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "studies/store/result_row.h"
#include "studies/store/sqlite_base.h"

namespace hapticell::studies {

/// The results of a study in one SQLite file: table `variants` with a row a variant (its values, its answers, seed and
/// program version), `head` (what it is about) and `runs` (times and machines; not compared). Rows are added in
/// transactions, so after a kill or a full disk the file holds whole rows. One thread at a time.
class ResultStore {
 public:
  /// Makes the file. Error: it exists.
  static Expected<ResultStore> create(const std::filesystem::path& file, const ResultHead& head);
  /// Results in no file, for who only wants the rows: gone with this object.
  static Expected<ResultStore> inMemory(const ResultHead& head);
  /// Opens a file that create() made, to add rows or only to read. Errors also: a newer format.
  static Expected<ResultStore> open(const std::filesystem::path& file, bool for_writing);
  /// Opens it to continue, or makes it. Errors: it is of another study, of changed files, or of another version of the
  /// program: its rows could not be compared with new ones.
  static Expected<ResultStore> openOrCreate(const std::filesystem::path& file, const ResultHead& head);

  const ResultHead& head() const { return head_; }
  const std::filesystem::path& file() const { return base_.file(); }

  /// Adds rows and the units that are complete with them, all or nothing. A variant that is there is replaced.
  Expected<void> add(const std::vector<ResultRow>& rows, const std::vector<std::int64_t>& complete_units);
  Expected<std::set<std::int64_t>> completeUnits() const;
  Expected<std::int64_t> rowCount() const;
  /// The rows by number.
  Expected<void> forEachRow(const std::function<Expected<void>(const ResultRow&)>& each) const;
  Expected<std::optional<ResultRow>> row(std::int64_t number) const;

  /// Notes a run; gives its id for finishRun().
  Expected<std::int64_t> beginRun(const RunRecord& run);
  Expected<void> finishRun(std::int64_t id, const RunRecord& run);
  Expected<std::vector<RunRecord>> runs() const;

 private:
  ResultStore(SqliteBase base, ResultHead head) : base_(std::move(base)), head_(std::move(head)) {}
  Expected<void> writeHead();
  Expected<void> readHead();
  std::string columnList() const;
  ResultRow rowOf(const Statement& statement) const;

  SqliteBase base_;
  ResultHead head_;
};

/// The error for rows that were made otherwise; nothing where they agree. `file` is that of `found`.
Expected<void> checkSameStudy(const ResultHead& found, const ResultHead& expected, const std::filesystem::path& file);

}  // namespace hapticell::studies
