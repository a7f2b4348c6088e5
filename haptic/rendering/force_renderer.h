// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "geometry/shapes/pose.h"
#include "haptic/rendering/constraint_set.h"
#include "haptic/rendering/held_load.h"
#include "haptic/rendering/passivity.h"
#include "haptic/rendering/proxy_mover.h"
#include "haptic/rendering/proxy_rows.h"

namespace hapticell::haptic {

/// How stiff and how damped the coupling between stylus and proxy is.
struct RendererOptions {
  double stiffness = 1000.0;  ///< K wanted, N/m.
  double damping = 2.0;       ///< B wanted, N s/m.
  double delay = 0.001;       ///< From the measurement to the force that answers it, seconds.
  bool adapt = true;          ///< False: K and B are taken as they are, for finding out where they become unstable.
  double peak_force = 6.4;    ///< Of the device, N; forces are compared at set changes after clamping to it.
  double peak_torque = 0.0;   ///< N m. Above 0 turning is felt too, by K and B times the square of kRotationLever;
                              ///< else the proxy's turn is free and nothing is felt of it.
  double tick = 0.001;        ///< Nominal, s: how many ticks `delay` is.
};

/// The options that are stable with nobody holding the stylus: K <= 0.65 * 2.3 N/mm per millisecond of delay,
/// B >= 4 N s/m from 2 ms of delay on, and B <= 8 N s/m in any case: a filtered velocity times more kicks (the limits
/// of the project's own trial with the simulated device). Values that are not finite or not positive are replaced by
/// the defaults.
RendererOptions limitedByDelay(RendererOptions options);

/// What one tick of the force renderer yields. All in the device frame D.
struct RenderResult {
  Pose X_DP;                        ///< The proxy: where the stylus would be if it obeyed every constraint.
  dvec3 force_D{0.0};               ///< Wanted on the hand, N; not yet through the safety chain.
  dvec3 torque_D{0.0};              ///< Wanted on the hand, N m; zero where no turning is driven.
  dvec3 spring_D{0.0};              ///< The force's part K (y - x) + K o.
  dvec3 spring_torque_D{0.0};       ///< The torque's part of the same, N m.
  dvec3 load_D{0.0};                ///< Its part that load and pulls make, N.
  dvec3 v_DS{0.0};                  ///< Filtered velocity of the stylus, m/s.
  dvec3 v_DO{0.0};                  ///< Of what is touched, m/s; its work on the hand is none that the renderer made.
  dvec3 offset_D{0.0};              ///< o, what is left of blended set changes, m.
  std::size_t active_rows = 0;      ///< Rows that hold the proxy back, the trust row included.
  bool contact = false;             ///< One of them is a constraint.
  bool at_zone_edge = false;        ///< The trust row is one of them.
  double energy = 0.0;              ///< Passivity observer's balance, J; negative: the renderer made that much.
  double stiffness = 0.0;           ///< K in force now, N/m.
  double controller_damping = 0.0;  ///< What the passivity controller adds to B, N s/m.
  std::uint64_t adopted_set = 0;    ///< Sequence of the set that is rendered; 0 before the first.
  bool dropped = false;             ///< The set made no numbers of this tick and was dropped: no force, the last proxy.
};

/// What became of a set that was offered.
enum class Adoption : std::uint8_t {
  kAdopted,
  kMalformed,    ///< Not isWellFormed().
  kOutdated,     ///< Older than the one in use, which was taken within the last 2.5 s.
  kOutsideZone,  ///< The proxy is not inside its zone: the old set stays.
};

/// Turns stylus poses and constraint sets into a proxy and a force, a thousand times a second.
///
/// The proxy (ProxyMover) moves from its last place towards the stylus; the force is a virtual coupling (E. Colgate)
/// from the stylus to the proxy. A new set's force difference goes into an offset that decays, so that no change of set
/// is felt; a passivity observer and a ramped controller (PassivityController) are always on. docs/feel.md tells each
/// step and why.
///
/// Whatever the numbers of a set, the state stays finite: a tick whose proxy or force would be no number ends with the
/// last good proxy and without force, forgets the set and all that came of it, and tells so (RenderResult::dropped).
///
/// In free motion (no active row, no offset) the force is exactly zero. Owned by the force loop's thread; reset(),
/// adopt(), setOptions() and tick() neither allocate, lock nor throw. Needs about 60 kB.
class ForceRenderer {
 public:
  explicit ForceRenderer(const RendererOptions& options = {}) { setOptions(options); }

  /// Takes new options after limitedByDelay(). In contact the stiffness moves there over about 0.1 s.
  void setOptions(const RendererOptions& options);
  const RendererOptions& options() const { return options_; }

  /// Forgets the set, the offset and the energy; the proxy goes to the stylus.
  void reset(const Pose& X_DS);

  /// Offers a new set; it takes effect with the next tick. Anything but kAdopted changes nothing.
  /// `age` (s, at most 1 counts): how long ago the set was made, for what moves in it.
  Adoption adopt(const ConstraintSet& set, double age = 0.0);

  /// One step of `dt` seconds (nominally 0.001). A pose that is not valid counts as the last valid one.
  RenderResult tick(const Pose& X_DS, double dt);

