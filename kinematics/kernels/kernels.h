// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::kinematics::kernels {

// Closed forms in the canonical frames of arms, four branches at a time. Plain data only: the functions are compiled
// twice (AVX2 with FMA, and the portable build) and chosen at run time.

/// Solutions of one pose: 16 is the most that a general arm of six rotary joints has (Primrose 1986). Four a lane
/// group.
inline constexpr int kMaxSolutions = 16;
/// The greatest number of joints of an arm in the kernels: two groups of four lanes. A longer chain uses the numeric
/// code without lanes.
inline constexpr int kMaxJoints = 8;

/// Pose of the last joint's frame in the arm's canonical base frame; R row by row.
struct ArmPose {
  double R[9];
  double p[3];
};

/// Converts the pose of a tip to an ArmPose: columns of R_0B (each with a fourth number, zero), rows of R_TN, and the
/// origins of 0 in B and of N in T.
struct ArmFrames {
  double R_0B[3][4] = {};
  double R_TN[9] = {};
  double p_B0[3] = {}, p_TN[3] = {};
};

/// Joint positions, joint by joint; bit k of `valid` is set if solution k is valid.
struct alignas(32) Solutions {
  double q[kMaxJoints][kMaxSolutions];
  unsigned valid = 0;
};

/// Every canonical angle is theta = sign * q + offset.
struct JointMap {
  double sign[kMaxJoints] = {1, 1, 1, 1, 1, 1, 1, 1};
  double offset[kMaxJoints] = {};
};

/// R06 = Rz(1) Ry(2 + 3) Rz(4) Ry(5) Rz(6); the frame of joint 6 has its origin in the wrist centre.
///
/// Axis 2 passes a1 in front of axis 1 at height 0; upper arm c2 along z at theta_2 = 0; the wrist centre lies at (a2,
/// b, c3) from the elbow. As Brandstoetter, Angerer, Hofbaur 2014, with c1 and c4 in the frames.
struct OpwArm {
  double a1, b, c2, k, psi;  ///< k = hypot(a2, c3), psi = atan2(a2, c3).
  double sin_psi, cos_psi;
  JointMap map;
};

/// R06 = Rz(1) Ry(2 + 3 + 4) Rz(5) Rx(-90 deg) Rz(6); the frame of joint 6 has its origin where axes 5 and 6 meet.
struct UrArm {
  double a1, c2, c3, d4, d5;
  JointMap map;
};

/// R07 = Rz(1) Ry(2) Rz(3) Ry(4) Rz(5) Ry(6) Rz(7), shoulder at the origin; axis 4 at d3 along z and a4 along x of
/// frame 3, the wrist at (a5, 0, d5) from it in frame 4, axis 7 at a7 along x of frame 6. For the S-R-S arm a4 = a5 =
/// a7 = 0.
struct SevenArm {
  double d3, a4, a5, d5, a7;
  JointMap map;
};

/// Number of swivel angles tried for a seven-joint arm, 5.6 degrees apart. Half: narrow gaps between limits are missed
/// and left to the numeric search; twice: twice the time of solve().
inline constexpr int kRingSize = 64;

/// An S-R-S arm's principal solution (see Table::srsRing) for swivels all round, canonical angles.
struct alignas(32) SwivelRing {
  double theta[7][kRingSize];
  bool reached = false;
};

/// A vector that turns with an angle t: middle + cos t * cosine + sin t * sine.
struct Circle {
  double middle[3], cosine[3], sine[3];
};

/// An arm of which joints 1 to 4 are an OpwArm's and axis 6 passes the point W where axes 4 and 5 meet; all vectors in
/// the canonical base frame, turning with joint 6 as the wanted pose has it.
struct OffsetArm {
  OpwArm arm;  ///< Offsets of joints 5 and 6 are zero.
  Circle wrist;
  Circle across_5, axis_5, along_5;  ///< x, y (the axis) and z of the frame of link 5; z is axis 4 at q_5 = 0.
};

/// An arm with its true (not idealised) axes. Before joint i a constant step R[i], p[i] (row by row); each joint turns
/// about, or slides along, z of the frame after it.
struct TrueArm {
  int joints = 0;
  bool slides[kMaxJoints] = {};
  double R[kMaxJoints][9], p[kMaxJoints][3];
  double R_tip[9], p_tip[3];
  double scale = 1.0;  ///< 1 / m: weight of a metre relative to a radian in a step.
};

/// One descent of Table::fit; see fitPose().
struct FitTask {
  double R[9], p[3];  ///< The wanted pose, R row by row.
  double lower[kMaxJoints], upper[kMaxJoints], start[kMaxJoints];
  double lever = 0.25;
  int max_iterations = 40;
  bool second_order = true;
  bool give_up_when_slow = false;
};
struct FitAnswer {
  double x[kMaxJoints];
  double position_error = 0.0;
  double orientation_error = 0.0;
  bool held = false;  ///< A bound was active at the end.
  int iterations = 0;
};

