// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/recorded_strip.h"

#include "app/controls/strip_chart.h"
#include "app/host/host.h"

namespace hapticell::app {
namespace {

// ms a picture while recording, 30 a second. Half: twice the work; twice: it jerks.
constexpr int kLiveMilliseconds = 33;
// Kept of force and gap while recording; the strip's width. Half, twice: a shorter or longer view.
constexpr double kLiveSeconds = 120.0;

}  // namespace

RecordedStrip::RecordedStrip(Host& host, QObject* parent)
    : QObject(parent), host_(host), chart_(new StripChart(kLiveSeconds)) {
  chart_->setObjectName("recordedStrip");
  chart_->setLevels(host_.configuration().manipulation.near_miss, 0.0);
  chart_->hide();
  connect(&timer_, &QTimer::timeout, this, [this] { chart_->take(host_.snapshot()); });
}

QWidget* RecordedStrip::chart() const {
  return chart_;
}

bool RecordedStrip::show(std::optional<double> seconds, const TimeAxis& axis) {
  const auto& now = host_.snapshot();
  const bool live = seconds && now && now->stylus.connected;
  if (live) {
    chart_->take(now);
    from_s_ = chart_->history().now() - *seconds;
    lay(axis);
  }
  if (live != timer_.isActive()) live ? timer_.start(kLiveMilliseconds) : timer_.stop();
  chart_->setVisible(live);
  return live;
}

void RecordedStrip::lay(const TimeAxis& axis) {
  chart_->setTimes({axis.left, axis.right, from_s_ + axis.begin, from_s_ + axis.end});
}

}  // namespace hapticell::app
