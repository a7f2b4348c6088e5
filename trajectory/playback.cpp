// SPDX-License-Identifier: Apache-2.0
#include "trajectory/playback.h"

#include <algorithm>
#include <cmath>

namespace hapticell::trajectory {

namespace {

constexpr double kSlowest = 0.01;
constexpr double kSame = 1e-9;  // s

}  // namespace

void Playback::setFrames(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  frames_ = std::move(times);
  time_ = std::clamp(time_, begin(), end());
  if (frames_.empty()) playing_ = false;
}

void Playback::play() {
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
  time_ += speed_ * seconds;
  if (time_ < end()) return true;
  if (loops_ && length > 0.0) {
    time_ = begin() + std::fmod(time_ - begin(), length);
  } else {
    time_ = end();
    playing_ = false;
  }
  return true;
}

}  // namespace hapticell::trajectory
