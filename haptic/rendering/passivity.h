// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "haptic/rendering/energy_account.h"

namespace hapticell::haptic {

/// Passivity observer and controller (B. Hannaford, J.-H. Ryu, 2002): an EnergyAccount that forgets gains, and a damper
/// on the stylus that rises by 0.1 N s/m a millisecond while more than 0.2 mJ are lost, and falls likewise.
///
/// Force loop's thread; never allocates, locks or throws.
class PassivityController {
 public:
  void setDelay(int ticks) {
    delay_ = ticks;
    account_.setDelay(ticks);
  }
  void reset();
  /// What the last tick's force did on the stylus's way since; see EnergyAccount::add().
  void add(const MetricVector& step, const MetricVector& commanded, double stiffness);
  /// `energy` J that the spring gains from now on the hand has paid for before: no loss. It lasts while the contact
  /// does.
  void prepay(double energy) { prepaid_ += energy; }
  /// Lets `dt` seconds pass. The damper acts only in `contact`.
  void step(bool contact, double dt);

  double balance() const { return account_.balance(); }  ///< J, 0 or negative.
  double recentLoss() const;                             ///< J that the balance has fallen within the last second.
  double damping() const { return damping_; }            ///< N s/m.

 private:
  static constexpr std::size_t kSlices = 20;
  void noteHighest(double dt);

  int delay_ = 0;         ///< Ticks until a command acts.
  double prepaid_ = 0.0;  ///< J that are left of prepay().
  EnergyAccount account_;
  double damping_ = 0.0;                   ///< N s/m.
  std::array<double, kSlices> highest_{};  ///< J, the highest balance in each slice of the last second; a ring.
  std::size_t slice_ = 0;                  ///< Of the ring, the one of now.
  double slice_age_ = 0.0;                 ///< s since it began.
};

/// What the coupling's last tick was, for the ration.
struct HeldSpring {
  MetricVector spring;   ///< K times its stretch, N.
  MetricVector wanted;   ///< Spring and dampers, N.
  MetricVector applied;  ///< What the safety chain let through of it, N.
  double stiffness = 1000.0;
  double limit = 0.0;  ///< N that can act at most.
};

/// Shortens a spring that would hold more than the hand has paid for: a set that lies deeper than the one before, a
/// turn of the wrist, which no device of three driven axes feels, a proxy that catches up. Beside the hand's own work
/// it may gain 0.25 mW, and 0.15 mJ at once, and no more than limit() says. What is cut off stays in the offset, the
/// direction is free.
class SpringRation {
 public:
  void reset();
  /// From now on the spring gains at most this without the hand's work (J, 0 or more), until it is told anew.
  void limit(double room) { room_ = room; }
  /// Besides, once and for 0.15 s, `energy` J more: what a spring holds that was made anew and not stretched, or what
  /// comes back of the hand's own work.
  void grant(double energy);
  /// `stretch` (m) shortened as far as needed; the stylus has gone `step` since `last`.
  MetricVector apply(const MetricVector& stretch, double stiffness, const HeldSpring& last, const MetricVector& step,
                     double dt);
  /// J that the hand had paid for at the last apply() and that the spring did not hold.
  double lost() const { return lost_; }

 private:
  double lost_ = 0.0;
  double budget_ = 0.0;       ///< J that the spring may still gain without the hand's work.
  double grant_ = 0.0;        ///< J of grant() that are left,
  double grant_lasts_ = 0.0;  ///< and for how long, s.
  double room_ = 1.0;         ///< J, the most that budget_ may be; as good as none until limit() is called.
};

}  // namespace hapticell::haptic
