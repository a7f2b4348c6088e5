// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

#include "app/viewport/scene/camera.h"

namespace hapticell::app {

/// The camera of a view, and its way of 250 ms to another one. GUI thread.
class TurningCamera {
 public:
  Camera now;  ///< As the scene is seen.

  /// Goes to it from where it is now.
  void turnTo(const Camera& camera) {
    from_ = now;
    goal_ = camera;
    clock_.start();
    turning_ = true;
  }
  /// Is there at once.
  void set(const Camera& camera) {
    turning_ = false;
    now = camera;
  }
  /// Stays where it is.
  void stop() { turning_ = false; }
  bool isTurning() const { return turning_; }
  /// Where it will be at the end.
  const Camera& goal() const { return turning_ ? goal_ : now; }
  void setPerspective(bool on) { now.perspective = goal_.perspective = on; }
  /// To be called before each frame; false where it does not turn.
  bool advance() {
    if (!turning_) return false;
    // s of a turn to another view: one sees which way. Half: a jump; twice: one waits.
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
