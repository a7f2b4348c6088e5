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

/// Force and gap of what is being recorded, in the chart's place while a stylus is connected. GUI thread.
class RecordedStrip : public QObject {
  Q_OBJECT
 public:
  /// The host must outlive it.
  explicit RecordedStrip(Host& host, QObject* parent = nullptr);
  QWidget* chart() const;
  /// A recording goes on since so many seconds, or none does. Whether the strip is shown now.
  bool show(std::optional<double> seconds, const TimeAxis& axis);
  /// The time bar's axis is another.
  void lay(const TimeAxis& axis);

 private:
  Host& host_;
  StripChart* chart_;
  QTimer timer_;
  double from_s_ = 0.0;  ///< The snapshots' time at which the recording began.
};

}  // namespace hapticell::app
