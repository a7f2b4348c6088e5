// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"
#include "haptic/rendering/motor_limit.h"
#include "haptic/rendering/passivity.h"
#include "haptic/rendering/proxy_mover.h"

namespace hapticell::haptic {

/// Since when a hand rests. The place that it rests about follows it slowly, so that a hand that gives way to what
/// comes back still rests.
class RestWatch {
 public:
  void reset() { since_ = 0.0; }
  /// The stylus, `dt` s after the last call; whether it has rested for kRested.
  bool rests(const ProxyMover& mover, const Pose& X_DS, double dt);

 private:
  Pose place_;
  double since_ = 0.0;  ///< s.
};

/// The spring of the coupling from the stylus to the proxy: its stretch, the offset that takes out the jumps of the
/// force at a change of sets and decays, and how far it has yielded at the limit of the motors. Lengths in m, in the
/// metric of the device's frame D.
///
/// A spring that would pull harder than the motors bear yields like a ductile metal: beyond the limit the rest point
/// follows, and back it unloads along the full stiffness to nothing, never to a pull.
///
/// Force loop's thread; never allocates, locks or throws.
class CouplingSpring {
 public:
  MotorLimit& motors() { return motors_; }
  void setStiffness(double stiffness) { stiffness_ = stiffness; }  ///< N/m.
  void reset();

  /// A set's change turns a stretch of `before` into one of `after`: the force goes on from where it was.
  void changeStretch(const MetricVector& before_D, const MetricVector& after_D);
  /// After a jump of the stylus the spring has not been stretched, it is made anew where the stylus is now. Its force
  /// goes on from what it was, and comes to the new one by the offset's decay.
  void beginAnew(const MetricVector& stretch_D, bool contact);
  /// Stretches it; returns by how much more than in the last tick. `by_set_D`: what of that the change of sets made.
  MetricVector stretchTo(const MetricVector& stretch_D, const MetricVector& by_set_D, const MetricVector& stylus_step);
  /// Moves `excess_D` of the stretch into the offset.
  void absorb(const MetricVector& excess_D);
  void decayOffset(bool contact, const MetricVector& stylus_step, double dt);

  /// A spring that has yielded is not what it should be for ever: under a hand that `rests` it comes back, by way of
  /// the offset. What the hand itself has put into the yielding pays for that: all that the motors bear is there in 1.5
  /// s. What yielded otherwise comes no faster than the ration allows. Returns J that the hand has paid for.
  double creepBack(bool rests, bool contact, double dt);
  /// The spring of this tick. `holds`: a row holds the proxy. `room`: J that it may gain without the hand's work.
  /// `relative_step`: of the stylus against what is touched.
  void update(bool holds, double room, const MetricVector& relative_step, double dt);

  /// What damps, without what would pull at a hand that lifts from what holds the proxy: while an offset fades the
  /// spring may point anywhere.
  MetricVector withoutPull(const MetricVector& damper_D) const;
  void noteWanted(const MetricVector& force_D);
  /// What the safety chain let through of the wanted force.
  void noteApplied(const MetricVector& force_D);

  const HeldSpring& last() const { return last_; }
  const MetricVector& offset_D() const { return offset_D_; }
  double yielded() const { return yielded_; }  ///< J of the hand's work that yielding took and that has not come back.

 private:
  MetricVector borne(const MetricVector& stretch_D);
  MetricVector pushing(const MetricVector& spring_D, const MetricVector& left_D) const;

  MotorLimit motors_;
  double stiffness_ = 1000.0;
  MetricVector offset_D_;
  MetricVector stretch_D_;   ///< Of the last tick, before it yields.
  double yield_ = 0.0;       ///< By how much the spring has yielded, m.
  double last_yield_ = 0.0;  ///< That before it crept back in this tick.
  double yielded_ = 0.0;
  HeldSpring last_;  ///< Of the last tick.
  SpringRation ration_;
};

}  // namespace hapticell::haptic