  /// Tells what the safety chain let through of the last tick's force, so that the energy account is of the real force.
  /// Without this call the account takes the wanted force.
  void noteApplied(const dvec3& force_D, const dvec3& torque_D = dvec3(0.0));

  /// The next tick's stylus has not gone there: it is found there (SampleGate::Verdict::kJumped). Nothing that the way
  /// would have done is booked or remembered: the force goes on from what it was, and is the true one of the new place
  /// within 0.1 s up to 5 N.
  void noteJump() { jumped_ = true; }

  /// What the hand carries from the next tick on; it makes its force besides the contacts' and has no part in their
  /// energy account. reset() keeps it, but begins it anew.
  void setLoad(const LoadOptions& load) { load_.setOptions(load); }

  /// What warm motors bear now, N, where that is less than the peak force. A spring that would pull harder than either
  /// *yields*: its rest point creeps after the stylus, so that the force stays there and falls at once when the hand
  /// withdraws. Scaling the force instead would stiffen the spring under load as the motors cool, and a hand that comes
  /// back from too deep would be given more than |F|^2 / 2K. What is no positive number counts as no further limit.
  void setForceLimit(double newtons) {
    force_limit_ = newtons > 0.0 && newtons < options_.peak_force ? newtons : kNoLimit;
  }

  const Pose& proxy() const { return proxy_; }
  /// Of the last tick's command what the coupling made, after noteApplied(): what the energy account is of.
  const MetricVector& applied() const { return last_.applied; }
  /// The way from X_DA to X_DB that the device can feel.
  MetricVector way(const Pose& X_DB, const Pose& X_DA) const { return mover_.way(X_DB, X_DA); }

 private:
  /// What a change of sets alone does to the proxy, to the stretch of the spring and to the trust row's part of it, m.
  struct SetJump {
    MetricVector proxy_D, stretch_D, trust_D;
  };
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  ProxyStep changeSet(const Pose& X_DS, double dt, SetJump& jump);
  bool isLate(const ProxyStep& solved) const;
  MetricVector stretchOf(const ProxyStep& solved, const Pose& X_DS) const;
  MetricVector takeOutJump(const ProxyStep& solved, const MetricVector& stretch_D, const SetJump& jump,
                           const MetricVector& stylus_step, double dt);
  void filterVelocities(const MetricVector& stylus_step, const MetricVector& proxy_step, double dt);
  void decayOffset(const ProxyStep& solved, const MetricVector& stylus_step, double dt);
  void updateCoupling(const ProxyStep& solved, double dt);
  void updateDamper(bool catches_up, double dt);
  MetricVector beginAnew(const ProxyStep& solved, const MetricVector& stretch_D);
  bool restsFor(double seconds, double dt);
  void creepBack(const ProxyStep& solved, const MetricVector& stretch_D, double dt);
  void updateSpring(const ProxyStep& solved, const MetricVector& stretch_D, const MetricVector& relative_step,
                    double dt);
  dvec3 pullOf(const Pose& X_DS) const;
  MetricVector couplingForce(const ProxyStep& solved) const;
  MetricVector unpulling(const MetricVector& damper_D) const;
  MetricVector pushing(const MetricVector& spring_D, const MetricVector& left_D) const;
  MetricVector borne(const MetricVector& stretch_D);
  double forceLimit(const MetricVector& direction_D) const;
  RenderResult resultOf(const ProxyStep& solved) const;
  RenderResult endWithoutSet(const Pose& X_DP, const Pose& X_DS);

  RendererOptions options_;
  ProxyMover mover_;
  HeldLoad load_;
  std::array<GroupedSet, 2> sets_{};
  std::size_t current_ = 0;  ///< Index of the set in use; the other one is the offered one.
  bool has_set_ = false;
  bool offered_ = false;
  bool started_ = false;
  double since_adoption_ = 0.0;
  double set_period_ = 0.1;  ///< Time between the last two adoptions, s.

  Pose proxy_;
  Pose stylus_;
  MetricVector offset_D_;
  MetricVector stretch_D_;  ///< Of the last tick, before it yields.
  MetricVector trust_D_;    ///< Of the last tick: see ProxyStep::trust_D.
  double yield_ = 0.0;      ///< By how much the spring has yielded, m,
  double yielded_ = 0.0;    ///< and what of the hand's work that took and has not come back, J.
  Pose rest_;               ///< Where the stylus rests,
  double resting_ = 0.0;    ///< and since when, s.
  double force_limit_ = kNoLimit;
  MetricVector v_stylus_D_, v_proxy_D_;
  MetricVector v_slow_D_;  ///< The stylus's for the passivity controller, more filtered.
  HeldSpring last_;        ///< Of the last tick.
  dvec3 load_D_{0.0};      ///< Of the last tick, N.
  double stiffness_ = 1000.0;
  double damping_ = 2.0;
  PassivityController passivity_;
  SpringRation ration_;
  bool contact_ = false;
  bool jumped_ = false;  ///< See noteJump().
  bool late_ = false;    ///< The proxy comes out of free air after the stylus and has not arrived: nothing presses yet.
  bool arriving_ = false;  ///< The proxy has caught up from far off: its damping comes back by and by.
  double damper_ = 0.0;    ///< Share of the coupling's damping that acts.
};

}  // namespace hapticell::haptic