/// Poses of the tip to begin descents at: x, y, z, qw, qx, qy, qz, each `count` numbers; a multiple of 16.
struct SeedPoses {
  int count = 0;
  const float* values[7] = {};
};
/// Groups of seeds, of which each gives its nearest; 16 floats are two registers of AVX2. Half: fewer different starts;
/// twice: up to twice the time of a search that fails.
inline constexpr int kSeedGroups = 16;

/// Conditions for an allowed and near solution; see Table::choose.
struct JointBounds {
  double lower[kMaxJoints];
  double upper[kMaxJoints];
  double turn[kMaxJoints];  ///< 2 pi if a full turn changes nothing, otherwise 0.
  int joints = 6;
};

struct Choice {
  unsigned within = 0;  ///< Bit k: solution k is valid and within the bounds.
  int nearest = -1;     ///< The one of these nearest to the previous joints; -1 if no solution is allowed.
  double distance_squared = 0.0;
};

/// Joint axes and origins of four arms, one per lane; axes are unit.
struct FourAxes {
  double axis[kMaxJoints][3][4], origin[kMaxJoints][3][4];
};

/// The functions of one build. `previous` are the previous joints, q as in Solutions: a joint that the pose does not
/// determine (joint 4 at theta_5 = 0, joint 1 with the wrist centre on axis 1, joint 6 of a UR at theta_5 = 0, and the
/// like) keeps its value. None allocates or throws.
struct Table {
  const char* name;
  /// The tip at R_BT (column by column), p_BT in the arm's canonical frames.
  void (*map)(const ArmFrames& frames, const double* R_BT, const double* p_BT, ArmPose& pose);
  /// Eight solutions: lane 0 front, 1 back with one elbow, 2 and 3 with the other; 4 to 7 the same with the wrist
  /// flipped.
  void (*opw)(const OpwArm& arm, const ArmPose& pose, const double* previous, Solutions& solutions);
  /// The largest of the position's (m) and the rotation matrices' differences over all valid solutions.
  double (*opwError)(const OpwArm& arm, const ArmPose& pose, const Solutions& solutions);
  void (*ur)(const UrArm& arm, const ArmPose& pose, const double* previous, Solutions& solutions);
  /// Eight solutions for the swivel angle of the elbow about the line from shoulder to wrist (rad; zero: the elbow is
  /// in the plane of that line and z).
  void (*srs)(const SevenArm& arm, const ArmPose& pose, double swivel, const double* previous, Solutions& solutions);
  /// For kRingSize swivels from `first_swivel` on, all round, the one solution from which the other seven come by half
  /// turns.
  void (*srsRing)(const SevenArm& arm, const ArmPose& pose, double first_swivel, const double* previous,
                  SwivelRing& ring);
  /// All eight solutions of a ring's entry.
  void (*srsOfRing)(const SevenArm& arm, const SwivelRing& ring, int index, Solutions& solutions);
  /// Eight solutions for q_7 given.
  void (*panda)(const SevenArm& arm, const ArmPose& pose, double q_7, const double* previous, Solutions& solutions);
  /// Up to sixteen solutions of an arm with an offset wrist, found by a search over joint 6.
  void (*offsetWrist)(const OffsetArm& arm, Solutions& solutions);
  /// The errors of the four solutions of a group from the pose R (row by row), p on the true arm: `errors` receives the
  /// larger of the distance (m) and the sine of the angle between, 1 beyond 60 deg. Valid solutions with an error are
  /// improved by at most the given number of Newton steps.
  void (*polish)(const TrueArm& arm, const double* R, const double* p, int group, int iterations, Solutions& solutions,
                 double* errors);
  /// The axes of the true arm with the joints of four solutions, a group's.
  void (*axes)(const TrueArm& arm, const Solutions& solutions, int group, FourAxes& axes);
  /// A bounded least-squares descent for an arm of seven joints at most.
  void (*fit)(const TrueArm& arm, const FitTask& task, FitAnswer& answer);
  /// For each of sixteen interleaved groups of seeds, the one nearest to the requested pose (by position times scale,
  /// 1/m, and angle), nearest first.
  void (*nearestSeeds)(const SeedPoses& seeds, const float* wanted, float scale, int* order);
  /// Turns each joint of each solution to the full turn nearest to `previous` within the bounds (a solution outside
  /// stays at the nearest turn), and finds the nearest solution. `groups`: number of groups of four solutions.
  Choice (*choose)(const JointBounds& bounds, const double* previous, int groups, Solutions& solutions);
};

/// The functions for this processor: AVX2 with FMA if it has them.
const Table& table();

/// Selects the portable build for all callers (true), or the best one again: for tests and measurements.
void usePlain(bool plain);

/// One build, for tests and measurements; null if the processor cannot run it.
const Table* plainTable();
const Table* avx2Table();

}  // namespace hapticell::kinematics::kernels
