// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/proxy_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

namespace {

// Of these three half and twice pass the tests of this folder: they bound what a client may ask for.
constexpr double kStiffestPull = 500.0, kStrongestPull = 3.0;  // N/m, N.
constexpr double kFastest = 10.0;                              // m/s of an obstacle, along each axis.
/// m: more than what a solved row is off, less than anything is thick. Half fails
/// ProxyMover.SlidesOverAFlushSeamAndStopsAtAStep, twice passes.
constexpr double kOn = 1e-6;
/// A group whose every gradient vanishes has no direction to be felt in: a row that never bites.
constexpr SolverRow kNeverBites{{}, 1.0, false};

}  // namespace

void GroupedSet::prepare(const ConstraintSet& wanted) {
  well_formed = isWellFormed(wanted);
  if (well_formed) take(wanted);
}

void GroupedSet::take(const ConstraintSet& wanted) {
  sequence = wanted.sequence;
  stamp_ns = wanted.stamp_ns;
  X_DR = wanted.X_DR;
  zone_radius = wanted.zone_radius;
  count = wanted.count;
  well_formed = true;
  arrays.take(wanted);
  // Faster than anything in a workcell is an error; it must not carry a row away to infinity.
  for (auto& along : arrays.velocity) {
    for (std::size_t i = 0; i < arrays.count; ++i) along[i] = std::clamp(along[i], -kFastest, kFastest);
  }
  groups = 0;
  std::array<std::uint32_t, kMaxConstraints> group{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = group.begin(), end = begin + static_cast<std::ptrdiff_t>(groups);
    const auto found = std::find(begin, end, wanted.constraints[i].group);
    row_of[i] = static_cast<std::uint8_t>(found - begin);
    if (found == end) group[groups++] = wanted.constraints[i].group;
  }
  each_alone = groups == count && arrays.pulls == 0;
}

dvec3 GroupedSet::pullAt(const Pose& X_DS) const {
  dvec3 pull(0.0);
  if (arrays.pulls == 0) return pull;
  const Twist motion = difference(X_DS, X_DR);
  const Vector6 xi = joined(motion.linear, motion.angular);
  for (std::uint64_t left = arrays.pulls; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const double reach = arrays.reach[i];
    if (reach <= 0.0) continue;
    Vector6 gradient{};
    const double value = evaluateWithGradient(arrays.surfaceOf(i), seenFrom(i, xi), gradient);
    const dvec3 along = linearPart(gradient);
    const double length = glm::length(along);
    if (!(std::abs(value) < reach) || length < 1e-9) continue;
    const double part = value / reach;
    pull -= std::min(arrays.stiffness[i], kStiffestPull) * value * (1.0 - part * part) / length * along;
  }
  const double size = glm::length(pull);
  return size > kStrongestPull ? pull * (kStrongestPull / size) : pull;
}

Vector6 GroupedSet::seenFrom(std::size_t entry, const Vector6& xi) const {
  const dvec3 gone = age * arrays.velocityOf(entry);
  return {xi[0] - gone.x, xi[1] - gone.y, xi[2] - gone.z, xi[3], xi[4], xi[5]};
}

void ProxyRows::gather(const GroupedSet& grouped, const Pose& X_DP) {
  const Twist motion = difference(X_DP, grouped.X_DR);
  const Vector6 xi = joined(motion.linear, motion.angular);
  from_reference = joined(motion.linear, kRotationLever * motion.angular);
  row.count = grouped.groups;
  touched_count_ = tied_count_ = 0;
  if (grouped.each_alone)
    gatherEach(grouped, xi);
  else
    gatherFreest(grouped, xi);
  addTrustRow(grouped.zone_radius);
  row.fillLastVector();
}

void ProxyRows::gatherEach(const GroupedSet& grouped, const Vector6& xi) {
  makeRows(grouped.arrays, xi, grouped.age, row);
  for (std::size_t i = 0; i < row.count; ++i) {
    entry[i] = static_cast<std::uint8_t>(i);
    row.both_ways[i] = EntryArrays::has(grouped.arrays.equalities, i) ? 1.0 : 0.0;
    if (row.length[i] < kLeastSlope) row.put(i, kNeverBites);
  }
}

void ProxyRows::gatherFreest(const GroupedSet& grouped, const Vector6& xi) {
  makeRows(grouped.arrays, xi, grouped.age, made_);
  std::array<double, kMaxConstraints> freest;
  std::fill_n(freest.begin(), row.count, -1e9);
  for (std::size_t i = 0; i < grouped.count; ++i) {
    if (EntryArrays::has(grouped.arrays.pulls, i) || made_.length[i] < kLeastSlope) continue;
    noteTouched(grouped, i);
    const std::uint8_t slot = grouped.row_of[i];
    if (!(made_.slack[i] > freest[slot])) continue;
    freest[slot] = made_.slack[i];
    entry[slot] = static_cast<std::uint8_t>(i);
  }
  for (std::size_t i = 0; i < row.count; ++i) {
    made_.both_ways[entry[i]] = EntryArrays::has(grouped.arrays.equalities, entry[i]) ? 1.0 : 0.0;
    row.put(i, freest[i] < -1e8 ? kNeverBites : made_.at(entry[i]));
  }
  countTied();
}

void ProxyRows::noteTouched(const GroupedSet& grouped, std::size_t index) {
  if (std::abs(made_.slack[index]) > kOn) return;
  if (EntryArrays::has(grouped.arrays.trims | grouped.arrays.equalities, index)) return;
  touched_[touched_count_++] = {grouped.row_of[index], static_cast<std::uint8_t>(index)};
}

void ProxyRows::countTied() {
  tied_count_ = 0;
  is_tied_.fill(false);
  for (std::size_t k = 0; k < touched_count_; ++k) {
    const std::size_t i = touched_[k].slot;
    if (is_tied_[i] || entry[i] == touched_[k].entry) continue;
    is_tied_[i] = true;
    ++tied_count_;
  }
}

void ProxyRows::settle(const Vector6& wanted) {
  RowArrays others;
  for (std::size_t i = 0; i < row.count; ++i) {
    if (i + 1 == row.count || !is_tied_[i]) others.add(row.at(i));
  }
  others.fillLastVector();
  const SolverResult result = nearestUnentered(others, wanted);
  const auto* const end = result.multiplier.begin() + static_cast<std::ptrdiff_t>(others.count) - 1;
  if (std::all_of(result.multiplier.begin(), end, [](double multiplier) { return multiplier == 0.0; })) return;
  const auto leftBy = [&](const SolverRow& of) {
    double left = of.slack;
    for (std::size_t i = 0; i < 6; ++i) left += of.normal[i] * result.d[i];
    return left;
  };
  for (std::size_t k = 0; k < touched_count_; ++k) {
    const Touched& touched = touched_[k];
    if (!is_tied_[touched.slot]) continue;
    const SolverRow other{made_.normalOf(touched.entry), made_.slack[touched.entry], false};
    if (leftBy(other) <= leftBy(row.at(touched.slot))) continue;
    row.put(touched.slot, other);
    entry[touched.slot] = touched.entry;
  }
}

void ProxyRows::addTrustRow(double zone_radius) {
  const double distance = lengthOf(from_reference);
  SolverRow trust{{1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, kTrustedShare * zone_radius - distance, false};
  for (std::size_t i = 0; distance >= 1e-9 && i < 6; ++i) trust.normal[i] = -from_reference[i] / distance;
  row.add(trust);
}

}  // namespace hapticell::haptic
