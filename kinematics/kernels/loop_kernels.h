// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::kinematics::kernels {

// Closed forms and Newton steps of parallel robots, built twice like those of the serial arms (see kernels.h).

/// A Delta's arms, one a lane; the fourth lane repeats the third.
struct DeltaArms {
  alignas(32) double cosine[4];
  alignas(32) double sine[4];  ///< Direction of each arm.
  double base, upper, lower, platform;
  double down;  ///< Sign of z where the platform is.
};

/// Six hinges on the base and on the platform, coordinate by coordinate; lanes 6 and 7 repeat hinge 5.
struct HexapodHinges {
  alignas(32) double base[3][8];
  alignas(32) double top[3][8];
};

struct LoopTable {
  const char* name;
  /// Both knees of each arm for the platform's middle; NaN out of reach. Bit k of the result: arm k reaches.
  unsigned (*deltaInverse)(const DeltaArms& arms, const double* p, double* outer, double* inner);
  /// Sines and cosines of three motor angles (read as four).
  void (*deltaAngles)(const double* theta, double* sine, double* cosine);
  /// Six lengths (eight are written) for a rotation, row by row, and a position.
  void (*legLengths)(const HexapodHinges& hinges, const double* R, const double* p, double* lengths);
  /// One Newton step towards `wanted` (eight numbers): the largest error (m) before it, the step (linear, angular) in
  /// `step`, the determinant of J in `determinant` (0: singular, no step).
  double (*hexapodStep)(const HexapodHinges& hinges, const double* R, const double* p, const double* wanted,
                        double* step, double* determinant);
};

const LoopTable& loopTable();
const LoopTable* plainLoopTable();
const LoopTable* avx2LoopTable();

}  // namespace hapticell::kinematics::kernels
