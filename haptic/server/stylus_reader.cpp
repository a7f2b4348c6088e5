// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/stylus_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hapticell::haptic {

namespace {

/// m that a stylus may be outside of what its device states: makers state what is usable, arms reach farther. Half: a
/// long arm could trip; twice: an absurd pose of 1 m counts as real.
constexpr double kBeyondWorkspace = 0.5;
/// m, of a device that states nothing: three times what a stylus reaches (kFarthestStylus). Half: still beyond any;
/// twice: more absurd poses count as real.
constexpr double kUnknownWorkspace = 2.0;
/// s of refused samples while nothing pushes: two ticks and a half, so the third counts. Half: a pose that was wrong
/// for two ticks counts; twice: a new calibration is seen 2.5 ms later.
constexpr double kShortDoubt = 0.0025;
/// Of a refused sample for each that is believed. So a device with more than one wrong sample in five trips in the end.
/// Half: one in nine; twice: one in three.
constexpr double kDoubtFades = 0.25;

double reachOf(const DeviceCapabilities& c) {
  const double half = 0.5 * glm::length(c.workspace_max - c.workspace_min);
  return std::isfinite(half) && half > 0.0 ? half + kBeyondWorkspace : kUnknownWorkspace;
}

}  // namespace

StylusReader::StylusReader(Device& device, double period)
    : device_(device),
      period_(period),
      pushes_(device.capabilities().driven_axes > 0),
      middle_D_(0.5 * (device.capabilities().workspace_min + device.capabilities().workspace_max)),
      reach_(reachOf(device.capabilities())) {}

/// Whether a measurement is one that a hand can have made; a first one, or the first after the motors went off, is.
bool StylusReader::believes(const DeviceReading& reading, Outcome& outcome) noexcept {
  if (!reading.fresh) return false;
  const Pose& X_DS = reading.X_DS;
  bool follows = false;
  if (!X_DS.isValid() || glm::distance(X_DS.p, middle_D_) > reach_) {
    outcome.impossible = true;
  } else {
    if (anew_) gate_.restart();
    outcome.jumped = std::exchange(anew_, false);
    follows = gate_.judge(X_DS, std::exchange(judged_, 0.0)) == SampleGate::Verdict::kFollows;
  }
  doubt_ = follows ? std::max(0.0, doubt_ - kDoubtFades * period_) : doubt_ + period_;
  outcome.refused = !follows;
  return follows;
}

StylusReader::Outcome StylusReader::read(double dt, bool engaged) noexcept {
  Outcome outcome;
  DeviceReading reading;
  const bool fault = device_.read(reading) != DeviceStatus::kOk;
  age_ += dt;
  judged_ += dt;
  if (!fault) {
    if (believes(reading, outcome)) {
      age_ = 0.0;
      measured_ = true;
    } else {
      reading.X_DS = reading_.X_DS;  // An invalid or refused pose is not passed on.
    }
    reading_ = reading;
  }
  const bool pushing = pushes_ && engaged;
  const bool doubted = doubt_ >= (pushing ? kStale : kShortDoubt);
  const bool failing = fault || (measured_ && pushes_ && (age_ >= kStale || (doubted && pushing)));
  // Nothing pushes: what is measured next counts, wherever it is (calibration moves it, somebody plugs it in).
  if (failing || doubted || !reading_.takes_force) {
    anew_ = true;
    doubt_ = 0.0;
  }
  outcome.fails = failing && !failing_;
  failing_ = failing;
  return outcome;
}

}  // namespace hapticell::haptic
