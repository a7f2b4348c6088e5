// SPDX-License-Identifier: Apache-2.0
#include "studies/store/result_store.h"

#include <nlohmann/json.hpp>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/overloaded.h"

namespace hapticell::studies {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Of the tables; a file of a greater one is refused.
constexpr std::int64_t kFormat = 1;
constexpr const char* kFormatName = "hapticell-study-results";

const char* sqlType(Column::Kind kind) {
  if (kind == Column::Kind::kText) return "TEXT";
  return kind == Column::Kind::kWhole ? "INTEGER" : "REAL";
}

json columnsJson(const std::vector<Column>& columns) {
  json list = json::array();
  for (const Column& column : columns)
    list.push_back({{"name", column.name}, {"type", sqlType(column.kind)}, {"unit", column.unit}});
  return list;
}

std::vector<Column> columnsOf(const json& list) {
  std::vector<Column> columns;
  for (const json& one : list) {
    Column column{one.at("name").get<std::string>(), Column::Kind::kNumber, one.at("unit").get<std::string>()};
    const auto type = one.at("type").get<std::string>();
    if (type == "TEXT") column.kind = Column::Kind::kText;
    if (type == "INTEGER") column.kind = Column::Kind::kWhole;
    columns.push_back(std::move(column));
  }
  return columns;
}

void bindAnswer(const Answer& answer, int place, Statement& statement) {
  std::visit(Overloaded{[&](std::monostate) { statement.bindNull(place); },
                        [&](const auto& value) { statement.bind(place, value); }},
             answer);
}

Answer answerAt(const Statement& statement, int column, Column::Kind kind) {
  if (statement.isNull(column)) return {};
  if (kind == Column::Kind::kText) return statement.text(column);
  if (kind == Column::Kind::kWhole) return statement.whole(column);
  return statement.number(column);
}

}  // namespace

Expected<ResultStore> ResultStore::create(const fs::path& file, const ResultHead& head) {
  std::error_code ignored;
  if (fs::exists(file, ignored))
    return makeError({.file = file.string(), .found = "the file exists", .expected = "a new file"});
  auto base = SqliteBase::open(file, SqliteBase::Mode::kCreate);
  HAPTICELL_TRY(base);
  ResultStore store(std::move(*base), head);
  const auto written = store.base_.atOnce([&] { return store.writeHead(); });
  if (!written) {
    fs::remove(file, ignored);
    return tl::unexpected(written.error());
  }
  return store;
}

Expected<ResultStore> ResultStore::inMemory(const ResultHead& head) {
  auto base = SqliteBase::inMemory();
  HAPTICELL_TRY(base);
  ResultStore store(std::move(*base), head);
  HAPTICELL_TRY(store.base_.atOnce([&] { return store.writeHead(); }));
  return store;
}

Expected<ResultStore> ResultStore::open(const fs::path& file, bool for_writing) {
  auto base = SqliteBase::open(file, for_writing ? SqliteBase::Mode::kWrite : SqliteBase::Mode::kRead);
  HAPTICELL_TRY(base);
  ResultStore store(std::move(*base), {});
  HAPTICELL_TRY(store.readHead());
  return store;
}

Expected<ResultStore> ResultStore::openOrCreate(const fs::path& file, const ResultHead& head) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return create(file, head);
  auto store = open(file, true);
  HAPTICELL_TRY(store);
  HAPTICELL_TRY(checkSameStudy(store->head(), head, file));
  return store;
}

Expected<void> ResultStore::writeHead() {
  std::string columns = "number INTEGER PRIMARY KEY";
  for (const Column& column : head_.values) columns += ", " + quotedColumn(column.name) + " " + sqlType(column.kind);
  for (const Column& column : head_.answers) columns += ", " + quotedColumn(column.name) + " " + sqlType(column.kind);
  columns += ", feasible INTEGER, violation REAL, objective REAL, note TEXT, seed INTEGER, version TEXT";
  HAPTICELL_TRY(base_.run("CREATE TABLE head (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID"));
  HAPTICELL_TRY(base_.run("CREATE TABLE variants (" + columns + ")"));
  HAPTICELL_TRY(base_.run("CREATE TABLE units (unit INTEGER PRIMARY KEY)"));
  HAPTICELL_TRY(
      base_.run("CREATE TABLE runs (id INTEGER PRIMARY KEY, chunk INTEGER, chunks INTEGER, host TEXT, started TEXT, "
                "seconds REAL, jobs INTEGER, rows INTEGER, complete INTEGER)"));
  auto insert = base_.prepare("INSERT INTO head VALUES (?, ?)");
  HAPTICELL_TRY(insert);
  const std::pair<const char*, std::string> entries[] = {{"format", kFormatName},
                                                         {"format_version", std::to_string(kFormat)},
                                                         {"name", head_.name},
                                                         {"study", head_.study},
                                                         {"file", head_.file},
                                                         {"digest", head_.digest},
                                                         {"version", head_.version},
                                                         {"seed", std::to_string(head_.seed)},
                                                         {"variants", std::to_string(head_.variants)},
                                                         {"units", std::to_string(head_.units)},
                                                         {"per_unit", std::to_string(head_.per_unit)},
                                                         {"values", columnsJson(head_.values).dump()},
                                                         {"answers", columnsJson(head_.answers).dump()}};
  for (const auto& entry : entries) {
    insert->bind(0, std::string(entry.first));
    insert->bind(1, entry.second);
    HAPTICELL_TRY(base_.step(*insert));
  }
  return {};
}

