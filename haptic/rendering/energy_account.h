// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <utility>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

/// What a coupling of `stiffness` K holds when its spring would pull with `spring` newtons but at most `limit` can act:
/// the work that the hand gets back, |F| s - |F|^2 / 2K at stretch s. Without a limit the familiar |F|^2 / 2K. Joules.
double storedEnergy(double spring, double stiffness, double limit);

/// The pull, N, at which storedEnergy() is so much.
double springThatStores(double energy, double stiffness, double limit);

/// The one energy account (docs/dev/feel.md): what the hand receives from the motors. The renderer's passivity
/// observer, the feel benchmark and `session` book by it.
///
/// A force that is commanded in one tick acts, as a real motor's does, `delay_ticks` later, until the next tick; its
/// work is that times the way that the stylus goes meanwhile. What the coupling holds is |F|^2 / 2K of the same acting
/// force. balance = work of the hand into the force less what is held: when it falls, the rendering made energy.
/// Never allocates, locks or throws.
class EnergyAccount {
 public:
  /// 0 .. 15 ticks from the command to the motor.
  explicit EnergyAccount(int delay_ticks = 0) { setDelay(delay_ticks); }
  void setDelay(int delay_ticks);

  /// One tick: `commanded` was commanded at its beginning, and the stylus has gone `step` meanwhile, as seen from what
  /// it touches. `stiffness` N/m.
  void add(const MetricVector& step, const MetricVector& commanded, double stiffness);
  /// Forgets what the hand has put in and not got back: from now on only losses count.
  void forgetGains();

  /// `energy` J of what is held now the hand has put in before, and it was forgotten.
  void credit(double energy) { work_ += energy; }

  double balance() const { return work_ - held_; }  ///< J.
  double held() const { return held_; }             ///< J.
  const MetricVector& acting() const { return acting_; }

 private:
  static constexpr std::size_t kLongest = 16;
  std::array<MetricVector, kLongest> commanded_{};  ///< A ring; `next_` is the next to be written.
  std::size_t next_ = 0;
  std::size_t delay_ = 0;
  MetricVector acting_;
  double work_ = 0.0, held_ = 0.0;
};

/// The worst fall of a balance within any window of time: M3. Not for the force loop: it allocates.
class WorstLoss {
 public:
  explicit WorstLoss(double window = 1.0) : window_(window) {}
  void add(double t, double balance);
  double value() const { return worst_; }  ///< J, 0 or negative.

 private:
  double window_;
  double worst_ = 0.0;
  std::deque<std::pair<double, double>> highest_;  ///< Falling balances of the window: its maximum first.
};

/// The worst loss of an EnergyAccount over a session. Not for the force loop: it allocates.
class EnergyLossMeter {
 public:
  /// `delay_ticks` of the device.
  explicit EnergyLossMeter(int delay_ticks = 0) : account_(delay_ticks) {}
  /// See EnergyAccount::add().
  void add(const MetricVector& step, const MetricVector& commanded, double stiffness) {
    account_.add(step, commanded, stiffness);
  }
  /// The balance at `t` s counts.
  void note(double t) { loss_.add(t, account_.balance()); }
  /// What was lost so far counts no longer.
  void forgetLoss() { loss_ = WorstLoss(); }
  double worst() const { return loss_.value(); }  ///< J, 0 or negative.

 private:
  EnergyAccount account_;
  WorstLoss loss_;
};

}  // namespace hapticell::haptic
