// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace hapticell::studies {

/// A statement that is ready to run; SQLite's own, closed with this object. Places and columns count from 0.
class Statement {
 public:
  explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}
  void bind(int place, double value);
  void bind(int place, std::int64_t value);
  void bind(int place, const std::string& value);
  void bindNull(int place);
  bool isNull(int column) const;
  double number(int column) const;
  std::int64_t whole(int column) const;
  std::string text(int column) const;
  sqlite3_stmt* raw() const { return statement_.get(); }

 private:
  struct Close {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Close> statement_;
};

/// A SQLite file. One thread at a time. Every error names the file and says what the disk or SQLite said.
class SqliteBase {
 public:
  enum class Mode { kRead, kWrite, kCreate };
  /// kCreate makes the file if it does not exist. Errors: no such file, no SQLite file, no rights.
  static Expected<SqliteBase> open(const std::filesystem::path& file, Mode mode);

  /// A base in memory that no file has: gone with this object. Errors name "memory".
  static Expected<SqliteBase> inMemory();

  Expected<void> run(const std::string& sql);
  Expected<Statement> prepare(const std::string& sql) const;
  /// Runs a statement that gives rows, once for each of them; an error of `each` ends it.
  Expected<void> forEach(Statement& statement, const std::function<Expected<void>(const Statement&)>& each) const;
  /// Runs a statement that gives no rows, and makes it ready for the next values.
  Expected<void> step(Statement& statement) const;
  /// Runs `work` as a whole: all of it is in the file, or nothing.
  Expected<void> atOnce(const std::function<Expected<void>()>& work);
  const std::filesystem::path& file() const { return file_; }
  Error failure() const;

 private:
  struct Close {
    void operator()(sqlite3* base) const;
  };
  static Expected<SqliteBase> openAs(const char* name, const std::filesystem::path& shown, int flags);

  std::unique_ptr<sqlite3, Close> base_;
  std::filesystem::path file_;
};

/// A name in double quotes, for SQL.
std::string quotedColumn(std::string_view name);

}  // namespace hapticell::studies
