// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// Most constraints one set can carry; a set that would need more shrinks its zone instead (see zone_radius).
inline constexpr std::size_t kMaxConstraints = 64;

/// Least radius, in device space, that a set is asked to be complete in: what a hand reaches before the next set comes.
inline constexpr double kWantedZoneRadius = 0.060;

/// What the numbers of a set, and of the wire, may be at most: far beyond anything that a workcell or a hand has, and
/// so far within what double precision bears that no sum or product of a tick is ever infinite.
namespace bound {
inline constexpr double kLength = 1e6;      ///< m: gaps, places, zones, reaches.
inline constexpr double kLeastZone = 1e-6;  ///< m.
inline constexpr double kSlope = 1e9;       ///< Parts of a gradient.
inline constexpr double kCurvature = 1e12;  ///< 1/m in the linear block.
inline constexpr double kStiffness = 1e6;   ///< N/m.
inline constexpr double kDamping = 1e4;     ///< N s/m.
inline constexpr double kFriction = 1e4;    ///< Coulomb coefficient.
inline constexpr double kSpeed = 1e6;       ///< m/s.
inline constexpr double kForce = 1e6;       ///< N, N m, kg.
inline constexpr double kTime = 1e15;       ///< ms.
}  // namespace bound

/// Six numbers over xi = (dx, dy, dz, rx, ry, rz): the stylus's displacement in metres and its rotation vector in
/// radians, both in the device frame D, from the set's reference pose.
using Vector6 = std::array<double, 6>;

/// A symmetric 6x6 matrix: its upper triangle row by row, (0,0) (0,1) .. (0,5) (1,1) .. (5,5).
using SymmetricMatrix6 = std::array<double, 21>;

enum class ConstraintKind : std::uint8_t {
  kInequality,  ///< Free while f(xi) >= 0.
  kEquality,    ///< A guide: f(xi) = 0.
  kPull,        ///< Holds nothing back, but pulls the stylus towards f = 0 while |f| < reach: a detent, a help to stay
                ///< in a tube. The force is -stiffness f (1 - (f / reach)^2) along the gradient's direction.
};

/// One thing that can be felt: f(xi) = gap + gradient . xi + 1/2 xi' curvature xi.
///
/// A contact of two meshes, a joint limit, the edge of a workspace, a guide: all the same for the force loop.
/// Constraints of one group are OR (free when one of them holds, as at a convex edge); groups are AND.
struct Constraint {
  std::uint32_t group = 0;
  ConstraintKind kind = ConstraintKind::kInequality;
  double gap = 0.0;              ///< g, metres of clearance at the reference pose; negative inside.
  Vector6 gradient{};            ///< a; of unit length in its linear part where it is a contact at motion scale 1.
  SymmetricMatrix6 curvature{};  ///< B, 1/m in the linear block. Rounded to the safe side by whoever makes it.
  bool has_trim = false;  ///< A half-space g' + a'.xi that ends a curved face: the smaller of both values counts.
  double trim_gap = 0.0;
  Vector6 trim_gradient{};
  double stiffness = 0.0;  ///< N/m wanted; 0 means the device's own.
  double damping = 0.0;    ///< N s/m wanted; 0 means the device's own.
  double friction = 0.0;   ///< Coulomb coefficient.
  double reach = 0.0;      ///< kPull: m.
  /// How the obstacle moves, m/s, as a motion of the stylus that keeps step with it: f is taken at the translation
  /// less velocity times the set's age. Zero for what stands.
  dvec3 velocity_D{0.0};
  std::uint64_t id = 0;  ///< Stays the same from set to set for the same physical thing.
};

/// Everything the hand can feel within `zone_radius` of `X_DR`, complete. Made by the client, rendered by the server.
struct ConstraintSet {
  std::uint64_t sequence = 0;              ///< Counts up; an older one than the adopted is ignored for 2.5 s.
  std::int64_t stamp_ns = 0;               ///< Client's steady clock at the query; places moving obstacles, 0: unknown.
  Pose X_DR;                               ///< Reference pose (of the proxy) in the device frame.
  double zone_radius = kWantedZoneRadius;  ///< Metres; a rotation counts with the lever kRotationLever.
  std::size_t count = 0;
  std::array<Constraint, kMaxConstraints> constraints{};

  std::span<const Constraint> active() const { return {constraints.data(), count}; }
};

/// Lever that weighs rotation against translation in the proxy's metric, metres (feel trial: 0.05 good everywhere).
inline constexpr double kRotationLever = 0.05;

/// f(xi), without the trim.
double evaluate(const Constraint& constraint, const Vector6& xi);

/// Gradient of f at xi: gradient + curvature * xi.
Vector6 gradientAt(const Constraint& constraint, const Vector6& xi);

/// Both at once: returns f(xi) without the trim and fills its gradient.
double evaluateWithGradient(const Constraint& constraint, const Vector6& xi, Vector6& gradient);

/// True when every number is finite and within its bound, the pose valid, the radius positive and the count within
/// bounds.
bool isWellFormed(const ConstraintSet& set);

}  // namespace hapticell::haptic
