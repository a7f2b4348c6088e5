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

/// Feasible rows that no other one beats, as what the user keeps of them.
template <typename Kept>
class ParetoFront {
 public:
  static Expected<ParetoFront> create(const std::vector<Column>& answers, const std::vector<Objective>& objectives,
                                      const std::string& file) {
    ParetoFront made;
    for (const Objective& one : objectives) {
      const auto found = std::find_if(answers.begin(), answers.end(), [&](const auto& c) { return c.name == one.value; });
      if (found == answers.end())
        return makeError({.file = file,
                          .found = Text("no result is called '%1'", one.value),
                          .expected = "results of this study"});
      made.columns_.push_back({static_cast<std::size_t>(found - answers.begin()), one.is_greatest});
    }
    if (made.columns_.empty())
      return makeError(
          {.file = file, .found = "a study without objectives", .expected = "at least one table [[objective]]"});
    return made;
  }

  void add(const ResultRow& row, const Kept& kept) {
    if (!row.feasible) return;
    std::vector<double> costs;
    for (const Wanted& one : columns_) {
      const double cost = costOfAnswer(row.answers[one.column]);
      const bool missing = cost == std::numeric_limits<double>::infinity();
      costs.push_back(one.is_greatest && !missing ? -cost : cost);
    }
    const bool beaten = std::any_of(members_.begin(), members_.end(), [&](const Member& one) {
      return beats(one.costs, costs) || one.costs == costs;
    });
    if (beaten) return;
    std::erase_if(members_, [&](const Member& one) { return beats(costs, one.costs); });
    members_.push_back({std::move(costs), kept});
  }

  std::vector<Kept> sorted() && {
    std::stable_sort(members_.begin(), members_.end(), [](const auto& a, const auto& b) { return a.costs < b.costs; });
    std::vector<Kept> all;
    for (Member& member : members_) all.push_back(std::move(member.kept));
    return all;
  }

 private:
  struct Wanted {
    std::size_t column = 0;
    bool is_greatest = false;
  };
  struct Member {
    std::vector<double> costs;
    Kept kept;
  };
  std::vector<Wanted> columns_;
  std::vector<Member> members_;
};

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

std::optional<std::size_t> bestIndex(const std::vector<ResultRow>& rows) {
  const auto best = std::min_element(rows.begin(), rows.end(),
                                     [](const ResultRow& a, const ResultRow& b) { return rankOf(a) < rankOf(b); });
  if (best == rows.end()) return std::nullopt;
  return static_cast<std::size_t>(best - rows.begin());
}

Expected<std::vector<ResultRow>> paretoRows(const ResultStore& store, const StudyDocument& document) {
  auto front = ParetoFront<ResultRow>::create(store.head().answers, document.objectives, store.file().string());
  HAPTICELL_TRY(front);
  HAPTICELL_TRY(store.forEachRow([&](const ResultRow& row) {
    front->add(row, row);
    return Expected<void>();
  }));
  return std::move(*front).sorted();
}

Expected<std::vector<std::size_t>> paretoIndices(const std::vector<ResultRow>& rows, const std::vector<Column>& columns,
                                                 const std::vector<Objective>& objectives) {
  auto front = ParetoFront<std::size_t>::create(columns, objectives, "");
  HAPTICELL_TRY(front);
  for (std::size_t i = 0; i < rows.size(); ++i) front->add(rows[i], i);
  return std::move(*front).sorted();
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
