// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/panels/collisions/contact_log_page.h"
#include "app/panels/collisions/pair_table_model.h"
#include "app/panels/collisions/rest_check.h"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QStackedWidget;
class QTableView;

namespace hapticell::app {

class Host;
class PairColumns;
class PairSetEditor;
class RestQuestion;
class Segmented;

/// Pair sets on the left, editable at any time; on the right what is near now, the set's two columns, or the log of
/// contacts. Above the pairs, asks what to do about parts that touch at rest.
class CollisionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CollisionsPanel(Host& host, QWidget* parent = nullptr);
  void showSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot);
  /// Number of present contacts and near misses, shown on the dock's tab.
  int alertCount() const { return alerts_; }
  /// Writes the log as CSV; false, with a message, if the file cannot be written.
  bool saveLog(const QString& path) { return log_page_->save(path); }
  const ContactLog& log() const { return log_page_->log(); }
  /// Shows all pairs of what is held, else of the selection: with the cell, and among a robot's own links and parts.
  void showPairs();

 signals:
  void alertsChanged(int count);

 private:
  QWidget* makeRight();
  void addTop(QBoxLayout& column);
  QWidget* makePairs();
  void makeTable();
  void showRows(std::vector<PairRow> rows);
  void clicked(const QModelIndex& index);
  void zoomTo(const PairRow& row);
  void switchPair(const PairRow& row);
  void chooseOnContact(const PairRow& row, const QPoint& place);
  workcell::PairRule ruleOf(const PairRow& row) const;
  workcell::EntityId movedEntity() const;

  Host& host_;
  PairTableModel model_;
  RestCheck rest_;
  PairSetEditor* sets_;
  PairColumns* columns_;
  RestQuestion* question_;
  ContactLogPage* log_page_;
  QLabel *log_line_, *empty_;
  Segmented *pages_, *show_;
  QLineEdit* filter_;
  QStackedWidget* stack_;
  QTableView* table_;
  int alerts_ = 0;
};

}  // namespace hapticell::app
