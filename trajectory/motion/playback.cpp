// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/playback.h"

#include <algorithm>
#include <cmath>

namespace hapticell::trajectory {

namespace {

// Of real time: a minute takes 100. Half, twice: other limit of the slow end, nothing else.
constexpr double kSlowest = 0.01;
// s: times are equal but for rounding. Half, twice: no effect, frames are 1e-3 s apart.
constexpr double kSame = 1e-9;

}  // namespace

void Playback::setFrames(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  frames_ = std::move(times);
  time_ = std::clamp(time_, begin(), end());
  if (frames_.empty()) playing_ = false;
}

void Playback::setStops(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  stops_ = std::move(times);
}

double Playback::stopBetween(double from, double to) const {
  const auto stop = std::upper_bound(stops_.begin(), stops_.end(), from + kSame);
  return stop != stops_.end() && *stop < to ? *stop : to;
}

void Playback::play() {
  owed_ = 0.0;
  if (frames_.empty()) return;
  if (time_ >= end() - kSame) time_ = begin();
  playing_ = true;
}

void Playback::seek(double time) {
  time_ = std::clamp(time, begin(), end());
}

void Playback::step(int direction) {
  playing_ = false;
  if (frames_.empty()) return;
  if (direction > 0) {
    const auto next = std::upper_bound(frames_.begin(), frames_.end(), time_ + kSame);
    time_ = next == frames_.end() ? end() : *next;
  } else {
    const auto here = std::lower_bound(frames_.begin(), frames_.end(), time_ - kSame);
    time_ = here == frames_.begin() ? begin() : *(here - 1);
  }
}

void Playback::setSpeed(double speed) {
  speed_ = std::isfinite(speed) ? std::max(speed, kSlowest) : 1.0;
}

bool Playback::advance(double seconds) {
  if (!playing_ || !(seconds > 0.0)) return false;
  const double length = end() - begin();
  const double to = time_ + speed_ * (seconds + owed_);
  const double stop = stopBetween(time_, std::min(to, end()));
  owed_ = 0.0;
  if (stop < to && stop < end()) {
    owed_ = std::min((to - stop) / speed_, seconds);
    time_ = stop;
  } else if (to < end()) {
    time_ = to;
  } else if (loops_ && length > 0.0) {
    const double wrapped = begin() + std::fmod(to - begin(), length);
    time_ = stopBetween(begin() - 2.0 * kSame, wrapped);
    owed_ = std::min((wrapped - time_) / speed_, seconds);
  } else {
    time_ = end();
    playing_ = false;
  }
  return true;
}

}  // namespace hapticell::trajectory
