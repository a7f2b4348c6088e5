// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "trajectory/timing/retiming.h"

class QComboBox;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class ValueField;

/// How to time the current motion along its path, and how fast. GUI thread.
class TimingFields : public QObject {
  Q_OBJECT
 public:
  explicit TimingFields(QVBoxLayout& section, QObject* parent = nullptr);

  /// True: recorded times, with frames at equal intervals; false: times by options().
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
