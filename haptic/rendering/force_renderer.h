// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "geometry/pose.h"
#include "haptic/rendering/constraint_set.h"
#include "haptic/rendering/held_load.h"
#include "haptic/rendering/proxy_rows.h"

namespace hapticell::haptic {

/// How stiff and how damped the coupling between stylus and proxy is.
struct RendererOptions {
  double stiffness = 1000.0;  ///< K wanted, N/m.
  double damping = 2.0;       ///< B wanted, N s/m.
  double delay = 0.001;       ///< From the measurement to the force that answers it, seconds.
  bool adapt = true;          ///< False: K and B are taken as they are, for finding out where they become unstable.
  double peak_force = 6.4;    ///< Of the device, N; forces are compared at set changes after clamping to it.
};

/// The options that are stable with nobody holding the stylus: K <= 0.65 * 2.3 N/mm per millisecond of delay, and
/// B >= 4 N s/m from 2 ms of delay on (the limits of the project's own trial with the simulated device). Values that
/// are not finite or not positive are replaced by the defaults.
RendererOptions limitedByDelay(RendererOptions options);

/// What one tick of the force renderer yields. All in the device frame D.
struct RenderResult {
  Pose X_DP;                        ///< The proxy: where the stylus would be if it obeyed every constraint.
  dvec3 force_D{0.0};               ///< Wanted on the hand, N; not yet through the safety chain.
  dvec3 spring_D{0.0};              ///< Its part K (y - x) + K o.
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
};

/// What a coupling of `stiffness` K holds when its spring would pull with `spring` newtons but at most `limit` can act:
/// the work that the hand gets back, |F| s - |F|^2 / 2K at stretch s. Without a limit the familiar |F|^2 / 2K. Joules.
double storedEnergy(double spring, double stiffness, double limit);

/// What became of a set that was offered.
enum class Adoption : std::uint8_t {
  kAdopted,
  kMalformed,    ///< Not isWellFormed().
  kOutdated,     ///< Older than the one in use.
  kOutsideZone,  ///< The proxy is not inside its zone: the old set stays.
};

/// Turns stylus poses and constraint sets into a proxy and a force, a thousand times a second.
///
/// The proxy (god-object; C. Zilles, K. Salisbury, 1995) moves from its last place towards the stylus inside one
/// half-space per group, found by nearestFeasible(); the force is a virtual coupling (E. Colgate) from the stylus to
/// the proxy. A new set's force difference goes into an offset that decays, so that no change of set is felt; a
/// passivity observer and a ramped controller (B. Hannaford, J.-H. Ryu, 2002) are always on. docs/feel.md tells each
/// step and why.
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
  void noteApplied(const dvec3& force_D);

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

 private:
  struct Solved;
  /// What a change of sets alone does to the proxy and to the stretch of the spring, m.
  struct SetJump {
    dvec3 proxy_D{0.0};
    dvec3 stretch_D{0.0};
  };
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  Solved moveProxy(const GroupedSet& grouped, const Pose& X_DS, double dt) const;
  void applyFriction(const GroupedSet& grouped, Solved& solved, double dt) const;
  Solved changeSet(const Pose& X_DS, double dt, SetJump& jump);
  dvec3 stretchOf(const Solved& solved, const Pose& X_DS) const;
  dvec3 takeOutJump(const Solved& solved, const dvec3& stretch_D, const SetJump& jump, const dvec3& stylus_step,
                    double dt);
  void filterVelocities(const dvec3& stylus_step, const dvec3& proxy_step, double dt);
  void decayOffset(const Solved& solved, const dvec3& stylus_step, double dt);
  dvec3 rationed(const dvec3& spring_D, const dvec3& stylus_step, double dt);
  void updateCoupling(const Solved& solved, double dt);
  dvec3 pullOf(const Pose& X_DS) const;
  dvec3 couplingForce(const Solved& solved) const;
  dvec3 pushing(const dvec3& spring_D, const dvec3& left_D) const;
  dvec3 borne(const dvec3& stretch_D);
  double forceLimit() const { return std::min(force_limit_, options_.peak_force); }
  void observeEnergy(const dvec3& stylus_step, bool contact, double dt);

  RendererOptions options_;
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
  dvec3 offset_D_{0.0};
  dvec3 stretch_D_{0.0};  ///< Of the last tick, before it yields.
  double yield_ = 0.0;    ///< By how much the spring has yielded, m.
  double force_limit_ = kNoLimit;
  dvec3 v_stylus_D_{0.0};
  dvec3 v_proxy_D_{0.0};
  dvec3 spring_D_{0.0};
  dvec3 applied_D_{0.0};                                    ///< Force of the last tick, N.
  dvec3 load_D_{0.0};                                       ///< Of the last tick, N.
  dvec3 wanted_D_{0.0};                                     ///< Of the last tick, N.
  double limit_ = std::numeric_limits<double>::infinity();  ///< What the safety chain let through at most, N.
  double stiffness_ = 1000.0;
  double held_stiffness_ = 1000.0;  ///< Of the last tick.
  double damping_ = 2.0;
  double energy_ = 0.0;   ///< Taken up and not forgotten, J.
  double balance_ = 0.0;  ///< energy_ less what the spring holds, J.
  double controller_damping_ = 0.0;
  double unpaid_budget_ = 0.0;  ///< What the spring may still gain without the hand's work, J.
  bool contact_ = false;
};

}  // namespace hapticell::haptic
