// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/shapes/pose.h"
#include "kinematics/kernels/loop_kernels.h"

namespace hapticell::kinematics {

/// Positions of the hinges of the six legs of a Gough-Stewart platform, metres.
struct HexapodGeometry {
  std::array<dvec3, 6> p_BA{};  ///< On the base, in its frame B.
  std::array<dvec3, 6> p_PC{};  ///< On the platform, in its frame P.
};

/// The result of the Newton-Kantorovich theorem for a pose and six lengths. Distances in m; rotation (rad) is
/// multiplied by the platform's radius; both parts form one vector of length 6.
struct HexapodCertificate {
  bool holds = false;
  double exists_within = 0.0;  ///< An exact assembly lies within this distance,
  double unique_within = 0.0;  ///< and there is no other one within this distance.
};

using LegLengths = std::array<double, 6>;

struct HexapodForward {
  Pose X_BP;
  int iterations = 0;
  bool converged = false;  ///< All legs within 1e-12 m.
  int handedness = 0;      ///< Sign of det J; it changes across a singular surface.
};

/// The closed form of the legs and Newton's iteration of the pose. No allocation.
class HexapodKinematics {
 public:
  explicit HexapodKinematics(const HexapodGeometry& geometry);
  const HexapodGeometry& geometry() const { return geometry_; }

  LegLengths lengths(const dmat3& R_BP, const dvec3& p_BP) const;
  LegLengths lengths(const Pose& X_BP) const { return lengths(X_BP.R(), X_BP.p); }

  /// Newton's method from X_BStart: rows [u, R c x u], pivoted elimination, the rotation updated by the Cayley map. Up
  /// to 40 assemblies have the same six lengths (Raghavan 1993); the start determines which one is found.
  HexapodForward forward(const LegLengths& lengths, const Pose& X_BStart, int max_iterations = 30) const;

  /// Proves that there is an assembly with these lengths near the pose (Ortega 1968; the second derivatives are bounded
  /// by 2 / shortest leg + 1 / radius each). False near singular surfaces, or if the pose is too far away.
  HexapodCertificate certify(const LegLengths& lengths, const Pose& X_BP) const;

  /// det J of the rows [u, R c x u / radius], about in [-1, 1]: 0 where the legs no longer hold the platform.
  double regularity(const Pose& X_BP) const;

  double radius() const { return radius_; }  ///< Of the platform's joints, m.

 private:
  HexapodGeometry geometry_;
  double radius_ = 1.0;
  kernels::HexapodHinges hinges_{};
  const kernels::LoopTable* kernels_ = &kernels::loopTable();
};

}  // namespace hapticell::kinematics
