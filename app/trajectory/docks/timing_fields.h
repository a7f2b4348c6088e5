// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "trajectory/timing/retiming.h"

class QComboBox;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class ValueField;

/// Which times the current motion gets along its path, and how fast. GUI thread.
class TimingFields : public QObject {
  Q_OBJECT
 public:
  explicit TimingFields(QVBoxLayout& section, QObject* parent = nullptr);

  /// As it was recorded, with frames at even times; else by options().
  bool isAsRecorded() const;
  trajectory::RetimingOptions options() const;
  double speed() const;  ///< m/s.

 private:
  void show();

  QComboBox* timing_;
  ValueField *speed_, *jerk_time_;
  QWidget *speed_row_, *jerk_row_;
};

}  // namespace hapticell::app
