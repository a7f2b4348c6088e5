// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "haptic/rendering/energy_account.h"

namespace hapticell::haptic {

/// Passivity observer and controller (B. Hannaford, J.-H. Ryu, 2002): an EnergyAccount that forgets gains, and a damper
/// on the stylus that rises by 0.1 N s/m per millisecond while more than 0.2 mJ are lost, and otherwise falls at the
/// same rate.
///
/// Force loop's thread; never allocates, locks or throws.
class PassivityController {
 public:
  void setDelay(int ticks) {
    delay_ = ticks;
    account_.setDelay(ticks);
  }
  void reset();
  /// Adds the work of the last tick's force on the stylus's motion since; see EnergyAccount::add().
  void add(const MetricVector& step, const MetricVector& commanded, double stiffness);
  /// `energy` J of the spring's future gain was already paid for by the hand and does not count as loss. Valid until
  /// the contact ends.
  void prepay(double energy) { prepaid_ += energy; }
  /// Advances by `dt` seconds. The damper acts only in `contact`.
  void step(bool contact, double dt);

  double balance() const { return account_.balance(); }  ///< J, 0 or negative.
  double recentLoss() const;                             ///< Fall of the balance within the last second, J.
  double damping() const { return damping_; }            ///< N s/m.

 private:
  static constexpr std::size_t kSlices = 20;
  void noteHighest(double dt);

  int delay_ = 0;         ///< Ticks until a command acts.
  double prepaid_ = 0.0;  ///< J remaining of prepay().
  EnergyAccount account_;
  double damping_ = 0.0;                   ///< N s/m.
  std::array<double, kSlices> highest_{};  ///< J, the highest balance in each slice of the last second; a ring.
  std::size_t slice_ = 0;                  ///< Index of the current slice in the ring.
  double slice_age_ = 0.0;                 ///< s since it began.
};

/// The coupling's last tick, for the ration.
struct HeldSpring {
  MetricVector spring;   ///< K times its stretch, N.
  MetricVector wanted;   ///< Spring and dampers, N.
  MetricVector applied;  ///< Part of `wanted` that passed the safety chain, N.
  double stiffness = 1000.0;
  double limit = 0.0;  ///< Largest force that can act, N.
};

/// Shortens a spring that would store more energy than the hand has paid for. This happens if a set lies deeper than
/// the one before, if the wrist turns (a device with three driven axes does not drive that), or if a proxy catches up.
/// In addition to the hand's work the spring may gain 0.25 mW, 0.15 mJ at once, and no more than limit(). The part that
/// is cut off stays in the offset; the direction is free.
class SpringRation {
 public:
  void reset();
  /// Sets the most that the spring gains without the hand's work (J, 0 or more), until the next call.
  void limit(double room) { room_ = room; }
  /// Allows `energy` J more, once and for 0.15 s: for a spring that was created again instead of stretched, or for
  /// returned work of the hand.
  void grant(double energy);
  /// Returns `stretch` (m), shortened as far as needed; the stylus moved by `step` since `last`.
  MetricVector apply(const MetricVector& stretch, double stiffness, const HeldSpring& last, const MetricVector& step,
                     double dt);
  /// J that the hand had paid for at the last apply() but that the spring did not store.
  double lost() const { return lost_; }

 private:
  double lost_ = 0.0;
  double budget_ = 0.0;       ///< J that the spring may still gain without the hand's work.
  double grant_ = 0.0;        ///< J remaining of grant(),
  double grant_lasts_ = 0.0;  ///< and how long they are valid, s.
  double room_ = 1.0;         ///< J, upper limit of budget_; practically no limit until limit() is called.
};

}  // namespace hapticell::haptic
