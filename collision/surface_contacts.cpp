// SPDX-License-Identifier: Apache-2.0
#include "collision/surface_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "collision/contact_rows.h"
#include "collision/crossing_rods.h"
#include "collision/mesh_search.h"
#include "geometry/assertion.h"

namespace hapticell::collision {

namespace {

constexpr double kShrink = 0.65;
constexpr int kCirclePoints = 8;
constexpr double kRoundEnough = 2e-5;         // m that a circle may stand out between its points
constexpr std::size_t kMostGroups = 3000;     // before they are thinned out; with more the zone shrinks
constexpr std::size_t kMostRodPairs = 20000;  // looked at
constexpr std::size_t kMostNewWork = 300000;  // element values for new cells, about 20 ms
constexpr double kColdShare = 0.05;           // of the wanted zone: where the first query begins
constexpr double kWorkShare = 0.01;           // of ZoneContacts::work, for one element value
constexpr int kRest = 12;
constexpr int kTryLarger = 4;       // a wider zone is tried with each so many queries
constexpr double kCapMargin = 0.1;  // rad beyond a ball's cap

geometry::Bounds grown(geometry::Bounds bounds, double by) {
  bounds.min -= dvec3(by);
  bounds.max += dvec3(by);
  return bounds;
}

bool overlap(const geometry::Bounds& a, const geometry::Bounds& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

bool contains(const geometry::Bounds& a, const dvec3& p) {
  return glm::all(glm::lessThanEqual(a.min, p)) && glm::all(glm::lessThanEqual(p, a.max));
}

}  // namespace

SignatureCache& SurfaceContacts::cacheOf(const SurfaceModel& model) {
  auto& cache = caches_[&model];
  if (!cache) cache = std::make_unique<SignatureCache>(model);
  return *cache;
}

bool SurfaceContacts::isWorthAsking() {
  if (resting_ == 0) return true;
  --resting_;
  return false;
}

void SurfaceContacts::tellUse(bool used) {
  resting_ = used ? 0 : kRest;
}

class SurfaceQuery {
 public:
  SurfaceQuery(SurfaceContacts& owner, std::span<const ZonePart> moving, std::span<const ZonePart> environment,
               const ZoneOptions& options)
      : owner_(owner), moving_(moving), environment_(environment), options_(options) {}

  ZoneContacts run();

 private:
  /// The points of one body against the surfaces of another.
  struct Meeting {
    const ZonePart& points;
    const ZonePart& obstacle;
    ContactGroup like;
    double reach;
  };

  bool counts(std::size_t m, std::size_t e) const {
    return options_.pair_mask.empty() || options_.pair_mask[m * environment_.size() + e] != 0;
  }
  std::optional<ZoneContacts> attempt(double radius);
  bool meet(const Meeting& meeting);
  bool addBall(const Meeting& meeting, const dvec3& p_W, double radius, const ContactGroup& like);
  bool addCircle(const Meeting& meeting, const BodyCircle& circle, std::uint64_t name);
  bool addRods(std::uint32_t m, std::uint32_t e, double reach);
  bool addRods(std::uint32_t m, std::uint32_t e, const MeshCollider* of_moving, const MeshCollider* of_obstacle,
               double reach);
  ZoneContact entryOf(const ContactGroup& group, const ContactRow& row) const;

