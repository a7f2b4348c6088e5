// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"
#include "haptic/rendering/motor_limit.h"
#include "haptic/rendering/passivity.h"
#include "haptic/rendering/proxy_mover.h"

namespace hapticell::haptic {

/// Measures how long a hand rests. The reference position follows the hand slowly, so a hand that yields to a returning
/// force still rests.
class RestWatch {
 public:
  void reset() { since_ = 0.0; }
  /// Takes the stylus's pose, `dt` s after the last call; returns whether it has rested for kRested.
  bool rests(const ProxyMover& mover, const Pose& X_DS, double dt);

 private:
  Pose place_;
  double since_ = 0.0;  ///< s.
};

/// The spring of the coupling from the stylus to the proxy: its stretch, the decaying offset that removes force jumps
/// at a change of sets, and how far the spring has yielded at the motors' limit. Lengths in m, in the metric of the
/// device's frame D.
///
/// A spring that would pull harder than the motors can yields like a ductile metal: beyond the limit the rest point
/// follows the stylus; on the way back it unloads with the full stiffness to zero, never to a pull.
///
/// Force loop's thread; never allocates, locks or throws.
class CouplingSpring {
 public:
  MotorLimit& motors() { return motors_; }
  void setStiffness(double stiffness) { stiffness_ = stiffness; }  ///< N/m.
  void reset();

  /// A change of sets turns a stretch of `before` into one of `after`; the force continues without a jump.
  void changeStretch(const MetricVector& before_D, const MetricVector& after_D);
  /// After a jump of the stylus the spring was not stretched by the hand: it is created again at the stylus's new pose.
  /// Its force continues from the old value and reaches the new one as the offset decays.
  void restartStretch(const MetricVector& stretch_D, bool contact);
  /// Sets the stretch; returns the increase since the last tick. `by_set_D`: the part of it that the change of sets
  /// caused.
  MetricVector stretchTo(const MetricVector& stretch_D, const MetricVector& by_set_D, const MetricVector& stylus_step);
  /// Moves `excess_D` of the stretch into the offset.
  void absorb(const MetricVector& excess_D);
  void decayOffset(bool contact, const MetricVector& stylus_step, double dt);

  /// Lets a yielded spring recover, through the offset, if the hand `rests`. The work that the hand put into the
  /// yielding pays for it: the motors' full force is back in 1.5 s. Other yielding recovers no faster than the ration
  /// allows. Returns the energy that the hand has paid for, J.
  double creepBack(bool rests, bool contact, double dt);
  /// Computes the spring of this tick. `holds`: a row holds the proxy. `room`: J that the spring may gain without the
  /// hand's work. `relative_step`: motion of the stylus relative to what it touches.
  void update(bool holds, double room, const MetricVector& relative_step, double dt);

  /// The damper's force without the part that would pull at a hand that lifts off a contact: while an offset fades, the
  /// spring may point anywhere.
  MetricVector withoutPull(const MetricVector& damper_D) const;
  void noteWanted(const MetricVector& force_D);
  /// Stores the part of the wanted force that passed the safety chain.
  void noteApplied(const MetricVector& force_D);

  const HeldSpring& last() const { return last_; }
  const MetricVector& offset_D() const { return offset_D_; }
  double yielded() const {
    return yielded_;
  }  ///< J of the hand's work that went into yielding and is not recovered
     ///< yet.

 private:
  MetricVector borne(const MetricVector& stretch_D);
  MetricVector pushing(const MetricVector& spring_D, const MetricVector& left_D) const;

  MotorLimit motors_;
  double stiffness_ = 1000.0;
  MetricVector offset_D_;
  MetricVector stretch_D_;   ///< Stretch of the last tick, before yielding.
  double yield_ = 0.0;       ///< How far the spring has yielded, m.
  double last_yield_ = 0.0;  ///< The same before the recovery in this tick.
  double yielded_ = 0.0;
  HeldSpring last_;  ///< Of the last tick.
  SpringRation ration_;
};

}  // namespace hapticell::haptic
