// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/group_reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hapticell::collision {
namespace {

/// m, and share of a gap: groups nearer to each other than that count as equally near, so that a small motion keeps the
/// choice. Half: it changes twice as often, each a small step; twice: a nearer one may come later.
constexpr double kEqualGap = 1e-5;
constexpr double kEqualShare = 0.1;
/// Groups pointing farther apart than 60 deg are not tried as a pair: hardly any pair of them implies a third. Half (75
/// deg): more tries for the same; twice (0 deg): only parallel ones, so sets are larger.
constexpr double kLeastCosine = 0.5;

/// gap + linear . dx + angular . turn >= 0, both parts weighed with what the zone allows.
struct Row {
  dvec3 linear{0.0};
  dvec3 angular{0.0};
  double gap = 0.0;
};

double dot(const Row& a, const Row& b) {
  return glm::dot(a.linear, b.linear) + glm::dot(a.angular, b.angular);
}

class GroupReducer {
 public:
  GroupReducer(std::vector<PieceGroup>& groups, const DirectionLimits& limits, const dvec3& p_WC,
               const ReductionTolerance& tolerance);
  void run();

 private:
  using Rows = std::vector<std::vector<Row>>;  // by chosen direction, by support

  std::vector<std::uint32_t> order() const;
  /// How much x and y must be tightened so that together they imply every support of z; nothing if above the tolerance.
  std::optional<double> cost(const std::vector<Row>& x, const std::vector<Row>& y, const std::vector<Row>& z) const;
  std::optional<double> cost(const Row& x, const Row& y, const Row& z) const;
  /// The same for groups: every choice of one direction of j and one of k implies one of i.
  bool imply(std::uint32_t j, std::uint32_t k, std::uint32_t i);
  bool isImplied(std::uint32_t i, const std::vector<std::uint32_t>& kept);
  double cosine(std::uint32_t i, std::uint32_t j) const { return glm::dot(base_[i], base_[j]); }

