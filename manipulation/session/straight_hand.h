// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "haptic/devices/hand_path.h"

namespace hapticell::manipulation {

/// How a StraightHand differs from others.
struct StraightHandOptions {
  Pose X_WG;                   ///< Where the moved frame is to go.
  double scale = 1.0;          ///< Metres of the cell a metre of hand; the axes are the cell's.
  double stiffness = 300.0;    ///< N/m of the hand, as HandOptions.
  double push = 1.0;           ///< N with which it goes on where it is held back, at most.
  double speed = 0.08;         ///< m/s of hand.
  double tremor = 0.2e-3;      ///< m, at about 9 Hz.
  std::uint64_t seed = 1;
};

/// Options with push (0.7 to 1.3 N), speed (0.06 to 0.12 m/s) and tremor (0.1 to 0.3 mm) by the seed.
StraightHandOptions seededHand(std::uint64_t seed);

/// A simulated hand that knows nothing of the cell but where the goal is: it takes the entity, moves it straight towards
/// the goal from wherever it is, turns the wrist towards the goal's orientation in the measure in which it comes nearer,
/// and gives way to whatever force holds it back or leads it aside. Described in docs/dev/performance.md. The same
/// options give the same hand.
class StraightHand {
 public:
  explicit StraightHand(const StraightHandOptions& options);

  /// The intended pose at `t` (s; increasing), with the stylus at X_DS and the moved frame at X_WM. The button is
  /// pressed from 50 to 150 ms, which takes the chosen entity; the hand moves from 300 ms on.
  haptic::HandSample next(double t, const Pose& X_DS, const Pose& X_WM);

 private:
  StraightHandOptions options_;
  bool started_ = false;
  double last_t_ = 0.0;
  Pose X_DH_;
  double last_left_ = 0.0;
  dvec3 phase_{0.0};
};

}  // namespace hapticell::manipulation
