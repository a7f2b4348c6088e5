// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <optional>
#include <set>
#include <vector>

#include "studies/document/study_document.h"
#include "studies/store/result_store.h"

namespace hapticell::app {

/// The rows of a study's results, and which of them is chosen: one model for table, charts and scene. GUI thread.
///
/// Columns: the number, whether it is feasible, the sum of the objectives, then what varies, then the answers.
class ResultTable : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Fixed { kNumber, kFeasible, kObjective, kFirstValue };
  /// The number of a cell, or a text, for sorting.
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  /// Begins with other results. Nothing is chosen.
  void begin(const studies::ResultHead& head, const QString& file);
  /// Adds rows; one with a number that is there replaces it.
  void add(const std::vector<studies::ResultRow>& rows);
  /// Reads a results file. Error: it is not a results file.
  Expected<void> open(const QString& file);
  void clear();

  bool isEmpty() const { return rows_.empty(); }
  const QString& file() const { return file_; }
  const studies::ResultHead& head() const { return head_; }
  const std::vector<studies::ResultRow>& rows() const { return rows_; }
  const std::vector<studies::Objective>& objectives() const { return objectives_; }
  /// Rows of the Pareto front, by index.
  const std::set<std::size_t>& front() const { return front_; }
  /// The best row by the order of the studies; nothing without rows.
  std::optional<std::size_t> best() const { return best_; }
  /// How many are feasible.
  std::size_t feasible() const { return feasible_; }

  QString columnName(int column) const;
  /// "m", "s"; empty: none.
  QString unit(int column) const;
  bool isNumber(int column) const;
  /// Nothing for words and where there is no answer.
  std::optional<double> number(std::size_t row, int column) const;
  QString word(std::size_t row, int column) const;
  /// Columns of numbers that differ between rows, what varies first.
  std::vector<int> numberColumns() const;
  /// The column of a result or of what varies; -1: none.
  int columnNamed(const std::string& name) const;
  /// Whether a greater number is better; empty: it is no objective.
  std::optional<bool> isGreaterBetter(int column) const;

  /// The chosen variant, by its number; nothing: none. A number without a row chooses none.
  void choose(std::optional<std::int64_t> number);
  std::optional<std::size_t> chosen() const { return chosen_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  void rowsChanged();
  void chosenChanged();

 private:
  const studies::Column* columnAt(int column) const;
  void count();

  QString file_;
  studies::ResultHead head_;
  std::vector<studies::Objective> objectives_;
  std::vector<studies::ResultRow> rows_;  ///< By number.
  std::set<std::size_t> front_;
  std::optional<std::size_t> best_, chosen_;
  std::size_t feasible_ = 0;
};

}  // namespace hapticell::app