  std::vector<PieceGroup>& groups_;
  ReductionTolerance tolerance_;
  double allowed_ = 0.0;  // metres, for the group being looked at
  std::vector<Rows> rows_;
  std::vector<dvec3> base_;  // normal of the best direction
};

GroupReducer::GroupReducer(std::vector<PieceGroup>& groups, const DirectionLimits& limits, const dvec3& p_WC,
                           const ReductionTolerance& tolerance)
    : groups_(groups), tolerance_(tolerance) {
  for (const PieceGroup& group : groups) {
    Rows rows;
    for (const auto chosen : group.chosen) {
      const SeparatingDirection& direction = group.directions[chosen];
      std::vector<Row> of_direction;
      for (const SupportPoint& support : direction.supports) {
        of_direction.push_back(
            {limits.reach * direction.nhat_W,
             tolerance.turning * limits.max_rotation * glm::cross(support.p_W - p_WC, direction.nhat_W), support.gap});
      }
      rows.push_back(std::move(of_direction));
    }
    rows_.push_back(std::move(rows));
    base_.push_back(group.directions[group.chosen.front()].nhat_W);
  }
}

std::vector<std::uint32_t> GroupReducer::order() const {
  // Nearest first, then always the one whose direction is farthest from those before. Gaps that are nearly equal do not
  // decide, so that a small motion keeps the choice.
  const auto gap = [&](std::uint32_t i) { return groups_[i].directions[groups_[i].chosen.front()].gap; };
  const auto isNearer = [&](std::uint32_t a, std::uint32_t b) {
    return gap(a) < gap(b) - kEqualGap - kEqualShare * std::abs(gap(b));
  };
  std::vector<std::uint32_t> left(groups_.size());
  for (std::uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<double> closeness(groups_.size(), -2.0);
  std::vector<std::uint32_t> result;
  while (!left.empty()) {
    auto next = left.begin();
    for (auto i = left.begin(); i != left.end(); ++i) {
      const double less = closeness[*next] - closeness[*i];
      if (less > 1e-6 || (less > -1e-6 && isNearer(*i, *next))) next = i;
    }
    const auto chosen = *next;
    result.push_back(chosen);
    left.erase(next);
    for (const auto i : left) closeness[i] = std::max(closeness[i], cosine(i, chosen));
  }
  return result;
}

std::optional<double> GroupReducer::cost(const Row& x, const Row& y, const Row& z) const {
  const double xx = dot(x, x), yy = dot(y, y), xy = dot(x, y), xz = dot(x, z), yz = dot(y, z);
  const double determinant = xx * yy - xy * xy;
  double s = 0.0;
  double t = 0.0;
  if (determinant > 1e-9 * xx * yy) {
    s = (yy * xz - xy * yz) / determinant;
    t = (xx * yz - xy * xz) / determinant;
  }
  if (s <= 0.0 || t <= 0.0) {
    const bool first = xz * xz * yy >= yz * yz * xx;
    s = first ? std::max(0.0, xz / xx) : 0.0;
    t = first ? 0.0 : std::max(0.0, yz / yy);
  }
  if (s + t < 0.5) return std::nullopt;
  const double rest =
      glm::length(z.linear - s * x.linear - t * y.linear) + glm::length(z.angular - s * x.angular - t * y.angular);
  const double excess = (s * x.gap + t * y.gap - z.gap + rest) / (s + t);
  if (excess > allowed_) return std::nullopt;
  return std::max(0.0, excess);
}

std::optional<double> GroupReducer::cost(const std::vector<Row>& x, const std::vector<Row>& y,
                                         const std::vector<Row>& z) const {
  double most = 0.0;
  for (const Row& row : z) {
    double least = std::numeric_limits<double>::infinity();
    for (const Row& a : x) {
      for (const Row& b : y) {
        if (const auto value = cost(a, b, row)) least = std::min(least, *value);
        if (least == 0.0) break;
      }
      if (least == 0.0) break;
    }
    if (least > allowed_) return std::nullopt;
    most = std::max(most, least);
  }
  return most;
}

bool GroupReducer::imply(std::uint32_t j, std::uint32_t k, std::uint32_t i) {
  std::vector<double> tighten_j(rows_[j].size(), 0.0);
  std::vector<double> tighten_k(rows_[k].size(), 0.0);
  for (std::size_t a = 0; a < rows_[j].size(); ++a) {
    for (std::size_t b = 0; b < rows_[k].size(); ++b) {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& z : rows_[i]) {
        if (const auto value = cost(rows_[j][a], rows_[k][b], z)) least = std::min(least, *value);
      }
      if (least > allowed_) return false;
      tighten_j[a] = std::max(tighten_j[a], least);
      tighten_k[b] = std::max(tighten_k[b], least);
    }
  }
  const auto bears = [&](const PieceGroup& group, const std::vector<double>& by) {
    for (std::size_t a = 0; a < by.size(); ++a) {
      const double room = std::max(0.0, group.directions[group.chosen[a]].gap - tolerance_.boundary);
      if (by[a] > tolerance_.absolute + tolerance_.relative * room) return false;
    }
    return true;
  };
  if (!bears(groups_[j], tighten_j) || !bears(groups_[k], tighten_k)) return false;
  const auto apply = [](PieceGroup& group, const std::vector<double>& by) {
    for (std::size_t a = 0; a < by.size(); ++a) {
      double& tightened = group.directions[group.chosen[a]].tightened;
      tightened = std::max(tightened, by[a]);
    }
  };
  apply(groups_[j], tighten_j);
  apply(groups_[k], tighten_k);
  return true;
}

bool GroupReducer::isImplied(std::uint32_t i, const std::vector<std::uint32_t>& kept) {
  const double gap = groups_[i].directions[groups_[i].chosen.front()].gap;
  allowed_ = tolerance_.absolute + tolerance_.relative * std::max(0.0, gap);
  std::vector<std::uint32_t> near;
  for (const auto j : kept) {
    if (cosine(i, j) >= kLeastCosine) near.push_back(j);
  }
  std::sort(near.begin(), near.end(), [&](auto a, auto b) { return cosine(i, a) > cosine(i, b); });
  if (near.size() > 12) near.resize(12);
  for (std::size_t a = 0; a < near.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      if (imply(near[a], near[b], i)) return true;
    }
  }
  return false;
}

void GroupReducer::run() {
  std::vector<std::uint32_t> kept;
  for (const auto i : order()) {
    if (!isImplied(i, kept)) kept.push_back(i);
  }
  std::sort(kept.begin(), kept.end());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] != i) groups_[i] = std::move(groups_[kept[i]]);
  }
  groups_.resize(kept.size());
}

}  // namespace

void reduceGroups(std::vector<PieceGroup>& groups, const DirectionLimits& limits, const dvec3& p_WC,
                  const ReductionTolerance& tolerance) {
  if (groups.size() > 1) GroupReducer(groups, limits, p_WC, tolerance).run();
}

}  // namespace hapticell::collision
