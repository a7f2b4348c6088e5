// SPDX-License-Identifier: Apache-2.0
#include "cli/study/study_report.h"

#include <algorithm>
#include <variant>

#include "cli/kit/result_writer.h"
#include "config/program_version.h"
#include "geometry/system/overloaded.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;
using studies::Answer;
using studies::Column;
using studies::ResultRow;

ordered_json answerJson(const Answer& answer) {
  return std::visit(Overloaded{[](std::monostate) { return ordered_json(nullptr); },
                               [](const auto& value) { return ordered_json(value); }},
                    answer);
}

ordered_json valueJson(const studies::Value& value) {
  return std::visit([](const auto& one) { return ordered_json(one); }, value);
}

/// Running figures of one column of numbers.
struct Spread {
  double least = 0.0, greatest = 0.0, sum = 0.0;
  std::int64_t count = 0, missing = 0;

  void add(const Answer& answer) {
    double value = 0.0;
    if (const auto* number = std::get_if<double>(&answer)) {
      value = *number;
    } else if (const auto* whole = std::get_if<std::int64_t>(&answer)) {
      value = static_cast<double>(*whole);
    } else {
      ++missing;
      return;
    }
    least = count == 0 ? value : std::min(least, value);
    greatest = count == 0 ? value : std::max(greatest, value);
    sum += value;
    ++count;
  }

  ordered_json json(const Column& column) const {
    ordered_json json{{"name", column.name}, {"unit", column.unit}};
    if (count > 0) json.update({{"least", least}, {"mean", sum / static_cast<double>(count)}, {"greatest", greatest}});
    json["missing"] = missing;
    return json;
  }
};

ordered_json runsJson(const std::vector<studies::RunRecord>& runs) {
  ordered_json list = ordered_json::array();
  for (const studies::RunRecord& run : runs) {
    list.push_back({{"chunk", std::to_string(run.chunk) + "/" + std::to_string(run.chunks)},
                    {"host", run.host},
                    {"started", run.started},
                    {"seconds", run.seconds},
                    {"jobs", run.jobs},
                    {"rows", run.rows},
                    {"complete", run.complete}});
  }
  return list;
}

}  // namespace

std::string studyVersion() {
  return HAPTICELL_VERSION " " + std::string(config::builtCommit());
}

ordered_json rowJson(const studies::ResultHead& head, const ResultRow& row) {
  ordered_json values = ordered_json::object(), results = ordered_json::object();
  for (std::size_t i = 0; i < head.values.size(); ++i) values[head.values[i].name] = valueJson(row.values[i]);
  for (std::size_t i = 0; i < head.answers.size(); ++i) results[head.answers[i].name] = answerJson(row.answers[i]);
  ordered_json json{{"number", row.number},
                    {"values", std::move(values)},
                    {"results", std::move(results)},
                    {"feasible", row.feasible},
                    {"violation", row.violation},
                    {"objective", answerJson(row.objective)}};
  if (!row.note.empty()) json["note"] = row.note;
  return json;
}

ordered_json rowsJson(const studies::ResultHead& head, const std::vector<ResultRow>& rows) {
  ordered_json list = ordered_json::array();
  for (const ResultRow& row : rows) list.push_back(rowJson(head, row));
  return list;
}

Expected<ordered_json> summaryJson(const studies::ResultStore& store) {
  const studies::ResultHead& head = store.head();
  std::vector<Spread> spreads(head.answers.size());
  std::int64_t rows = 0, feasible = 0, noted = 0;
  HAPTICELL_TRY(store.forEachRow([&](const ResultRow& row) {
    ++rows;
    feasible += row.feasible ? 1 : 0;
    noted += row.note.empty() ? 0 : 1;
    for (std::size_t i = 0; i < spreads.size(); ++i) spreads[i].add(row.answers[i]);
    return Expected<void>();
  }));
  const auto units = store.completeUnits();
  HAPTICELL_TRY(units);
  const auto runs = store.runs();
  HAPTICELL_TRY(runs);
  ordered_json columns = ordered_json::array(), values = ordered_json::array();
  for (const Column& column : head.values) values.push_back({{"name", column.name}, {"unit", column.unit}});
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    if (head.answers[i].kind == Column::Kind::kText) {
      columns.push_back({{"name", head.answers[i].name}, {"unit", ""}});
    } else {
      columns.push_back(spreads[i].json(head.answers[i]));
    }
  }
  const bool complete = static_cast<std::int64_t>(units->size()) == head.units;
  return ordered_json{{"study", head.name},       {"file", head.file},   {"version", head.version},
                      {"seed", head.seed},        {"variants", head.variants}, {"rows", rows},
                      {"complete", complete},     {"feasible", feasible},      {"with_notes", noted},
                      {"values", std::move(values)}, {"results", std::move(columns)}, {"runs", runsJson(*runs)}};
}

}  // namespace hapticell::cli
