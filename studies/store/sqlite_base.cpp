// SPDX-License-Identifier: Apache-2.0
#include "studies/store/sqlite_base.h"

#include <sqlite3.h>

#include "geometry/system/regular_file.h"

namespace hapticell::studies {

namespace fs = std::filesystem;

namespace {

/// ms that a writer waits for another one: a commit takes some. Half: two writers on a slow disk may fail; twice: a
/// program that hangs is noticed later.
constexpr int kPatience = 10'000;

}  // namespace

void Statement::Close::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Statement::bind(int place, double value) {
  sqlite3_bind_double(statement_.get(), place + 1, value);
}

void Statement::bind(int place, std::int64_t value) {
  sqlite3_bind_int64(statement_.get(), place + 1, value);
}

void Statement::bind(int place, const std::string& value) {
  sqlite3_bind_text64(statement_.get(), place + 1, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

void Statement::bindNull(int place) {
  sqlite3_bind_null(statement_.get(), place + 1);
}

bool Statement::isNull(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

double Statement::number(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::int64_t Statement::whole(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text != nullptr ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)))
                         : std::string();
}

void SqliteBase::Close::operator()(sqlite3* base) const {
  sqlite3_close_v2(base);
}

Error SqliteBase::failure() const {
  const int code = sqlite3_errcode(base_.get());
  Error error{.file = file_.string(), .found = Text("the file could not be used (%1)", sqlite3_errmsg(base_.get()))};
  if (code == SQLITE_FULL) {
    error.found = "the disk is full";
    error.fix = "Make room and run the same command again: it continues with the missing variants.";
  } else if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT) {
    error.expected = "the results of a study";
  } else if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
    error.found = "another program writes into this file";
    error.fix = "Wait until it has ended, or choose another file.";
  }
  return error;
}

Expected<SqliteBase> SqliteBase::open(const fs::path& file, Mode mode) {
  std::error_code missing;
  if (mode != Mode::kCreate || fs::exists(file, missing)) {
    HAPTICELL_TRY(geometry::checkRegularFile(file, ~std::uintmax_t{0}));
  }
  int flags = SQLITE_OPEN_NOMUTEX;
  if (mode == Mode::kRead) flags |= SQLITE_OPEN_READONLY;
  if (mode != Mode::kRead) flags |= SQLITE_OPEN_READWRITE;
  if (mode == Mode::kCreate) flags |= SQLITE_OPEN_CREATE;
  return openAs(file.c_str(), file, flags);
}

Expected<SqliteBase> SqliteBase::inMemory() {
  return openAs(":memory:", "memory", SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
}

Expected<SqliteBase> SqliteBase::openAs(const char* name, const fs::path& shown, int flags) {
  sqlite3* raw = nullptr;
  const int opened = sqlite3_open_v2(name, &raw, flags, nullptr);
  SqliteBase base;
  base.base_.reset(raw);
  base.file_ = shown;
  if (opened != SQLITE_OK) return makeError(base.failure());
  sqlite3_extended_result_codes(raw, 0);
  sqlite3_busy_timeout(raw, kPatience);
  return base;
}

Expected<void> SqliteBase::run(const std::string& sql) {
  if (sqlite3_exec(base_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return makeError(failure());
  return {};
}

Expected<Statement> SqliteBase::prepare(const std::string& sql) const {
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v2(base_.get(), sql.data(), static_cast<int>(sql.size()), &raw, nullptr) != SQLITE_OK)
    return makeError(failure());
  return Statement(raw);
}

Expected<void> SqliteBase::forEach(Statement& statement,
                                   const std::function<Expected<void>(const Statement&)>& each) const {
  Expected<void> outcome;
  int code = sqlite3_step(statement.raw());
  for (; code == SQLITE_ROW && outcome; code = sqlite3_step(statement.raw())) outcome = each(statement);
  if (outcome && code != SQLITE_DONE) outcome = makeError(failure());
  sqlite3_reset(statement.raw());
  return outcome;
}

Expected<void> SqliteBase::step(Statement& statement) const {
  const bool done = sqlite3_step(statement.raw()) == SQLITE_DONE;
  Expected<void> outcome;
  if (!done) outcome = makeError(failure());
  sqlite3_reset(statement.raw());
  return outcome;
}

Expected<void> SqliteBase::atOnce(const std::function<Expected<void>()>& work) {
  HAPTICELL_TRY(run("BEGIN IMMEDIATE"));
  Expected<void> outcome = work();
  if (outcome) outcome = run("COMMIT");
  if (!outcome) sqlite3_exec(base_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
  return outcome;
}

std::string quotedColumn(std::string_view name) {
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace hapticell::studies
