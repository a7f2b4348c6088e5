// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/touch_meter.h"

#include <algorithm>
#include <vector>

namespace hapticell::app {

void TouchMeter::drawn(std::int64_t felt_ns) {
  if (felt_ns > counted_ns_ && waiting_ns_ == 0) waiting_ns_ = felt_ns;
}

void TouchMeter::shown(std::int64_t now_ns) {
  if (waiting_ns_ == 0) return;
  seconds_.push_back(1e-9 * static_cast<double>(now_ns - waiting_ns_));
  if (seconds_.size() > kKept) seconds_.pop_front();
  counted_ns_ = waiting_ns_;
  waiting_ns_ = 0;
}

TouchMeter::Figures TouchMeter::figures() const {
  Figures figures;
  figures.contacts = seconds_.size();
  if (seconds_.empty()) return figures;
  std::vector<double> sorted(seconds_.begin(), seconds_.end());
  std::sort(sorted.begin(), sorted.end());
  figures.last_s = seconds_.back();
  figures.median_s = sorted[sorted.size() / 2];
  figures.worst_s = sorted.back();
  return figures;
}

}  // namespace hapticell::app
