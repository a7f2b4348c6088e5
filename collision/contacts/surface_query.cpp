// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/surface_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "collision/contacts/crossing_rods.h"
#include "collision/contacts/placed_part.h"

namespace hapticell::collision {

namespace {

/// Points of each sharp circle (Contacts); between them the nearest to each surface is added. Half: a tilting disc
/// finds its next point late; twice: twice the groups of each circle.
constexpr int kCirclePoints = 8;
/// m that a circle may stand out between its points, the skin of a held part (kSkin). Half: more groups for what is not
/// felt; twice: it may be entered by 0.04 mm.
constexpr double kRoundEnough = 2e-5;
/// Groups before they are thinned out, some us each; with more the zone shrinks. Half: it shrinks sooner in crowds;
/// twice: thinning out takes twice as long or more.
constexpr std::size_t kMostGroups = 3000;
/// Pairs of edges that are looked at, about a us each. Half: bodies of many edges shrink the zone; twice: queries of 40
/// ms.
constexpr std::size_t kMostRodPairs = 20000;
/// Of ZoneContacts::work (us), for one element value: 10 ns, as kMostNewWork has it (1.5 million in about 15 ms). Half:
/// counted work is too small, so sets come too often; twice: too seldom.
constexpr double kWorkShare = 0.01;
/// Steps of the golden section: 0.618^14 is a thousandth of the width, and the least is flat. Half: 3 % of it; twice:
/// twice the time for rounding.
constexpr int kGoldenSteps = 14;
/// Pairs looked at without a search in trees: for so few it is not worth it. Half and twice change only time.
constexpr std::size_t kFewRodPairs = 64;
/// rad beyond a ball's cap: 6 deg for a tilt within the zone. Half: a ball at a fillet's end may be entered; twice:
/// entries that the next feature has as well.
constexpr double kCapMargin = 0.1;

bool isWithin(const geometry::Bounds& a, const dvec3& p) {
  return glm::all(glm::lessThanEqual(a.min, p)) && glm::all(glm::lessThanEqual(p, a.max));
}

/// Where on a circle a surface is least far away, of the points looked at.
struct Lowest {
  std::uint32_t element;
  double gap, angle;
};

void noteLowest(const ContactGroup& group, double angle, std::vector<Lowest>& lowest) {
  for (const ContactRow& row : group.rows) {
    if (row.kind != 0 || row.element >= SignatureCell::kOwn) continue;
    const auto found =
        std::find_if(lowest.begin(), lowest.end(), [&](const Lowest& one) { return one.element == row.element; });
    if (found == lowest.end()) {
      lowest.push_back({row.element, row.gap, angle});
    } else if (row.gap < found->gap) {
      *found = {row.element, row.gap, angle};
    }
  }
}

/// Golden section; the least is flat, so a thousandth of the width is near enough.
template <typename Value>
double leastOf(const Value& value, double low, double high) {
  constexpr double kGolden = 0.6180339887498949;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = value(a), at_b = value(b);
  for (int i = 0; i < kGoldenSteps; ++i) {
    if (at_a < at_b) {
      high = b;
      b = a, at_b = at_a;
      a = high - kGolden * (high - low);
      at_a = value(a);
    } else {
      low = a;
      a = b, at_a = at_b;
      b = low + kGolden * (high - low);
      at_b = value(b);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

bool SurfaceQuery::addBall(const Meeting& meeting, const dvec3& p_W, double radius, const ContactGroup& like) {
  const Pose X_MW = meeting.obstacle.X_W.inverse();
  BallQuery ball{*meeting.obstacle.surfaces, meeting.obstacle.X_W, X_MW * p_W, radius,
                 options_.safety_distance,   meeting.reach};
  SignatureCache& cache = cacheOf(*meeting.obstacle.surfaces);
  if (isCold() && !cache.knows(ball.p_M, radius, meeting.reach)) return false;
  const SignatureCell& cell = cache.cell(ball.p_M, radius, meeting.reach);
  ball.cell = &cell;
  new_work_ += cache.takeWork();
  if (cell.overfull || (cell.free_form && may_fall_back_)) return false;
  ball.rough = rough_allowed_;
  for (std::size_t i = 0; i < cell.groups.size(); ++i) {
    work_ += cell.groups[i].size();
    const GroupDecision telling = appendGroups(ball, cell.groups[i], like, groups_);
    if (telling == GroupDecision::kDecided) continue;
    rough_ = telling == GroupDecision::kRough;
    return false;
  }
  facets_ = facets_ || cell.facets;
  return groups_.size() <= kMostGroups;
}

/// Eight points of a circle, and the point nearest to each surface that the eight come near.
bool SurfaceQuery::addCircle(const Meeting& meeting, const BodyCircle& circle, std::uint64_t name) {
  const Pose& X_W = meeting.points.X_W;
  const double turn = circle.to - circle.from;
  const int count =
      circle.isWhole() ? kCirclePoints : std::max(2, 1 + static_cast<int>(std::ceil(turn * kCirclePoints / 6.283)));
  const double step = circle.isWhole() ? turn / count : turn / (count - 1);
  ContactGroup like = meeting.like;
  std::vector<Lowest> lowest;
  for (int k = 0; k < count; ++k) {
    const double angle = circle.from + step * k;
    const std::size_t before = groups_.size();
    like.id = mixedId(name, static_cast<std::uint64_t>(k));
    if (!addBall(meeting, X_W * circle.at(angle), circle.radius, like)) return false;
    for (std::size_t i = before; i < groups_.size(); ++i) noteLowest(groups_[i], angle, lowest);
  }
  const Pose X_MP = meeting.obstacle.X_W.inverse() * X_W;
  const dvec3 center = X_MP * circle.center_M, e1 = X_MP.rotate(circle.e1_M), e2 = X_MP.rotate(circle.e2_M);
  for (const Lowest& at : lowest) {
    const SurfaceShape& shape = meeting.obstacle.surfaces->elements()[at.element].shape;
    const auto value = [&](double angle) {
      return signedDistance(shape, center + circle.ring * (std::cos(angle) * e1 + std::sin(angle) * e2)) -
             circle.radius;
    };
    double low = at.angle - step, high = at.angle + step;
    if (!circle.isWhole()) low = std::max(low, circle.from), high = std::min(high, circle.to);
    const double angle = leastOf(value, low, high);
    work_ += kGoldenSteps;
    if (value(angle) > at.gap - kRoundEnough) continue;
    like.id = mixedId(name, 1000 + at.element);
    if (!addBall(meeting, X_W * circle.at(angle), circle.radius, like)) return false;
  }
  return true;
}

bool SurfaceQuery::meet(const Meeting& meeting) {
  const SurfaceModel& model = *meeting.points.surfaces;
  const Pose X_MW = meeting.obstacle.X_W.inverse();
  const Pose X_MP = X_MW * meeting.points.X_W;
  const geometry::Bounds box = grown(meeting.obstacle.surfaces->bounds(), meeting.reach);
  ContactGroup like = meeting.like;
  for (std::size_t i = 0; i < model.points().size(); ++i) {
    const BodyPoint& point = model.points()[i];
    const dvec3 p_M = X_MP * point.p_M;
    if (!isWithin(point.radius > 0.0 ? grown(box, point.radius) : box, p_M)) continue;
    like.id = mixedId(meeting.like.id, i);
    const std::size_t before = groups_.size();
    const dvec3 p_W = meeting.points.X_W * point.p_M;
    if (!addBall(meeting, p_W, point.radius, like)) return false;
    if (point.cosine <= -0.999) continue;
    // Only the ball's cap is there: what lies beside it is met by other features.
    const dvec3 cap_W = meeting.points.X_W.rotate(point.nhat_M);
    const double least = std::cos(std::min(3.1, std::acos(std::clamp(point.cosine, -1.0, 1.0)) + kCapMargin));
    const auto beside = [&](const ContactGroup& group) {
      return std::all_of(group.rows.begin(), group.rows.end(),
                         [&](const ContactRow& row) { return glm::dot(-row.nhat_W, cap_W) < least; });
    };
    groups_.erase(std::remove_if(groups_.begin() + static_cast<std::ptrdiff_t>(before), groups_.end(), beside),
                  groups_.end());
  }
  for (std::size_t i = 0; i < model.circles().size(); ++i) {
    const BodyCircle& circle = model.circles()[i];
    const geometry::Bounds around = grown(box, circle.ring + circle.radius);
    if (!isWithin(around, X_MP * circle.center_M)) continue;
    if (!addCircle(meeting, circle, mixedId(meeting.like.id, (std::uint64_t{1} << 32) + i))) return false;
  }
  return true;
}

/// Rims meet rims and round rods by their circles' points.
bool SurfaceQuery::addRods(std::uint32_t m, std::uint32_t e, double reach) {
  using Kind = SurfaceModel::RodKind;
  const auto cross = [&](Kind of_moving, Kind of_obstacle) { return crossRods(m, e, of_moving, of_obstacle, reach); };
  return cross(Kind::kEdge, Kind::kEdge) && cross(Kind::kEdge, Kind::kRound) && cross(Kind::kRound, Kind::kEdge) &&
         cross(Kind::kRound, Kind::kRound) && cross(Kind::kRim, Kind::kEdge) && cross(Kind::kEdge, Kind::kRim);
}

bool SurfaceQuery::crossRods(std::uint32_t m, std::uint32_t e, SurfaceModel::RodKind of_moving,
                             SurfaceModel::RodKind of_obstacle, double reach) {
  const ZonePart &moving = moving_[m], &obstacle = environment_[e];
  const std::span<const BodyRod> rods = moving.surfaces->rods(of_moving), others = obstacle.surfaces->rods(of_obstacle);
  if (rods.empty() || others.empty()) return true;
  rod_pairs_.clear();
  if (rods.size() * others.size() <= kFewRodPairs) {
    for (std::uint32_t i = 0; i < rods.size(); ++i) {
      for (std::uint32_t j = 0; j < others.size(); ++j) rod_pairs_.push_back({i, j, 0.0, dvec3(0.0), dvec3(0.0)});
    }
  } else {
    const double radius = reach + moving.surfaces->thickestRod() + obstacle.surfaces->thickestRod();
    const Pose X_MO = moving.X_W.inverse() * obstacle.X_W;
    if (!trianglePairsWithin(*moving.surfaces->rodLines(of_moving), *obstacle.surfaces->rodLines(of_obstacle), X_MO,
                             radius, rod_pairs_, kMostRodPairs))
      return false;
    std::sort(rod_pairs_.begin(), rod_pairs_.end(), [](const TrianglePair& a, const TrianglePair& b) {
      return a.triangle_a != b.triangle_a ? a.triangle_a < b.triangle_a : a.triangle_b < b.triangle_b;
    });
  }
  work_ += 20 + 5 * rod_pairs_.size();
  ContactGroup like;
  like.moving_part = m;
  like.environment_part = e;
  const auto kinds = 10 * static_cast<std::uint64_t>(of_moving) + static_cast<std::uint64_t>(of_obstacle);
  const std::uint64_t name = mixedId(mixedId(mixedId(moving.key, obstacle.key), 3), kinds);
  for (const TrianglePair& pair : rod_pairs_) {
    const BodyRod &rod = rods[pair.triangle_a], &other = others[pair.triangle_b];
    if (pair.distance > reach + rod.radius + other.radius) continue;
    like.id = mixedId(mixedId(name, pair.triangle_a), pair.triangle_b);
    appendCrossing(placed(rod, moving.X_W), placed(other, obstacle.X_W), reach, like, groups_);
    if (groups_.size() > kMostGroups) return false;
  }
  return true;
}

ZoneContact SurfaceQuery::entryOf(const ContactGroup& group, const ContactRow& row) const {
  ZoneContact contact;
  contact.moving_part = group.moving_part;
  contact.environment_part = group.environment_part;
  contact.gap = row.gap;
  contact.M_W = row.M_W;
  contact.p_W = row.p_W;
  contact.q_W = row.p_W - row.gap * row.nhat_W;
  const double sign = group.of_moving_surface ? -1.0 : 1.0;
  contact.nhat_W = sign * row.nhat_W;
  contact.normal_moves = group.of_moving_surface;
  contact.has_trim = row.has_trim;
  contact.trim_gap = row.trim_gap;
  contact.trim_nhat_W = sign * row.trim_nhat_W;
  contact.id = mixedId(mixedId(group.id, row.element), row.kind);
  return contact;
}

bool SurfaceQuery::gather(double radius) {
  groups_.clear();
  facets_ = rough_ = false;
  rough_allowed_ = radius <= options_.needed_radius;
  const double scale = radius / options_.radius;
  for (std::uint32_t m = 0; m < moving_.size(); ++m) {
    if (moving_[m].surfaces == nullptr) continue;
    const double own = moving_[m].reach > 0.0 ? moving_[m].reach : options_.radius;
    const double reach = own * scale + options_.safety_distance;
    const geometry::Bounds near = grown(geometry::transformed(moving_[m].X_W, moving_[m].surfaces->bounds()), reach);
    for (std::uint32_t e = 0; e < environment_.size(); ++e) {
      if (!counts(m, e)) continue;
      if (!overlap(near, geometry::transformed(environment_[e].X_W, environment_[e].surfaces->bounds()))) continue;
      const std::uint64_t id = mixedId(moving_[m].key, environment_[e].key);
      const bool told = meet({moving_[m], environment_[e], {m, e, false, mixedId(id, 1), {}}, reach}) &&
                        meet({environment_[e], moving_[m], {m, e, true, mixedId(id, 2), {}}, reach}) &&
                        addRods(m, e, reach);
      if (told) continue;
      weights_[m * environment_.size() + e] = kMostGroups;
      return false;
    }
  }
  return true;
}

std::optional<ZoneContacts> SurfaceQuery::attempt(double radius, std::size_t max_entries) {
  weights_.assign(moving_.size() * environment_.size(), 0);
  const bool all = gather(radius);
  if (all) keepSupports(groups_, options_.max_rotation * radius / options_.radius);
  for (const ContactGroup& group : groups_)
    weights_[group.moving_part * environment_.size() + group.environment_part] += group.rows.size();
  if (!all) return std::nullopt;
  ZoneContacts result;
  result.radius = radius;
  result.facets = facets_;
  for (const ContactGroup& group : groups_) {
    for (const ContactRow& row : group.rows) {
      result.contacts.push_back(entryOf(group, row));
      result.contacts.back().group = result.groups;
    }
    ++result.groups;
    if (result.contacts.size() > max_entries) return std::nullopt;
  }
  return result;
}

std::size_t SurfaceQuery::work() const {
  return static_cast<std::size_t>(kWorkShare * static_cast<double>(work_ + new_work_));
}

SignatureCache& SurfaceQuery::cacheOf(const SurfaceModel& model) {
  auto& cache = caches_[&model];
  if (!cache) cache = std::make_unique<SignatureCache>(model);
  return *cache;
}

}  // namespace hapticell::collision