Expected<void> ResultStore::readHead() {
  const auto strange = [&] {
    return makeError({.file = file().string(),
                      .found = "no results of a study",
                      .expected = "a file that study run or study merge wrote"});
  };
  auto select = base_.prepare("SELECT key, value FROM head");
  if (!select) return strange();
  std::map<std::string, std::string> entries;
  HAPTICELL_TRY(base_.forEach(*select, [&](const Statement& row) {
    entries[row.text(0)] = row.text(1);
    return Expected<void>();
  }));
  if (entries["format"] != kFormatName) return strange();
  if (entries["format_version"] != std::to_string(kFormat))
    return makeError({.file = file().string(),
                      .found = Text("results of format %1", entries["format_version"]),
                      .expected = Text("format %1", kFormat),
                      .fix = "Install the version of HaptiCell that made them."});
  head_.name = entries["name"];
  head_.study = entries["study"];
  head_.file = entries["file"];
  head_.digest = entries["digest"];
  head_.version = entries["version"];
  for (const char* columns : {"values", "answers"}) {
    HAPTICELL_TRY(geometry::checkNesting(entries[columns], geometry::NestedText::kJson, file().string()));
  }
  try {
    head_.seed = std::stoull(entries["seed"]);
    head_.variants = std::stoll(entries["variants"]);
    head_.units = std::stoll(entries["units"]);
    head_.per_unit = std::stoll(entries["per_unit"]);
    head_.values = columnsOf(json::parse(entries["values"]));
    head_.answers = columnsOf(json::parse(entries["answers"]));
  } catch (const std::exception&) {
    return strange();
  }
  return {};
}

std::string ResultStore::columnList() const {
  std::string list = "number";
  for (const auto* columns : {&head_.values, &head_.answers})
    for (const Column& column : *columns) list += ", " + quotedColumn(column.name);
  return list + ", feasible, violation, objective, note";
}

ResultRow ResultStore::rowOf(const Statement& statement) const {
  ResultRow row;
  int place = 0;
  row.number = statement.whole(place++);
  for (const Column& column : head_.values) {
    if (column.kind == Column::Kind::kText) {
      row.values.emplace_back(statement.text(place++));
    } else {
      row.values.emplace_back(statement.number(place++));
    }
  }
  for (const Column& column : head_.answers) row.answers.push_back(answerAt(statement, place++, column.kind));
  row.feasible = statement.whole(place++) != 0;
  row.violation = statement.number(place++);
  row.objective = answerAt(statement, place++, Column::Kind::kNumber);
  row.note = statement.text(place);
  return row;
}

Expected<void> ResultStore::add(const std::vector<ResultRow>& rows, const std::vector<std::int64_t>& complete_units) {
  std::string places = "?";
  for (std::size_t i = 0; i < head_.values.size() + head_.answers.size() + 6; ++i) places += ", ?";
  return base_.atOnce([&]() -> Expected<void> {
    auto insert = base_.prepare("INSERT OR REPLACE INTO variants (" + columnList() + ", seed, version) VALUES (" +
                                places + ")");
    HAPTICELL_TRY(insert);
    for (const ResultRow& row : rows) {
      int place = 0;
      insert->bind(place++, row.number);
      for (const Value& value : row.values) std::visit([&](const auto& one) { insert->bind(place++, one); }, value);
      for (const Answer& answer : row.answers) bindAnswer(answer, place++, *insert);
      insert->bind(place++, std::int64_t{row.feasible ? 1 : 0});
      insert->bind(place++, row.violation);
      bindAnswer(row.objective, place++, *insert);
      insert->bind(place++, row.note);
      insert->bind(place++, static_cast<std::int64_t>(head_.seed));
      insert->bind(place++, head_.version);
      HAPTICELL_TRY(base_.step(*insert));
    }
    auto mark = base_.prepare("INSERT OR REPLACE INTO units VALUES (?)");
    HAPTICELL_TRY(mark);
    for (const std::int64_t unit : complete_units) {
      mark->bind(0, unit);
      HAPTICELL_TRY(base_.step(*mark));
    }
    return {};
  });
}

