// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "app/panels/pair_rows.h"

class QLabel;
class QLineEdit;
class QTableView;
class QVBoxLayout;
class QComboBox;

namespace hapticell::app {

class Host;
class PairSetList;
class Segmented;
class ValueField;

/// Pair sets at the left, editable at any time, and what is near now at the right.
class CollisionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CollisionsPanel(Host& host, QWidget* parent = nullptr);
  void showSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot);
  /// Contacts and near misses now: the number on the dock's tab.
  int alertCount() const { return alerts_; }

 signals:
  void alertsChanged(int count);

 private:
  QWidget* makeSets();
  QWidget* makeTable();
  void showSets();
  void showSet();
  const workcell::PairSet* currentSet() const;
  void edit(const std::function<void(workcell::PairSet&)>& change);
  workcell::EntityId movedEntity() const;

  Host& host_;
  PairTableModel model_;
  PairSetList* sets_;
  QLabel* set_heading_;
  ValueField *near_miss_, *safety_;
  QComboBox* on_contact_;
  QWidget* set_fields_;
  Segmented* show_;
  QLineEdit* filter_;
  QTableView* table_;
  int alerts_ = 0;
};

}  // namespace hapticell::app
