// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <utility>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

/// The energy, J, stored in a coupling of `stiffness` K whose spring would pull with `spring` newtons if at most
/// `limit` can act: the work that the hand gets back, |F| s - |F|^2 / 2K at stretch s. Without a limit this is |F|^2 /
/// 2K.
double storedEnergy(double spring, double stiffness, double limit);

/// The pull, N, at which storedEnergy() is `energy`.
double springThatStores(double energy, double stiffness, double limit);

/// The energy account (docs/dev/feel.md): what the hand receives from the motors. The renderer's passivity observer, the
/// feel benchmark and `session` all use it.
///
/// A force that is commanded in one tick acts, as a real motor's does, `delay_ticks` later, until the next tick; its
/// work is the force times the motion of the stylus in that time. The coupling stores |F|^2 / 2K of the same acting
/// force. balance = work of the hand against the force minus the stored energy; if it falls, the rendering has
/// generated energy. Never allocates, locks or throws.
class EnergyAccount {
 public:
  /// `delay_ticks`: 0 .. 15 ticks from the command to the motor.
  explicit EnergyAccount(int delay_ticks = 0) { setDelay(delay_ticks); }
  void setDelay(int delay_ticks);

  /// One tick: `commanded` was commanded at its beginning, and the stylus moved by `step` in it, relative to what it
  /// touches. `stiffness` N/m.
  void add(const MetricVector& step, const MetricVector& commanded, double stiffness);
  /// Forgets the energy that the hand put in and did not get back; from now on only losses count.
  void forgetGains();

  /// Books `energy` J of the stored energy as work that the hand did earlier and that was forgotten.
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

/// The largest fall of a balance within any window of time: M3. Not for the force loop: it allocates.
class WorstLoss {
 public:
  explicit WorstLoss(double window = 1.0) : window_(window) {}
  void add(double t, double balance);
  double value() const { return worst_; }  ///< J, 0 or negative.

 private:
  double window_;
  double worst_ = 0.0;
  std::deque<std::pair<double, double>> highest_;  ///< Decreasing balances of the window; its maximum is first.
};

/// The worst loss of an EnergyAccount over a session. Not for the force loop: it allocates.
class EnergyLossMeter {
 public:
  /// `delay_ticks`: of the device.
  explicit EnergyLossMeter(int delay_ticks = 0) : account_(delay_ticks) {}
  /// See EnergyAccount::add().
  void add(const MetricVector& step, const MetricVector& commanded, double stiffness) {
    account_.add(step, commanded, stiffness);
  }
  /// Takes the balance at `t` s into account.
  void note(double t) { loss_.add(t, account_.balance()); }
  /// Forgets the losses so far.
  void forgetLoss() { loss_ = WorstLoss(); }
  double worst() const { return loss_.value(); }  ///< J, 0 or negative.

 private:
  EnergyAccount account_;
  WorstLoss loss_;
};

}  // namespace hapticell::haptic
