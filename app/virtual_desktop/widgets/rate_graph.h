// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <deque>

#include "app/virtual_desktop/devices/device_watch.h"

namespace hapticell::app {

/// The force loop's rate (line) and the delay of its ticks (bars) over the last minute.
class RateGraph : public QWidget {
  Q_OBJECT
 public:
  explicit RateGraph(QWidget* parent = nullptr);
  void setSamples(const std::deque<DeviceWatch::RateSample>& samples);
  QSize sizeHint() const override { return {320, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::deque<DeviceWatch::RateSample> samples_;
};

/// The reached fractions of the workspace, one bar per axis, and the buttons as dots.
class RangeView : public QWidget {
  Q_OBJECT
 public:
  explicit RangeView(QWidget* parent = nullptr);
  void setTest(const RangeTest& test, const std::optional<haptic::DeviceDescription>& device);
  QSize sizeHint() const override { return {320, 104}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  dvec3 covered_{0.0};
  int buttons_ = 0;
  std::uint32_t pressed_ = 0, now_ = 0;
};

}  // namespace hapticell::app
