// SPDX-License-Identifier: Apache-2.0
#include "app/studies/result_table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "studies/store/result_ranking.h"

namespace hapticell::app {

using studies::ResultRow;

namespace {

/// Digits that tell variants apart. Half: neighbours look alike; twice: columns too wide to compare.
constexpr int kDigits = 5;

std::optional<double> numberOf(const studies::Answer& answer) {
  if (const auto* number = std::get_if<double>(&answer)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&answer)) return static_cast<double>(*whole);
  return std::nullopt;
}

}  // namespace

void ResultTable::begin(const studies::ResultHead& head, const QString& file) {
  beginResetModel();
  head_ = head;
  file_ = file;
  objectives_.clear();
  if (const auto document = studies::StudyDocument::parse(head.study, head.file.empty() ? "study.hstudy" : head.file))
    objectives_ = document->objectives;
  rows_.clear();
  chosen_.reset();
  count();
  endResetModel();
  emit rowsChanged();
  emit chosenChanged();
}

void ResultTable::add(const std::vector<ResultRow>& rows) {
  if (rows.empty()) return;
  const auto number = chosen_ ? std::optional(rows_[*chosen_].number) : std::nullopt;
  beginResetModel();
  std::map<std::int64_t, const ResultRow*> latest;
  for (const ResultRow& row : rows) latest[row.number] = &row;
  std::erase_if(rows_, [&](const ResultRow& row) { return latest.count(row.number) != 0; });
  for (const auto& entry : latest) rows_.push_back(*entry.second);
  std::sort(rows_.begin(), rows_.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  count();
  chosen_.reset();
  endResetModel();
  if (number) choose(number);
  emit rowsChanged();
}

Expected<void> ResultTable::open(const QString& file) {
  const auto store = studies::ResultStore::open(file.toStdString(), false);
  HAPTICELL_TRY(store);
  std::vector<ResultRow> rows;
  HAPTICELL_TRY(store->forEachRow([&](const ResultRow& row) {
    rows.push_back(row);
    return Expected<void>();
  }));
  begin(store->head(), file);
  add(rows);
  return {};
}

void ResultTable::clear() {
  begin({}, {});
}

void ResultTable::count() {
  front_.clear();
  if (const auto front = studies::paretoIndices(rows_, head_.answers, objectives_))
    front_.insert(front->begin(), front->end());
  best_ = studies::bestIndex(rows_);
  feasible_ = static_cast<std::size_t>(
      std::count_if(rows_.begin(), rows_.end(), [](const ResultRow& row) { return row.feasible; }));
}

const studies::Column* ResultTable::columnAt(int column) const {
  if (column < kFirstValue) return nullptr;
  const auto at = static_cast<std::size_t>(column - kFirstValue);
  if (at < head_.values.size()) return &head_.values[at];
  return at - head_.values.size() < head_.answers.size() ? &head_.answers[at - head_.values.size()] : nullptr;
}

QString ResultTable::columnName(int column) const {
  if (column == kNumber) return tr("Variant");
  if (column == kFeasible) return tr("Feasible");
  if (column == kObjective) return tr("Objective");
  const studies::Column* named = columnAt(column);
  return named != nullptr ? QString::fromStdString(named->name) : QString();
}

QString ResultTable::unit(int column) const {
  const studies::Column* named = columnAt(column);
  return named != nullptr ? QString::fromStdString(named->unit) : QString();
}

bool ResultTable::isNumber(int column) const {
  const studies::Column* named = columnAt(column);
  return named == nullptr ? column == kNumber || column == kObjective : named->kind != studies::Column::Kind::kText;
}

std::optional<double> ResultTable::number(std::size_t row, int column) const {
  const ResultRow& one = rows_[row];
  if (column == kNumber) return static_cast<double>(one.number);
  if (column == kFeasible) return one.feasible ? 1.0 : 0.0;
  if (column == kObjective) return numberOf(one.objective);
  const auto at = static_cast<std::size_t>(column - kFirstValue);
  if (at >= one.values.size()) return numberOf(one.answers[at - one.values.size()]);
  const auto* number = std::get_if<double>(&one.values[at]);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

QString ResultTable::word(std::size_t row, int column) const {
  if (const auto value = number(row, column)) {
    if (column == kFeasible) return *value > 0.0 ? tr("yes") : tr("no");
    return QString::number(*value, 'g', kDigits);
  }
  const ResultRow& one = rows_[row];
  const auto at = static_cast<std::size_t>(column - kFirstValue);
  if (column < kFirstValue) return {};
  const std::string* text = at < one.values.size()
                                ? std::get_if<std::string>(&one.values[at])
                                : std::get_if<std::string>(&one.answers[at - one.values.size()]);
  return text != nullptr ? QString::fromStdString(*text) : QString();
}

std::vector<int> ResultTable::numberColumns() const {
  std::vector<int> columns;
  for (int column = kObjective; column < columnCount(); ++column) {
    if (!isNumber(column)) continue;
    std::optional<double> first;
    bool differs = false;
    for (std::size_t row = 0; row < rows_.size() && !differs; ++row) {
      const auto value = number(row, column);
      if (value && first && *value != *first) differs = true;
      if (value && !first) first = value;
    }
    if (differs) columns.push_back(column);
  }
  // What varies first, the sum of the objectives last.
  if (!columns.empty() && columns.front() == kObjective) std::rotate(columns.begin(), columns.begin() + 1, columns.end());
  return columns;
}

int ResultTable::columnNamed(const std::string& name) const {
  for (int column = kFirstValue; column < columnCount(); ++column)
    if (columnAt(column)->name == name) return column;
  return -1;
}

std::optional<bool> ResultTable::isGreaterBetter(int column) const {
  if (column == kObjective) return false;
  const studies::Column* named = columnAt(column);
  for (const studies::Objective& one : objectives_)
    if (named != nullptr && one.value == named->name) return one.is_greatest;
  return std::nullopt;
}

void ResultTable::choose(std::optional<std::int64_t> number) {
  std::optional<std::size_t> wanted;
  for (std::size_t row = 0; number && row < rows_.size(); ++row)
    if (rows_[row].number == *number) wanted = row;
  if (wanted == chosen_) return;
  chosen_ = wanted;
  emit chosenChanged();
}

int ResultTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ResultTable::columnCount(const QModelIndex& parent) const {
  if (parent.isValid() || head_.values.empty()) return 0;
  return kFirstValue + static_cast<int>(head_.values.size() + head_.answers.size());
}

QVariant ResultTable::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (role == Qt::DisplayRole) return word(row, index.column());
  if (role == Qt::TextAlignmentRole && isNumber(index.column())) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && !rows_[row].note.empty()) return QString::fromStdString(rows_[row].note);
  if (role != kSortRole) return {};
  if (const auto value = number(row, index.column())) return *value;
  const QString text = word(row, index.column());
  return text.isEmpty() ? QVariant() : QVariant(text);
}

QVariant ResultTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return unit(section).isEmpty() ? columnName(section) : columnName(section) + ", " + unit(section);
}

}  // namespace hapticell::app
