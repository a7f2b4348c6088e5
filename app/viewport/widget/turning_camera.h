// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

#include "app/viewport/scene/camera.h"

namespace hapticell::app {

/// The camera of a view, and its animation of 250 ms to another camera. GUI thread.
class TurningCamera {
 public:
  Camera now;  ///< The camera of the present picture.

  /// Starts a turn from the present camera.
  void turnTo(const Camera& camera) {
    from_ = now;
    goal_ = camera;
    clock_.start();
    turning_ = true;
  }
  /// Sets the camera at once.
  void set(const Camera& camera) {
    turning_ = false;
    now = camera;
  }
  /// Stops at the present camera.
  void stop() { turning_ = false; }
  bool isTurning() const { return turning_; }
  /// The camera at the end of the turn.
  const Camera& goal() const { return turning_ ? goal_ : now; }
  void setPerspective(bool on) { now.perspective = goal_.perspective = on; }
  /// Call it before each frame; false if it is not turning.
  bool advance() {
    if (!turning_) return false;
    // s; duration of a turn to another view, so that its direction is visible. Half: a jump; twice: the user waits.
    constexpr double kTurnSeconds = 0.25;
    const double s = static_cast<double>(clock_.elapsed()) / 1000.0 / kTurnSeconds;
    now = s >= 1.0 ? goal_ : interpolate(from_, goal_, eased(s));
    turning_ = s < 1.0;
    return true;
  }

 private:
  Camera from_, goal_;
  QElapsedTimer clock_;
  bool turning_ = false;
};

}  // namespace hapticell::app
