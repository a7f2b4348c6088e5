// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/entry_rows.h"

#include <algorithm>

#include "haptic/rendering/entry_rows_body.h"

namespace hapticell::haptic {

#ifdef HAPTICELL_X86_KERNELS
void rowsByAvx2(const EntryArrays& entries, const double* xi, double age, EntryRows& rows);
#endif

namespace {

using MakeRows = void (*)(const EntryArrays&, const double*, double, EntryRows&);

MakeRows widest() {
#ifdef HAPTICELL_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) return rowsByAvx2;
#endif
  return rowsOfAll;
}

const MakeRows make_rows = widest();

}  // namespace

void EntryArrays::take(const ConstraintSet& set) {
  count = std::min(kMaxConstraints, (set.count + kLanes - 1) / kLanes * kLanes);
  constexpr Constraint kNone{};
  pulls = equalities = trims = 0;
  any_trim = false;
  for (std::size_t i = 0; i < count; ++i) {
    const Constraint& c = i < set.count ? set.constraints[i] : kNone;
    gap[i] = c.gap;
    for (std::size_t k = 0; k < 6; ++k) gradient[k][i] = c.gradient[k];
    for (std::size_t k = 0; k < 21; ++k) curvature[k][i] = c.curvature[k];
    velocity[0][i] = c.velocity_D.x;
    velocity[1][i] = c.velocity_D.y;
    velocity[2][i] = c.velocity_D.z;
    stiffness[i] = c.stiffness;
    damping[i] = c.damping;
    friction[i] = c.friction;
    reach[i] = c.reach;
    const bool is_equality = c.kind == ConstraintKind::kEquality, is_trimmed = c.has_trim && !is_equality;
    pulls |= std::uint64_t{c.kind == ConstraintKind::kPull} << i;
    equalities |= std::uint64_t{is_equality} << i;
    trims |= std::uint64_t{c.has_trim} << i;
    any_trim |= is_trimmed;
  }
  for (std::size_t i = 0; any_trim && i < count; ++i) {
    const Constraint& c = i < set.count ? set.constraints[i] : kNone;
    const bool is_trimmed = has(trims & ~equalities, i);
    trim_gap[i] = is_trimmed ? c.trim_gap : 0.0;
    for (std::size_t k = 0; k < 6; ++k) trim_gradient[k][i] = is_trimmed ? c.trim_gradient[k] : 0.0;
  }
}

Constraint EntryArrays::surfaceOf(std::size_t i) const {
  Constraint surface;
  surface.gap = gap[i];
  for (std::size_t k = 0; k < 6; ++k) surface.gradient[k] = gradient[k][i];
  for (std::size_t k = 0; k < 21; ++k) surface.curvature[k] = curvature[k][i];
  return surface;
}

void makeRows(const EntryArrays& entries, const Vector6& xi, double age, EntryRows& rows) noexcept {
  make_rows(entries, xi.data(), age, rows);
}

void makeRowsPortably(const EntryArrays& entries, const Vector6& xi, double age, EntryRows& rows) noexcept {
  rowsOfAll(entries, xi.data(), age, rows);
}

}  // namespace hapticell::haptic
