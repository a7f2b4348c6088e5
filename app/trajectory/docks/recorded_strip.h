// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/trajectory/docks/time_axis.h"

class QWidget;

namespace hapticell::app {

class Host;
class StripChart;

/// Force and clearance of the running recording, in place of the chart while a stylus is connected. GUI thread.
class RecordedStrip : public QObject {
  Q_OBJECT
 public:
  /// The host must outlive it.
  explicit RecordedStrip(Host& host, QObject* parent = nullptr);
  QWidget* chart() const;
  /// Sets how many seconds a recording has been running; empty: none. Returns whether the strip is shown now.
  bool show(std::optional<double> seconds, const TimeAxis& axis);
  /// Sets another axis of the time bar.
  void lay(const TimeAxis& axis);

 private:
  Host& host_;
  StripChart* chart_;
  QTimer timer_;
  double from_s_ = 0.0;  ///< Snapshot time at which the recording began.
};

}  // namespace hapticell::app
