// SPDX-License-Identifier: Apache-2.0
#include "access/removal_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <set>

#include "access/removal_directions.h"
#include "access/sweep_limits.h"

namespace hapticell::access {

namespace {

/// Pieces of a bent way. Half: an L only; twice: a labyrinth, for which the planner is there.
constexpr int kMostPieces = 3;
/// Places from which a bent way goes on: a second or two. Half: fewer places beside corners; twice: twice the time.
constexpr std::size_t kMostPlaces = 300;
/// m that a piece ends before contact. Half: the next piece rubs along the wall; twice: gaps of 1 mm are lost.
constexpr double kBack = 2e-4;
/// m of the grid in which two places count as one. Half: eight times as many places; twice: narrow openings between
/// the stops are missed.
constexpr double kSamePlace = 3e-3;
/// m between the places where clearances are measured. Half: twice the time; twice: a rib of 4 mm may be passed over by
/// up to 1 mm.
constexpr double kStep = 2e-3;
constexpr double kLook = 1.0;  ///< m; farther neighbours have no clearance. Half and twice: longer or shorter lists.
/// Share of a step by which a distance grows where a seat is left. Half: flat wedges count as leaving; twice: slanting
/// faces count as a gap.
constexpr double kLeaving = 0.3;
/// m of sliding that is only leaving. Half: seats of soft corners count; twice: short pilots do not.
constexpr double kSlide = 2.5 * kStep;
constexpr double kTurnSpeed = 0.785;  ///< rad/s, what a hand does without haste. Half: slow; twice: hasty.
/// m and rad that a shown way may begin beside where the part stands. Half and twice: how exactly a hand puts it back.
constexpr double kBegins = 1e-3, kBeginsTurned = 0.0175;

double angleBetween(const Pose& a, const Pose& b) {
  return glm::length(difference(b, a).angular);
}

geometry::Bounds movedBounds(const RemovalUnit& unit, const Pose& X_WW2) {
  geometry::Bounds bounds;
  for (const auto& part : unit.parts)
    bounds.add(geometry::transformed(X_WW2 * part.X_WP, part.part->mesh.collider->bounds()));
  return bounds;
}

Pose restOf(const RemovalScene& scene, std::size_t unit) {
  return scene.scene().find(scene.units()[unit].entity)->X_WE;
}

/// Of the distances to one neighbour along the way, sampled at steps of about `step` m.
NeighbourClearance readSeries(const std::vector<double>& distances, double step, double tolerance) {
  NeighbourClearance clearance;
  std::size_t i = 0;
  clearance.touches_at_rest = distances[0] <= tolerance;
  if (clearance.touches_at_rest) {
    while (i < distances.size() && distances[i] <= tolerance) ++i;
    clearance.slides_m = static_cast<double>(i - 1) * step;
    if (clearance.slides_m > kSlide) {
      clearance.least_m = 0.0;
      return clearance;
    }
    while (i < distances.size() && i > 0 && distances[i] - distances[i - 1] >= kLeaving * step) ++i;
    // Beyond the look it is as good as gone.
    while (i < distances.size() && distances[i] >= kLook) ++i;
  }
  for (; i < distances.size(); ++i) {
    if (distances[i] >= clearance.least_m || distances[i] >= kLook) continue;
    clearance.least_m = distances[i];
    clearance.at_m = static_cast<double>(i) * step;
  }
  return clearance;
}

}  // namespace

double RemovalWay::length() const {
  double length = 0.0;
  for (std::size_t i = 1; i < X_WE.size(); ++i) length += glm::length(X_WE[i].p - X_WE[i - 1].p);
  return length;
}

Pose RemovalWay::at(double share) const {
  double left = share * length();
  for (std::size_t i = 1; i < X_WE.size(); ++i) {
    const double piece = glm::length(X_WE[i].p - X_WE[i - 1].p);
    if (left <= piece && piece > 0.0) return interpolate(X_WE[i - 1], X_WE[i], left / piece);
    left -= piece;
  }
  return X_WE.back();
}

const char* toString(RemovalWay::Kind kind) {
  constexpr std::array kWords{"straight", "bent", "planned", "shown"};
  return kWords[static_cast<std::size_t>(kind)];
}

collision::PartMotion rigidMotion(const Pose& X_WFrom, const Pose& X_WTo, const Pose& X_WP0, double radius) {
  const Pose X_EP = X_WFrom.inverse() * X_WP0;
  const double angle = angleBetween(X_WFrom, X_WTo), way = glm::length(X_WTo.p - X_WFrom.p);
  collision::PartMotion motion;
  motion.X_WStart = X_WP0;
  motion.X_WEnd = X_WTo * X_EP;
  motion.path_bound = way + angle * (glm::length(X_EP.p) + radius);
  if (angle < 1e-12) return motion;
  motion.bend_bound = angle * angle * (glm::length(X_EP.p) + radius);
  motion.along = [X_WFrom, X_WTo, X_EP](double s) { return interpolate(X_WFrom, X_WTo, s) * X_EP; };
  return motion;
}

UnitMotion::UnitMotion(const RemovalScene& scene, std::size_t unit, UnitSet gone, double clearance)
    : X_EW_(restOf(scene, unit).inverse()), clearance_(clearance) {
  const RemovalUnit& own = scene.units()[unit];
  for (const auto& part : own.parts) {
    scene_.addPart({own.entity, static_cast<std::uint32_t>(X_WP_.size())}, part.thin, part.X_WP);
    X_WP_.push_back(part.X_WP);
    unit_of_.push_back(unit);
  }
  for (std::size_t other = 0; other < scene.units().size(); ++other) {
    const bool left = other < scene.movableCount() && (gone >> other & 1) != 0;
    if (other == unit || left) continue;
    for (const auto& part : scene.units()[other].parts) {
      const auto index = scene_.addPart({scene.units()[other].entity, static_cast<std::uint32_t>(unit_of_.size())},
                                        part.part->mesh.collider, part.X_WP);
      unit_of_.push_back(other);
      for (std::size_t i = 0; i < own.parts.size(); ++i)
        if (scene.areChecked(own.parts[i], part)) scene_.addPair(static_cast<collision::PartIndex>(i), index);
    }
  }
}

std::vector<collision::MovedPart> UnitMotion::motionOf(const Pose& X_WFrom, const Pose& X_WTo) const {
  std::vector<collision::MovedPart> moved;
  for (std::size_t i = 0; i < X_WP_.size(); ++i) {
    const auto part = static_cast<collision::PartIndex>(i);
    const auto& collider = scene_.collider(part);
    moved.push_back({part, rigidMotion(X_WFrom, X_WTo, X_WFrom * X_EW_ * X_WP_[i],
                                       glm::length(collider.center()) + collider.radius())});
  }
  return moved;
}

double UnitMotion::advance(const Pose& X_WFrom, const Pose& X_WTo) {
  stopped_by_.reset();
  double done = 0.0;
  for (int i = 0; i < kMostContinued; ++i) {
    const Pose X_WNow = interpolate(X_WFrom, X_WTo, done);
    const auto moved = motionOf(X_WNow, X_WTo);
    for (const auto& part : moved) scene_.setPose(part.part, part.motion.X_WStart);
    const collision::SceneStop stop = scene_.advance(moved, clearance_);
    if (!stop.stopped && !stop.began_colliding) return 1.0;
    stopped_by_ = unit_of_[scene_.environment(stop.pair)];
    if (stop.began_colliding) return done;
    done += stop.s * (1.0 - done);
    if (stop.nearest.distance < clearance_ + kStopped) return done;
  }
  return done;
}

bool UnitMotion::collidesAt(const Pose& X_WE) {
  for (std::size_t i = 0; i < X_WP_.size(); ++i)
    scene_.setPose(static_cast<collision::PartIndex>(i), X_WE * X_EW_ * X_WP_[i]);
  return scene_.collides();
}

RemovalWay straightAsWay(const RemovalScene& scene, std::size_t unit, const dvec3& direction_W, double length) {
  const Pose X_WE = restOf(scene, unit);
  Pose end = X_WE;
  end.p += length * direction_W;
  return {RemovalWay::Kind::kStraight, {X_WE, end}};
}

std::optional<RemovalWay> bentWay(const RemovalScene& scene, std::size_t unit, UnitSet gone) {
  struct Place {
    dvec3 offset{0.0};
    int pieces = 0;
    std::size_t from = 0;
  };
  const Pose rest = restOf(scene, unit);
  const auto at = [&](const dvec3& offset) { return Pose{rest.p + offset, rest.q}; };
  UnitMotion motion(scene, unit, gone);
  if (motion.collidesAt(rest)) return std::nullopt;
  const std::vector<dvec3> directions = removalDirections(scene, unit);
  // Until it is surely out: the box's diagonal more than wayOut() from rest.
  const double across = glm::length(scene.box_W().size());
  std::vector<Place> places{{}};
  std::set<std::array<long, 3>> known;
  for (std::size_t n = 0; n < places.size() && n < kMostPlaces; ++n) {
    for (const dvec3& direction : directions) {
      const double whole = scene.wayOut(unit, direction) + across;
      const Place place = places[n];
      const dvec3 far = place.offset + whole * direction;
      const double free = motion.advance(at(place.offset), at(far)) * whole;
      const geometry::Bounds box = movedBounds(scene.units()[unit], Pose::translation(place.offset));
      double out = std::numeric_limits<double>::infinity();  // The least way from here that leaves the box.
      for (int i = 0; i < 3; ++i) {
        if (direction[i] > 1e-6) out = std::min(out, (scene.box_W().max[i] - box.min[i]) / direction[i]);
        if (direction[i] < -1e-6) out = std::min(out, (box.max[i] - scene.box_W().min[i]) / -direction[i]);
      }
      out = std::max(out, 0.0) + 1e-3;
      if (free >= out) {
        RemovalWay way{place.pieces == 0 ? RemovalWay::Kind::kStraight : RemovalWay::Kind::kBent, {}};
        way.X_WE.push_back(at(place.offset + out * direction));
        for (std::size_t k = n; k != 0; k = places[k].from) way.X_WE.push_back(at(places[k].offset));
        way.X_WE.push_back(rest);
        std::reverse(way.X_WE.begin(), way.X_WE.end());
        return way;
      }
      if (place.pieces + 1 >= kMostPieces) continue;
      for (const double share : {1.0, 0.75, 0.5, 0.25}) {
        const double reach = share * (free - kBack);
        if (reach < kSamePlace) continue;
        const dvec3 offset = place.offset + reach * direction;
        const dvec3 cell = glm::round(offset / kSamePlace);
        if (!known.insert({std::lround(cell.x), std::lround(cell.y), std::lround(cell.z)}).second) continue;
        places.push_back({offset, place.pieces + 1, n});
      }
    }
  }
  return std::nullopt;
}

Expected<RemovalWay> checkedWay(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                const trajectory::Trajectory& shown) {
  const std::string& name = scene.units()[unit].name;
  const auto wrong = [&](Text found, Text expected) {
    return makeError({.place = Text("the way of '%1'", name), .found = std::move(found), .expected = std::move(expected)});
  };
  if (shown.size() < 2 || !shown.has_poses) return wrong("no motion", "a recording of the part with its poses");
  const Pose rest = restOf(scene, unit);
  if (glm::length(shown[0].X_WT.p - rest.p) > kBegins || angleBetween(shown[0].X_WT, rest) > kBeginsTurned)
    return wrong("it begins elsewhere", "a motion that begins where the part stands");
  RemovalWay way{RemovalWay::Kind::kShown, {rest}};
  for (const auto& frame : shown.frames()) way.X_WE.push_back(frame.X_WT);
  UnitMotion motion(scene, unit, gone);
  for (std::size_t i = 1; i < way.X_WE.size(); ++i) {
    if (motion.advance(way.X_WE[i - 1], way.X_WE[i]) >= 1.0) continue;
    const std::string met = motion.stoppedBy() ? scene.units()[*motion.stoppedBy()].name : std::string("?");
    return wrong(Text("it meets '%1' in frame %2", met, i), "a motion that is free");
  }
  if (!areApart(movedBounds(scene.units()[unit], way.X_WE.back() * rest.inverse()), scene.box_W()))
    return wrong("it ends inside the assembly's box", "a motion out of it");
  return way;
}

trajectory::Trajectory trajectoryOf(const RemovalScene& scene, std::size_t unit, const RemovalWay& way, double speed) {
  trajectory::Trajectory motion;
  motion.entity = scene.units()[unit].name;
  motion.moved = "self_origin";
  motion.name = motion.entity + " out";
  double t = 0.0;
  for (std::size_t i = 0; i < way.X_WE.size(); ++i) {
    if (i > 0) {
      const double go = glm::length(way.X_WE[i].p - way.X_WE[i - 1].p) / speed;
      const double turn = angleBetween(way.X_WE[i - 1], way.X_WE[i]) / kTurnSpeed;
      const double step = std::max(go, turn);
      if (step <= 0.0) continue;
      t += step;
    }
    motion.addFrame({t, way.X_WE[i]});
  }
  return motion;
}

std::vector<NeighbourClearance> clearances(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                           const RemovalWay& way) {
  const RemovalUnit& own = scene.units()[unit];
  const Pose X_EW = restOf(scene, unit).inverse();
  const double length = way.length();
  const auto steps = static_cast<std::size_t>(std::ceil(std::max(length, kStep) / kStep));
  std::vector<NeighbourClearance> all;
  for (std::size_t other = 0; other < scene.units().size(); ++other) {
    if (other == unit || (other < scene.movableCount() && (gone >> other & 1) != 0)) continue;
    std::vector<double> distances(steps + 1, kLook);
    for (const auto& a : own.parts) {
      for (const auto& b : scene.units()[other].parts) {
        if (!scene.areChecked(a, b)) continue;
        collision::ProximityQuery query(a.part->mesh.collider, b.part->mesh.collider);
        for (std::size_t i = 0; i <= steps; ++i) {
          const Pose X_WP = way.at(static_cast<double>(i) / static_cast<double>(steps)) * X_EW * a.X_WP;
          distances[i] = std::min(distances[i], query.distance(X_WP, b.X_WP, distances[i]).distance);
        }
      }
    }
    NeighbourClearance found = readSeries(distances, length / static_cast<double>(steps), scene.tolerance());
    found.name = scene.units()[other].name;
    if (found.touches_at_rest || found.least_m < kLook) all.push_back(std::move(found));
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.least_m < b.least_m; });
  return all;
}

}  // namespace hapticell::access
