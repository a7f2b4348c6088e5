// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>
#include <map>

#include "workcell/entity/entity.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class SwitchList;
class SwatchRow;
class ValueField;

/// Pair sets: the list with its switches, add and remove, and the fields of the chosen one: name, near-miss and safety
/// distance, colours, contact mode. Each edit is a command of the document, even while something is held.
class PairSetEditor : public QWidget {
  Q_OBJECT
 public:
  explicit PairSetEditor(Host& host, QWidget* parent = nullptr);
  /// Name of the chosen set; empty if there are no sets.
  QString current() const;
  /// Shows the number of present contacts and near misses next to each set's name.
  void setAlerts(const std::map<QString, int>& alerts);

 signals:
  void chosen(const QString& set);

 private:
  void addHeader(QVBoxLayout& column);
  void addFields(QVBoxLayout& column);
  void addSet();
  void removeSet();
  void showSets();
  void showSet();
  const workcell::PairSet* currentSet() const;
  void edit(const std::function<void(workcell::PairSet&)>& change);

  Host& host_;
  SwitchList* sets_;
  QPushButton *add_, *remove_;
  QWidget* fields_;
  QLabel* heading_;
  QLineEdit* name_;
  ValueField *near_miss_, *safety_;
  SwatchRow *near_miss_color_, *contact_color_;
  QComboBox* on_contact_;
};

}  // namespace hapticell::app
