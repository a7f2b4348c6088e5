// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/direction_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace hapticell::collision {
namespace {

/// Places of the zone that must be covered by the chosen directions. Half: thin wedges between them may stay open;
/// twice: twice the time of choosing.
constexpr std::size_t kMostSamples = 3000;
/// m: touching counts as free, rounding included (kTouchingDistance). Half and twice are far above rounding.
constexpr double kTouch = 1e-9;

double halton(std::uint32_t index, std::uint32_t base) {
  double result = 0.0;
  double fraction = 1.0;
  for (; index > 0; index /= base) {
    fraction /= base;
    result += fraction * (index % base);
  }
  return result;
}

/// Fixed directions with lengths spread evenly over their logarithm, 1/1000 to 1: near places count as much as far
/// ones.
std::vector<dvec3> ballSamples(std::uint32_t count) {
  std::vector<dvec3> samples;
  for (std::uint32_t i = 1; i <= count; ++i) {
    const double z = 2.0 * halton(i, 2) - 1.0;
    const double angle = 2.0 * std::numbers::pi * halton(i, 3);
    const double width = std::sqrt(std::max(0.0, 1.0 - z * z));
    samples.push_back(std::pow(10.0, -3.0 * halton(i, 5)) * dvec3(width * std::cos(angle), width * std::sin(angle), z));
  }
  return samples;
}

void addFacetSamples(const SeparatingDirection& direction, double reach, bool many, std::vector<dvec3>& samples) {
  if (std::abs(direction.gap) >= reach) return;
  const dvec3& n = direction.nhat_W;
  const dvec3 base = (-direction.gap + 1e-7 + 1e-5 * reach) * n;
  samples.push_back(base);
  if (!many) return;
  const double room = std::sqrt(reach * reach - direction.gap * direction.gap);
  const dvec3 u = glm::normalize(glm::cross(n, std::abs(n.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  const dvec3 v = glm::cross(n, u);
  for (const double length : {0.03, 0.2, 0.7}) {
    for (const dvec3& side : {u + v, u - v, -u + v, -u - v}) samples.push_back(base + 0.7 * length * room * side);
  }
}

/// By length, equal ones in their order.
std::vector<dvec3> nearestFirst(const std::vector<dvec3>& samples) {
  std::vector<std::pair<double, std::uint32_t>> order;
  order.reserve(samples.size());
  for (std::uint32_t i = 0; i < samples.size(); ++i) order.emplace_back(glm::dot(samples[i], samples[i]), i);
  std::sort(order.begin(), order.end());
  std::vector<dvec3> sorted;
  sorted.reserve(samples.size());
  for (const auto& [length2, i] : order) sorted.push_back(samples[i]);
  return sorted;
}

std::vector<dvec3> samplesFor(const std::vector<PieceGroup>& groups, double reach) {
  static const std::vector<dvec3> kBall = ballSamples(400);
  std::vector<dvec3> samples;
  samples.reserve(kBall.size());
  for (const dvec3& s : kBall) samples.push_back(reach * s);
  std::size_t directions = 0;
  for (const PieceGroup& group : groups) directions += group.directions.size();
  const bool many = 13 * directions < kMostSamples;
  for (const PieceGroup& group : groups) {
    for (const SeparatingDirection& direction : group.directions) {
      if (samples.size() < kMostSamples) addFacetSamples(direction, reach, many, samples);
    }
  }
  return nearestFirst(samples);
}

/// The planes of a group side by side, largest gap first, so that a place is judged by few of them.
class GroupPlanes {
 public:
  explicit GroupPlanes(const PieceGroup& group) {
    for (const SeparatingDirection& direction : group.directions) planes_.emplace_back(direction.nhat_W, direction.gap);
    std::sort(planes_.begin(), planes_.end(), [](const glm::dvec4& a, const glm::dvec4& b) { return a.w > b.w; });
  }

  bool isFree(const dvec3& d, double length) {
    if (value(planes_[last_], d) >= -kTouch) return true;
    for (std::size_t i = 0; i < planes_.size() && planes_[i].w + length >= -kTouch; ++i) {
      if (value(planes_[i], d) < -kTouch) continue;
      last_ = i;
      return true;
    }
    return false;
  }

 private:
  static double value(const glm::dvec4& plane, const dvec3& d) { return plane.w + glm::dot(dvec3(plane), d); }

  std::vector<glm::dvec4> planes_;
  std::size_t last_ = 0;
};

/// Tells free places from blocked ones; asks the group that blocked last first.
class FreeSpace {
 public:
  explicit FreeSpace(const std::vector<PieceGroup>& groups) {
    for (const PieceGroup& group : groups) groups_.emplace_back(group);
  }

  bool isFree(const dvec3& d) {
    const double length = glm::length(d);
    if (!groups_[last_].isFree(d, length)) return false;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i].isFree(d, length)) continue;
      last_ = i;
      return false;
    }
    return true;
  }

 private:
  std::vector<GroupPlanes> groups_;
  std::size_t last_ = 0;
};

std::uint32_t bestAt(const PieceGroup& group, const dvec3& d, double tolerance) {
  std::uint32_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < group.directions.size(); ++i) {
    const SeparatingDirection& direction = group.directions[i];
    const double value = direction.gap + glm::dot(direction.nhat_W, d);
    // A face that frees the place is taken before anything of a lower rank, however much freer that would make it.
    const double ranked = value >= -tolerance ? 1e3 - 1e2 * static_cast<double>(direction.rank) + value : value;
    if (ranked > most) {
      most = ranked;
      best = i;
    }
  }
  return best;
}

bool isCovered(const PieceGroup& group, const dvec3& d, double tolerance) {
  return std::any_of(group.chosen.begin(), group.chosen.end(), [&](auto i) {
    return group.directions[i].gap + glm::dot(group.directions[i].nhat_W, d) >= -tolerance;
  });
}

}  // namespace

double separationAt(const PieceGroup& group, const dvec3& d_W) {
  double most = -std::numeric_limits<double>::infinity();
  for (const SeparatingDirection& direction : group.directions) {
    most = std::max(most, direction.gap + glm::dot(direction.nhat_W, d_W));
  }
  return most;
}

void chooseDirections(std::vector<PieceGroup>& groups, const DirectionLimits& limits) {
  if (groups.empty()) return;
  for (PieceGroup& group : groups) group.chosen = {bestAt(group, dvec3(0.0), 1e-6)};
  FreeSpace space(groups);
  for (const dvec3& d : samplesFor(groups, limits.reach)) {
    if (!space.isFree(d)) continue;
    const double tolerance = 1e-6 + 0.005 * glm::length(d);
    for (PieceGroup& group : groups) {
      if (isCovered(group, d, tolerance)) continue;
      // Rounding may leave a place uncovered whose best direction is chosen already.
      const std::uint32_t best = bestAt(group, d, kTouch);
      if (std::find(group.chosen.begin(), group.chosen.end(), best) == group.chosen.end()) group.chosen.push_back(best);
    }
  }
}

}  // namespace hapticell::collision
