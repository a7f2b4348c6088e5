// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <deque>
#include <memory>
#include <optional>

#include "haptic/client/tcp_link.h"

namespace hapticell::app {

/// The range-of-motion and button test: how far the stylus was moved and which of its buttons were pressed.
class RangeTest {
 public:
  /// Takes the present position in the workspace D (m) and the pressed buttons.
  void take(const dvec3& p_D, std::uint32_t buttons);
  void reset() { *this = {}; }
  /// Fractions of the workspace's width, depth and height that were reached, 0 to 1.
  dvec3 covered(const dvec3& workspace_min, const dvec3& workspace_max) const;
  std::uint32_t pressedOnce() const { return pressed_; }
  std::uint32_t pressedNow() const { return now_; }

 private:
  bool any_ = false;
  dvec3 min_{0.0}, max_{0.0};
  std::uint32_t pressed_ = 0, now_ = 0;
};

/// Force of the force test (N, downwards) at a time since its start: a ramp to one newton, a hold, a ramp down, then 0.
double testPush(double seconds, double peak_n);
/// s: kRamp, kHold and kFall of device_watch.cpp together.
inline constexpr double kTestSeconds = 4.0;
/// Largest force of the test, N, and at most half of the continuous force of the motors: felt, and not startling. Half:
/// less clear; twice: a loose hand is moved.
inline constexpr double kTestPush = 1.0;

/// What the device check knows of the running server: observes it as a client that controls nothing, keeps rate and
/// delay of the last minute, and can apply the test force (then it controls the stylus). GUI thread; never waits.
class DeviceWatch : public QObject {
  Q_OBJECT
 public:
  explicit DeviceWatch(QObject* parent = nullptr);
  ~DeviceWatch() override;

  void start(const std::string& host, int port);
  void stop();
  bool isConnected() const;
  const std::optional<haptic::DeviceDescription>& device() const { return device_; }
  const haptic::HapticState& state() const { return state_; }
  const haptic::ServerStatistics& statistics() const { return statistics_; }
  RangeTest& range() { return range_; }
  /// State of the device, and what its calibration asks of the user; empty for a simulated one.
  std::optional<haptic::DeviceCondition> condition() const { return link_ ? link_->condition() : std::nullopt; }
  void calibrate(unsigned step) {
    if (link_) link_->calibrate(step);
  }

  /// Ten per second, newest last, for at most a minute.
  struct RateSample {
    double rate_hz = 0.0, late_p99_ms = 0.0, late_max_ms = 0.0;
  };
  const std::deque<RateSample>& history() const { return history_; }

  /// Takes control and applies the force; no other client may control the stylus then. forceTestEnded() always follows.
  void startForceTest();
  void stopForceTest();
  bool forceTestRuns() const { return testing_; }
  /// Progress of the test, 0 to 1, while it runs.
  double forceTestProgress() const { return progress_; }

 signals:
  void changed();  ///< Ten times a second.
  /// `sentence` reports the result; `pushed_n` is the largest commanded force.
  void forceTestEnded(const QString& sentence, double pushed_n);

 private:
  void connectAs(haptic::ClientKind kind);
  void tick();
  void stepForceTest();
  void endForceTest(const QString& sentence);

  std::string host_;
  int port_ = 0;
  std::unique_ptr<haptic::TcpLink> link_;
  std::optional<haptic::DeviceDescription> device_;
  haptic::HapticState state_;
  haptic::ServerStatistics statistics_;
  RangeTest range_;
  std::deque<RateSample> history_;
  QTimer timer_;
  QElapsedTimer step_;
  bool testing_ = false;
  double waited_s_ = 0.0, pushing_s_ = -1.0, progress_ = 0.0, pushed_n_ = 0.0;
};

}  // namespace hapticell::app
