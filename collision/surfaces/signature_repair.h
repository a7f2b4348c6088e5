// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "collision/surfaces/signature.h"
#include "collision/surfaces/signature_groups.h"

namespace hapticell::collision {

/// A point of the (offset) surface, and the index of its signature.
struct SignedSample {
  dvec3 p_M, nhat_M;
  std::uint32_t signature;
};

/// The data that a cell's groups were made from.
struct RepairTask {
  const SurfaceModel& model;  ///< Closed.
  double radius;              ///< Of the ball, m.
  std::span<const SignedSample> samples;
  std::span<const Signature> signatures;
  std::span<const Signature> groups;  ///< In the order of the cell's groups.
};

/// Removes false walls from a cell's groups: surfaces extend beyond their regions, so free places can lie behind all
/// elements of a group. If a point 0.1 mm off a sample is free but a group blocks it, the tangent plane there becomes
/// an alternative of the group, limited by up to two planes that keep all samples blocked. Returns the work in element
/// values. Any thread.
std::size_t repairGroups(const RepairTask& task, SignatureCell& cell);

}  // namespace hapticell::collision
