// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/shapes/pose.h"
#include "haptic/rendering/constraint_set.h"
#include "haptic/rendering/coupling_gains.h"
#include "haptic/rendering/coupling_spring.h"
#include "haptic/rendering/filtered_velocities.h"
#include "haptic/rendering/held_load.h"
#include "haptic/rendering/passivity.h"
#include "haptic/rendering/proxy_mover.h"
#include "haptic/rendering/renderer_options.h"
#include "haptic/rendering/set_slots.h"

namespace hapticell::haptic {

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
/// is felt; a passivity observer and a ramped controller (PassivityController) are always on. docs/dev/feel.md tells
/// each step and why.
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
  void setForceLimit(double newtons) { spring_.motors().setWarmLimit(newtons); }

  const Pose& proxy() const { return proxy_; }
  /// Of the last tick's command what the coupling made, after noteApplied(): what the energy account is of.
  const MetricVector& applied() const { return spring_.last().applied; }
  /// The way from X_DA to X_DB that the device can feel.
  MetricVector way(const Pose& X_DB, const Pose& X_DA) const { return mover_.way(X_DB, X_DA); }

 private:
  /// What a change of sets alone does to the proxy, to the stretch of the spring and to the trust row's part of it, m.
  struct SetJump {
    MetricVector proxy_D, stretch_D, trust_D;
  };

  ProxyStep changeSet(const Pose& X_DS, double dt, SetJump& jump);
  bool isLate(const ProxyStep& solved) const;
  MetricVector stretchOf(const ProxyStep& solved, const Pose& X_DS) const;
  MetricVector beginAnew(const ProxyStep& solved, const MetricVector& stretch_D);
  MetricVector takeOutJump(const ProxyStep& solved, const MetricVector& stretch_D, const SetJump& jump,
                           const MetricVector& stylus_step, double dt);
  void updateSpring(const ProxyStep& solved, const MetricVector& stylus_step, double dt);
  dvec3 pullOf(const Pose& X_DS) const;
  MetricVector couplingForce(const ProxyStep& solved) const;
  bool isFinite() const;
  RenderResult resultOf(const ProxyStep& solved) const;
  RenderResult endWithoutSet(const Pose& X_DP, const Pose& X_DS);

  RendererOptions options_;
  ProxyMover mover_;
  HeldLoad load_;
  SetSlots sets_;
  bool started_ = false;
  Pose proxy_;
  Pose stylus_;
  MetricVector trust_D_;  ///< Of the last tick: see ProxyStep::trust_D.
  FilteredVelocities velocities_;
  CouplingGains gains_;
  RestWatch rest_;
  CouplingSpring spring_;
  PassivityController passivity_;
  dvec3 load_D_{0.0};  ///< Of the last tick, N.
  bool contact_ = false;
  bool jumped_ = false;  ///< See noteJump().
  bool late_ = false;    ///< The proxy comes out of free air after the stylus and has not arrived: nothing presses yet.
};

}  // namespace hapticell::haptic
