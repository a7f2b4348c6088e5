// SPDX-License-Identifier: Apache-2.0
#include "studies/store/result_ranking.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "geometry/system/overloaded.h"

namespace hapticell::studies {

namespace {

double costOfAnswer(const Answer& answer) {
  return std::visit(
      Overloaded{[](double value) { return value; }, [](std::int64_t value) { return static_cast<double>(value); },
                 [](const auto&) { return std::numeric_limits<double>::infinity(); }},
      answer);
}

auto rankOf(const ResultRow& row) {
  return std::tuple(!row.feasible, row.violation, costOfAnswer(row.objective), row.number);
}

/// `a` is at least as good in all and better in one.
bool beats(const std::vector<double>& a, const std::vector<double>& b) {
  bool better = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
    better = better || a[i] < b[i];
  }
  return better;
}

std::string csvText(const std::string& text) {
  if (text.find_first_of(",\"\n\r;") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvAnswer(const Answer& answer) {
  return std::visit(
      Overloaded{[](std::monostate) { return std::string(); }, [](double value) { return textOf(Value(value)); },
                 [](std::int64_t value) { return std::to_string(value); },
                 [](const std::string& text) { return csvText(text); }},
      answer);
}

}  // namespace

Expected<std::vector<ResultRow>> bestRows(const ResultStore& store, std::size_t count) {
  std::vector<ResultRow> best;
  const auto before = [](const ResultRow& a, const ResultRow& b) { return rankOf(a) < rankOf(b); };
  HAPTICELL_TRY(store.forEachRow([&](const ResultRow& row) {
    best.insert(std::upper_bound(best.begin(), best.end(), row, before), row);
    if (best.size() > count) best.pop_back();
    return Expected<void>();
  }));
  return best;
}

Expected<std::vector<ResultRow>> paretoRows(const ResultStore& store, const StudyDocument& document) {
  struct Member {
    std::vector<double> costs;
    ResultRow row;
  };
  std::vector<std::size_t> columns;
  for (const Objective& one : document.objectives) {
    const auto& answers = store.head().answers;
    const auto found = std::find_if(answers.begin(), answers.end(), [&](const auto& c) { return c.name == one.value; });
    if (found == answers.end())
      return makeError({.file = store.file().string(),
                        .found = Text("no result is called '%1'", one.value),
                        .expected = "results of this study"});
    columns.push_back(static_cast<std::size_t>(found - answers.begin()));
  }
  if (columns.empty())
    return makeError({.file = store.file().string(),
                      .found = "a study without objectives",
                      .expected = "at least one table [[objective]]"});
  std::vector<Member> front;
  HAPTICELL_TRY(store.forEachRow([&](const ResultRow& row) {
    if (!row.feasible) return Expected<void>();
    Member member{{}, row};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double cost = costOfAnswer(row.answers[columns[i]]);
      const bool missing = cost == std::numeric_limits<double>::infinity();
      member.costs.push_back(document.objectives[i].is_greatest && !missing ? -cost : cost);
    }
    const bool beaten = std::any_of(front.begin(), front.end(), [&](const Member& one) {
      return beats(one.costs, member.costs) || one.costs == member.costs;
    });
    if (beaten) return Expected<void>();
    std::erase_if(front, [&](const Member& one) { return beats(member.costs, one.costs); });
    front.push_back(std::move(member));
    return Expected<void>();
  }));
  std::stable_sort(front.begin(), front.end(), [](const auto& a, const auto& b) { return a.costs < b.costs; });
  std::vector<ResultRow> rows;
  for (Member& member : front) rows.push_back(std::move(member.row));
  return rows;
}

Expected<std::string> csvOf(const ResultStore& store) {
  std::string text = "number";
  for (const auto* columns : {&store.head().values, &store.head().answers})
    for (const Column& column : *columns) text += "," + csvText(column.name);
  text += ",feasible,violation,objective,note,seed,version\n";
  const std::string end = "," + std::to_string(store.head().seed) + "," + csvText(store.head().version) + "\n";
  HAPTICELL_TRY(store.forEachRow([&](const ResultRow& row) {
    text += std::to_string(row.number);
    for (const Value& value : row.values) text += "," + csvText(textOf(value));
    for (const Answer& answer : row.answers) text += "," + csvAnswer(answer);
    text += std::string(row.feasible ? ",1," : ",0,") + textOf(Value(row.violation)) + "," + csvAnswer(row.objective) +
            "," + csvText(row.note) + end;
    return Expected<void>();
  }));
  return text;
}

}  // namespace hapticell::studies