Expected<std::set<std::int64_t>> ResultStore::completeUnits() const {
  auto select = base_.prepare("SELECT unit FROM units ORDER BY unit");
  HAPTICELL_TRY(select);
  std::set<std::int64_t> units;
  HAPTICELL_TRY(base_.forEach(*select, [&](const Statement& row) {
    units.insert(units.end(), row.whole(0));
    return Expected<void>();
  }));
  return units;
}

Expected<std::int64_t> ResultStore::rowCount() const {
  auto select = base_.prepare("SELECT count(*) FROM variants");
  HAPTICELL_TRY(select);
  std::int64_t count = 0;
  HAPTICELL_TRY(base_.forEach(*select, [&](const Statement& row) {
    count = row.whole(0);
    return Expected<void>();
  }));
  return count;
}

Expected<void> ResultStore::forEachRow(const std::function<Expected<void>(const ResultRow&)>& each) const {
  auto select = base_.prepare("SELECT " + columnList() + " FROM variants ORDER BY number");
  HAPTICELL_TRY(select);
  return base_.forEach(*select, [&](const Statement& row) { return each(rowOf(row)); });
}

Expected<std::optional<ResultRow>> ResultStore::row(std::int64_t number) const {
  auto select = base_.prepare("SELECT " + columnList() + " FROM variants WHERE number = ?");
  HAPTICELL_TRY(select);
  select->bind(0, number);
  std::optional<ResultRow> found;
  HAPTICELL_TRY(base_.forEach(*select, [&](const Statement& row) {
    found = rowOf(row);
    return Expected<void>();
  }));
  return found;
}

Expected<std::int64_t> ResultStore::beginRun(const RunRecord& run) {
  std::int64_t id = 0;
  const auto noted = base_.atOnce([&]() -> Expected<void> {
    auto insert = base_.prepare(
        "INSERT INTO runs (chunk, chunks, host, started, seconds, jobs, rows, complete) VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    HAPTICELL_TRY(insert);
    insert->bind(0, run.chunk);
    insert->bind(1, run.chunks);
    insert->bind(2, run.host);
    insert->bind(3, run.started);
    insert->bind(4, run.seconds);
    insert->bind(5, run.jobs);
    insert->bind(6, run.rows);
    insert->bind(7, std::int64_t{run.complete ? 1 : 0});
    HAPTICELL_TRY(base_.step(*insert));
    auto last = base_.prepare("SELECT max(id) FROM runs");
    HAPTICELL_TRY(last);
    return base_.forEach(*last, [&](const Statement& row) {
      id = row.whole(0);
      return Expected<void>();
    });
  });
  HAPTICELL_TRY(noted);
  return id;
}

Expected<void> ResultStore::finishRun(std::int64_t id, const RunRecord& run) {
  auto update = base_.prepare("UPDATE runs SET seconds = ?, rows = ?, complete = ? WHERE id = ?");
  HAPTICELL_TRY(update);
  update->bind(0, run.seconds);
  update->bind(1, run.rows);
  update->bind(2, std::int64_t{run.complete ? 1 : 0});
  update->bind(3, id);
  return base_.step(*update);
}

Expected<std::vector<RunRecord>> ResultStore::runs() const {
  auto select =
      base_.prepare("SELECT chunk, chunks, host, started, seconds, jobs, rows, complete FROM runs ORDER BY id");
  HAPTICELL_TRY(select);
  std::vector<RunRecord> runs;
  HAPTICELL_TRY(base_.forEach(*select, [&](const Statement& row) {
    runs.push_back({row.whole(0), row.whole(1), row.text(2), row.text(3), row.number(4), row.whole(5), row.whole(6),
                    row.whole(7) != 0});
    return Expected<void>();
  }));
  return runs;
}

Expected<void> checkSameStudy(const ResultHead& found, const ResultHead& expected, const fs::path& file) {
  if (found.digest != expected.digest)
    return makeError({.file = file.string(),
                      .found = "results of another study, or of files that have changed since",
                      .expected = Text("results of '%1' as it is now", expected.name),
                      .fix = "Choose another results file."});
  if (found.version != expected.version)
    return makeError({.file = file.string(),
                      .found = Text("results of version %1", found.version),
                      .expected = Text("results of version %1", expected.version),
                      .fix = "Use the same version for all rows, or choose another results file."});
  return {};
}

}  // namespace hapticell::studies