  SurfaceContacts& owner_;
  std::span<const ZonePart> moving_;
  std::span<const ZonePart> environment_;
  ZoneOptions options_;
  std::vector<ContactGroup> groups_;
  std::vector<TrianglePair> rod_pairs_;
  bool facets_ = false;
  std::size_t new_work_ = 0;      ///< For new cells at one radius,
  std::size_t all_new_work_ = 0;  ///< and in all.
  std::size_t work_ = 0;
};

bool SurfaceQuery::addBall(const Meeting& meeting, const dvec3& p_W, double radius, const ContactGroup& like) {
  const Pose X_MW = meeting.obstacle.X_W.inverse();
  const BallQuery ball{*meeting.obstacle.surfaces, meeting.obstacle.X_W, X_MW * p_W, radius,
                       options_.safety_distance,   meeting.reach};
  SignatureCache& cache = owner_.cacheOf(*meeting.obstacle.surfaces);
  const SignatureCell& cell = cache.cell(ball.p_M, radius, meeting.reach);
  const std::size_t made = cache.takeWork();
  new_work_ += made;
  all_new_work_ += made;
  if (cell.overfull || new_work_ > kMostNewWork) return false;
  for (std::size_t i = 0; i < cell.groups.size(); ++i) {
    work_ += cell.groups[i].size();
    appendGroups(ball, cell.groups[i], like, groups_);
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
  std::vector<std::pair<std::uint32_t, std::pair<double, double>>> nearest;  // element, its least value and angle
  const Pose X_MW = meeting.obstacle.X_W.inverse();
  for (int k = 0; k < count; ++k) {
    const double angle = circle.from + step * k;
    const dvec3 p_W = X_W * circle.at(angle);
    const std::size_t before = groups_.size();
    like.id = mixedId(name, static_cast<std::uint64_t>(k));
    if (!addBall(meeting, p_W, circle.radius, like)) return false;
    for (std::size_t i = before; i < groups_.size(); ++i) {
      for (const ContactRow& row : groups_[i].rows) {
        if (row.kind != 0) continue;
        const auto found =
            std::find_if(nearest.begin(), nearest.end(), [&](const auto& n) { return n.first == row.element; });
        if (found == nearest.end()) {
          nearest.push_back({row.element, {row.gap, angle}});
        } else if (row.gap < found->second.first) {
          found->second = {row.gap, angle};
        }
      }
    }
  }
  for (const auto& [element, best] : nearest) {
    const SurfaceShape& shape = meeting.obstacle.surfaces->elements()[element].shape;
    const auto value = [&](double angle) {
      return signedDistance(shape, X_MW * (X_W * circle.at(angle))) - circle.radius;
    };
    double low = best.second - step, high = best.second + step;
    if (!circle.isWhole()) low = std::max(low, circle.from), high = std::min(high, circle.to);
    for (int i = 0; i < 24; ++i) {  // golden section
      const double a = high - 0.618034 * (high - low), b = low + 0.618034 * (high - low);
      (value(a) < value(b) ? high : low) = value(a) < value(b) ? b : a;
    }
    work_ += 48;
    const double angle = 0.5 * (low + high);
    if (value(angle) > best.first - kRoundEnough) continue;
    like.id = mixedId(name, 1000 + element);
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
    if (!contains(point.radius > 0.0 ? grown(box, point.radius) : box, p_M)) continue;
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
    if (!contains(around, X_MP * circle.center_M)) continue;
    if (!addCircle(meeting, circle, mixedId(meeting.like.id, (std::uint64_t{1} << 32) + i))) return false;
  }
  return true;
}

bool SurfaceQuery::addRods(std::uint32_t m, std::uint32_t e, double reach) {
  const SurfaceModel &moving = *moving_[m].surfaces, &obstacle = *environment_[e].surfaces;
  return addRods(m, e, moving.plainRods(), obstacle.plainRods(), reach) &&
         addRods(m, e, moving.rimRods(), obstacle.plainRods(), reach) &&
         addRods(m, e, moving.plainRods(), obstacle.rimRods(), reach);
}

/// Rims meet rims and round rods by their circles' points.
bool SurfaceQuery::addRods(std::uint32_t m, std::uint32_t e, const MeshCollider* of_moving,
                           const MeshCollider* of_obstacle, double reach) {
  if (of_moving == nullptr || of_obstacle == nullptr) return true;
  const ZonePart &moving = moving_[m], &obstacle = environment_[e];
  rod_pairs_.clear();
  const double radius = reach + moving.surfaces->thickestRod() + obstacle.surfaces->thickestRod();
  if (!trianglePairsWithin(*of_moving, *of_obstacle, moving.X_W.inverse() * obstacle.X_W, radius, rod_pairs_,
                           kMostRodPairs))
    return false;
  work_ += 20 + 5 * rod_pairs_.size();
  std::sort(rod_pairs_.begin(), rod_pairs_.end(), [](const TrianglePair& a, const TrianglePair& b) {
    return a.triangle_a != b.triangle_a ? a.triangle_a < b.triangle_a : a.triangle_b < b.triangle_b;
  });
  const std::size_t first_a = of_moving == moving.surfaces->rimRods() ? moving.surfaces->plainRodCount() : 0;
  const std::size_t first_b = of_obstacle == obstacle.surfaces->rimRods() ? obstacle.surfaces->plainRodCount() : 0;
  for (const TrianglePair& pair : rod_pairs_) {
    const std::size_t i = first_a + pair.triangle_a, j = first_b + pair.triangle_b;
    const BodyRod &rod = moving.surfaces->rods()[i], &other = obstacle.surfaces->rods()[j];
    if ((rod.rim && other.radius > 0.0) || (other.rim && rod.radius > 0.0)) continue;
    if (pair.distance > reach + rod.radius + other.radius) continue;
    ContactGroup like;
    like.moving_part = m;
    like.environment_part = e;
    like.id = mixedId(mixedId(mixedId(mixedId(moving.key, obstacle.key), 3), i), j);
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

std::optional<ZoneContacts> SurfaceQuery::attempt(double radius) {
  groups_.clear();
  facets_ = false;
  new_work_ = 0;
  const double scale = radius / options_.radius;
  for (std::uint32_t m = 0; m < moving_.size(); ++m) {
    const double own = moving_[m].reach > 0.0 ? moving_[m].reach : options_.radius;
    const double reach = own * scale + options_.safety_distance;
    const geometry::Bounds near = grown(geometry::transformed(moving_[m].X_W, moving_[m].surfaces->bounds()), reach);
    for (std::uint32_t e = 0; e < environment_.size(); ++e) {
      if (!counts(m, e)) continue;
      if (!overlap(near, geometry::transformed(environment_[e].X_W, environment_[e].surfaces->bounds()))) continue;
      const std::uint64_t id = mixedId(moving_[m].key, environment_[e].key);
      if (!meet({moving_[m], environment_[e], {m, e, false, mixedId(id, 1), {}}, reach})) return std::nullopt;
      if (!meet({environment_[e], moving_[m], {m, e, true, mixedId(id, 2), {}}, reach})) return std::nullopt;
      if (!addRods(m, e, reach)) return std::nullopt;
    }
  }
  keepSupports(groups_, options_.max_rotation * scale);
  ZoneContacts result;
  result.radius = radius;
  result.facets = facets_;
  for (const ContactGroup& group : groups_) {
    for (const ContactRow& row : group.rows) {
      result.contacts.push_back(entryOf(group, row));
      result.contacts.back().group = result.groups;
    }
    ++result.groups;
    if (result.contacts.size() > options_.max_entries) return std::nullopt;
  }
  return result;
}

ZoneContacts SurfaceQuery::run() {
  std::vector<double> radii{options_.radius};
  while (radii.back() * kShrink >= options_.min_radius) radii.push_back(radii.back() * kShrink);
  const auto finish = [&](ZoneContacts result) {
    result.hint.radius = result.radius;
    result.work = 1 + static_cast<std::size_t>(kWorkShare * static_cast<double>(work_ + all_new_work_));
    return result;
  };
  std::size_t level = 0;
  const double start = options_.hint.radius > 0.0 ? options_.hint.radius : kColdShare * options_.radius;
  while (level + 1 < radii.size() && radii[level] > start * 1.001) ++level;
  const bool grow = options_.hint.radius <= 0.0 || options_.hint.try_larger;
  auto found = attempt(radii[level]);
  while (found && grow && level > 0 && all_new_work_ < kMostNewWork) {
    auto larger = attempt(radii[level - 1]);
    if (!larger) break;
    found = std::move(larger);
    --level;
  }
  while (!found && ++level < radii.size()) found = attempt(radii[level]);
  if (found) return finish(std::move(*found));
  ZoneContacts none;
  none.radius = options_.min_radius;
  none.complete = false;
  return finish(std::move(none));
}

ZoneContacts SurfaceContacts::find(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                                   const ZoneOptions& options) {
  for (const ZonePart& body : moving) HAPTICELL_DEMAND(body.surfaces != nullptr);
  for (const ZonePart& body : environment) HAPTICELL_DEMAND(body.surfaces != nullptr);
  HAPTICELL_DEMAND(options.pair_mask.empty() || options.pair_mask.size() == moving.size() * environment.size());
  HAPTICELL_DEMAND(options.radius > 0.0 && options.max_entries > 0);
  ZoneOptions own = options;
  if (own.hint.radius <= 0.0 && wanted_ > 0.0) {
    own.hint.radius = options.radius * std::min(1.0, kept_ / wanted_);
    own.hint.try_larger = since_larger_ >= kTryLarger;
  }
  since_larger_ = own.hint.try_larger ? 0 : since_larger_ + 1;
  ZoneContacts found = SurfaceQuery(*this, moving, environment, own).run();
  if (found.radius > kept_ * options.radius / std::max(wanted_, 1e-9)) since_larger_ = kTryLarger;  // there may be more
  wanted_ = options.radius;
  kept_ = found.radius;
  return found;
}

}  // namespace hapticell::collision
