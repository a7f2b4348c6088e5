// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "collision/surfaces/signature.h"
#include "collision/surfaces/signature_groups.h"

namespace hapticell::collision {

/// A point of the (offset) surface, and which of the signatures it has.
struct SignedSample {
  dvec3 p_M, nhat_M;
  std::uint32_t signature;
};

/// What a cell's groups were made of.
struct RepairTask {
  const SurfaceModel& model;  ///< Closed.
  double radius;              ///< Of the ball, m.
  std::span<const SignedSample> samples;
  std::span<const Signature> signatures;
  std::span<const Signature> groups;  ///< In the order of the cell's.
};

/// Takes false walls out of a cell's groups: surfaces go on beyond their regions, so places in the air can lie behind
/// all elements of a group. Where a point 0.1 mm off a sample is free but blocked by a group, the tangent plane there
/// becomes an alternative of the group, ended by up to two planes that leave all samples blocked. Returns the work in
/// element values. Any thread.
std::size_t repairGroups(const RepairTask& task, SignatureCell& cell);

}  // namespace hapticell::collision
