// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// Largest number of constraints in one set: a tick with so many must take 50 us at most (M11 of `hapticell-cli feel`);
/// a set of more shrinks its zone. Half: smaller zones among many parts; twice: ticks of twice the time.
inline constexpr std::size_t kMaxConstraints = 64;

/// Least radius (m), in device space, in which a set should be complete: a hand at 0.6 m/s until the next of 10 sets a
/// second. Half: fast hands meet the edge at 10 Hz; twice: more to find for each set.
inline constexpr double kWantedZoneRadius = 0.060;

/// Upper bounds of the numbers in a set and on the wire. They are far above the values of any workcell or hand, and
/// small enough that no sum or product in a tick becomes infinite in double precision.
namespace bound {
inline constexpr double kLength = 1e6;      ///< m: gaps, positions, zones, reaches.
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
  kPull,        ///< Does not stop the stylus, but pulls it towards f = 0 while |f| < reach: a detent, or guidance
                ///< inside a tube. The force is -stiffness f (1 - (f / reach)^2) along the gradient's direction.
};

/// One thing that can be felt: f(xi) = gap + gradient . xi + 1/2 xi' curvature xi.
///
/// A contact of two meshes, a joint limit, the edge of a workspace, a guide: the force loop treats them all alike.
/// Constraints of one group are OR (free when one of them holds, as at a convex edge); groups are AND.
struct Constraint {
  std::uint32_t group = 0;
  ConstraintKind kind = ConstraintKind::kInequality;
  double gap = 0.0;              ///< g, metres of clearance at the reference pose; negative inside.
  Vector6 gradient{};            ///< a; its linear part has unit length for a contact at motion scale 1.
  SymmetricMatrix6 curvature{};  ///< B, 1/m in the linear block. Its maker rounds it to the safe side.
  bool has_trim = false;  ///< A half-space g' + a'.xi that ends a curved face: the smaller of both values counts.
  double trim_gap = 0.0;
  Vector6 trim_gradient{};
  double stiffness = 0.0;  ///< N/m wanted; 0 means the device's own.
  double damping = 0.0;    ///< N s/m wanted; 0 means the device's own.
  double friction = 0.0;   ///< Coulomb coefficient.
  double reach = 0.0;      ///< kPull: m.
  /// Velocity of the obstacle, m/s, as a motion of the stylus that moves with it: f is evaluated at the translation
  /// minus velocity times the set's age. Zero for fixed obstacles.
  dvec3 velocity_D{0.0};
  std::uint64_t id = 0;  ///< The same physical contact or guide keeps its id from set to set.
};

/// The complete list of what the hand can feel within `zone_radius` of `X_DR`. Made by the client, rendered by the
/// server.
struct ConstraintSet {
  std::uint64_t sequence = 0;              ///< Increases; for 2.5 s a set older than the adopted one is ignored.
  std::int64_t stamp_ns = 0;               ///< Client's steady clock when the query was made; for statistics only.
  Pose X_DR;                               ///< Reference pose (of the proxy) in the device frame.
  double zone_radius = kWantedZoneRadius;  ///< Metres; a rotation is weighted with the lever kRotationLever.
  std::size_t count = 0;
  std::array<Constraint, kMaxConstraints> constraints{};

  std::span<const Constraint> active() const { return {constraints.data(), count}; }
};

/// Lever that weights rotation against translation in the proxy's metric, metres (0.05 was good in all feel trials).
/// Half: a quarter of the torque at each angle; twice: four times (docs/dev/feel.md, Torque).
inline constexpr double kRotationLever = 0.05;

/// f(xi), without the trim.
double evaluate(const Constraint& constraint, const Vector6& xi);

/// Gradient of f at xi: gradient + curvature * xi.
Vector6 gradientAt(const Constraint& constraint, const Vector6& xi);

/// Returns f(xi) without the trim and fills its gradient.
double evaluateWithGradient(const Constraint& constraint, const Vector6& xi, Vector6& gradient);

/// True when every number is finite and within its bound, the pose valid, the radius positive and the count within
/// bounds.
bool isWellFormed(const ConstraintSet& set);

}  // namespace hapticell::haptic
