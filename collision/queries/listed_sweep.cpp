// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/listed_sweep.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/triangle_gap.h"

namespace hapticell::collision {

namespace {

/// Steps of one pair; then the motion ends where it is proven so far. Advancement takes few unless it runs along a
/// surface. Half: motions along surfaces end sooner; twice: slower before they do.
constexpr int kMostSteps = 100;
/// Passes by which pairs go back that an end found later has moved past. Then nothing is proven. Half: such motions
/// stop; twice: longer before.
constexpr int kMostPasses = 6;
struct Placing {
  dmat3 R{1.0};
  dvec3 p{0.0};
  Corners operator*(const Corners& c) const { return {R * c[0] + p, R * c[1] + p, R * c[2] + p}; }
};

/// The share u of a stretch up to which  begin (1 - u) + end u - 4 bend u (1 - u)  keeps `least`: the gap of points on
/// straight paths is at least the first two terms, paths stray from that by the third, in their middle by `bend`.
double keptShare(double begin, double end, double bend, double least) {
  if (!std::isfinite(bend)) return 0.0;
  const double curve = 4.0 * bend, slope = end - begin - curve, over = begin - least;
  const double discriminant = slope * slope - 4.0 * curve * over;
  if (slope >= 0.0 || discriminant < 0.0) return 1.0;
  // The smaller root, in the form that does not cancel.
  return std::min(1.0, 2.0 * over / (-slope + std::sqrt(discriminant)));
}

/// Everything in A's frame at the beginning of the stretch.
class ListedSweep {
 public:
  ListedSweep(const MeshCollider& a, const MeshCollider& b, const NearPairs& near, const PartMotion& motion_a,
              const PartMotion& motion_b, const ListedStretch& stretch)
      : mesh_a_(a.mesh()),
        mesh_b_(b.mesh()),
        near_(near),
        motion_a_(motion_a),
        motion_b_(motion_b),
        stretch_(stretch),
        rate_(motion_a.path_bound + motion_b.path_bound),
        bend_(motion_a.bend_bound + motion_b.bend_bound),
        X_WA0_(motion_a.at(stretch.from)),
        X_A0W_(X_WA0_.inverse()),
        until_(stretch.to) {
    worn_ = near_.movedSince(X_A0W_ * motion_b.at(stretch.from));
    place(stretch.from, begin_);
    place(stretch.to, end_);
    here_ = begin_;
  }

  ListedStop run() {
    ListedStop stop;
    for (std::size_t k = 0; k < near_.pairs().size(); ++k) advancePair(k);
    for (int pass = 0; stopped_ && pass < kMostPasses; ++pass) {
      if (!backOff()) break;
      if (pass + 1 == kMostPasses) endAt(stretch_.from);
    }
    stop.s = until_;
    stop.stopped = stopped_;
    if (stopped_) {
      setNearest(stop);
    } else {
      stop.distance_at_least = std::min(least_at_end_, unlisted());
    }
    return stop;
  }

 private:
  struct Placed {
    double s = 0.0;
    Placing a, b;
  };

  void place(double s, Placed& placed) const {
    const Pose X_A0A = X_A0W_ * motion_a_.at(s), X_A0B = X_A0W_ * motion_b_.at(s);
    placed = {s, {X_A0A.R(), X_A0A.p}, {X_A0B.R(), X_A0B.p}};
  }
  const Placed& at(double s) {
    if (s == begin_.s) return begin_;
    if (s == end_.s) return end_;
    if (s != here_.s) place(s, here_);
    return here_;
  }

  double motionTo(double s) const { return rate_ * (s - stretch_.from); }
  double unlisted() const { return near_.reachAt(X_A0W_ * motion_b_.at(stretch_.from)) - motionTo(until_); }
  /// What the pair's listed distance still tells at s.
  double listedBound(std::size_t k, double s) const { return near_.pairs()[k].distance - worn_ - motionTo(s); }

  NearestPair distanceAt(std::size_t k, double s) {
    const TrianglePair& pair = near_.pairs()[k];
    const Placed& placed = at(s);
    return triangleDistance(placed.a * mesh_a_.corners(pair.triangle_a), placed.b * mesh_b_.corners(pair.triangle_b));
  }

  double gapOf(std::size_t k, const dvec3& axis, double s) {
    const TrianglePair& pair = near_.pairs()[k];
    const Placed& placed = at(s);
    return gapAlong(axis, placed.a * mesh_a_.corners(pair.triangle_a), placed.b * mesh_b_.corners(pair.triangle_b));
  }

  bool violates(double distance) const { return distance < stretch_.clearance - kRounding; }

  void advancePair(std::size_t k) {
    if (const double bound = listedBound(k, until_); bound >= stretch_.clearance) {
      least_at_end_ = std::min(least_at_end_, bound);
      return;
    }
    if (staysApartOnKnownAxis(k)) return;
    double s = stretch_.from;
    NearestPair here = distanceAt(k, s);
    double distance = std::sqrt(here.squared);
    for (int step = 0; step < kMostSteps; ++step) {
      const double rest = until_ - s;
      if (distance - rate_ * rest >= stretch_.clearance) {
        least_at_end_ = std::min(least_at_end_, distance - rate_ * rest);
        return;
      }
      if (!(distance > 0.0)) break;
      const dvec3 axis = (here.p - here.q) / distance;
      const double gap = gapOf(k, axis, until_);
      const double least = 0.5 * stretch_.clearance;
      const double share = keptShare(gapOf(k, axis, s), gap, bend_ * rest * rest / 8.0, least);
      if (share >= 1.0 && gap >= stretch_.clearance) {
        least_at_end_ = std::min(least_at_end_, gap);
        return;
      }
      const double next = std::min(until_, s + std::max(share * rest, (distance - least) / rate_));
      here = distanceAt(k, next);
      const double distance_next = std::sqrt(here.squared);
      if (violates(distance_next)) return stopPair(k, {s, distance}, {next, distance_next});
      s = next;
      distance = distance_next;
      if (s >= until_) {
        least_at_end_ = std::min(least_at_end_, distance);
        return;
      }
    }
    endAt(s);
  }

  /// On the line of the nearest points when the pair was listed, or on a face's normal: a cheap proof that most pairs
  /// pass, those of faces that slide over each other too.
  bool staysApartOnKnownAxis(std::size_t k) {
    const TrianglePair& pair = near_.pairs()[k];
    const Corners a = mesh_a_.corners(pair.triangle_a), b = mesh_b_.corners(pair.triangle_b);
    const Corners a0 = begin_.a * a, b0 = begin_.b * b, a1 = end_.a * a, b1 = end_.b * b;
    const double length = until_ - stretch_.from, bend = bend_ * length * length / 8.0;
    const auto proves = [&](const dvec3& axis) {
      const double begin = gapAlong(axis, a0, b0), end = gapAlong(axis, a1, b1);
      if (begin < stretch_.clearance || end < stretch_.clearance) return false;
      if (keptShare(begin, end, bend, 0.5 * stretch_.clearance) < 1.0) return false;
      least_at_end_ = std::min(least_at_end_, end);
      return true;
    };
    if (pair.distance > 0.0 && proves((pair.p_AP - pair.p_AQ) / pair.distance)) return true;
    for (const Corners* face : {&b0, &a0}) {
      const dvec3 normal = glm::cross((*face)[1] - (*face)[0], (*face)[2] - (*face)[0]);
      const double size = glm::length(normal);
      if (size > 0.0 && (proves(normal / size) || proves(-normal / size))) return true;
    }
    return false;
  }

  void endAt(double s) {
    until_ = s;
    stopped_ = true;
    place(s, end_);
  }

  struct Sample {
    double s, distance;
  };
  /// The whole stretch is free; finds how far along it the clearance still holds (regula falsi with halving).
  void stopPair(std::size_t k, Sample good, Sample bad) {
    for (int i = 0; i < 40 && (bad.s - good.s) * rate_ > kStopAccuracy; ++i) {
      const double above = good.distance - stretch_.clearance, below = stretch_.clearance - bad.distance;
      const double share = i % 3 == 2 || above <= 0.0 ? 0.5 : std::clamp(above / (above + below), 0.05, 0.95);
      const double s = good.s + share * (bad.s - good.s);
      const double distance = std::sqrt(distanceAt(k, s).squared);
      (violates(distance) ? bad : good) = {s, distance};
    }
    endAt(good.s);
  }

  /// A pair that only passed through may be too near just where another stops the motion; true when that moved it.
  bool backOff() {
    bool moved = false;
    for (std::size_t k = 0; k < near_.pairs().size(); ++k) {
      if (listedBound(k, until_) >= stretch_.clearance) continue;
      const double distance = std::sqrt(distanceAt(k, until_).squared);
      if (!violates(distance)) continue;
      stopPair(k, {stretch_.from, std::sqrt(distanceAt(k, stretch_.from).squared)}, {until_, distance});
      moved = true;
    }
    return moved;
  }

  void setNearest(ListedStop& stop) {
    for (std::size_t k = 0; k < near_.pairs().size(); ++k) {
      const double bound = listedBound(k, until_);
      if (bound > 0.0 && bound * bound >= stop.nearest.squared) continue;
      const NearestPair found = distanceAt(k, until_);
      if (found.squared >= stop.nearest.squared) continue;
      stop.nearest = found;
      stop.pair = {near_.pairs()[k].triangle_a, near_.pairs()[k].triangle_b};
    }
    stop.distance_at_least = std::min(std::sqrt(stop.nearest.squared), unlisted());
    stop.nearest.p = X_WA0_ * stop.nearest.p;
    stop.nearest.q = X_WA0_ * stop.nearest.q;
  }

  const geometry::TriangleMesh& mesh_a_;
  const geometry::TriangleMesh& mesh_b_;
  const NearPairs& near_;
  const PartMotion& motion_a_;
  const PartMotion& motion_b_;
  const ListedStretch& stretch_;
  double rate_, bend_;
  Pose X_WA0_, X_A0W_;
  double until_;
  double worn_ = 0.0;
  double least_at_end_ = std::numeric_limits<double>::infinity();
  bool stopped_ = false;
  Placed begin_, end_, here_;
};

}  // namespace

ListedStop sweepListed(const MeshCollider& a, const MeshCollider& b, const NearPairs& near, const PartMotion& motion_a,
                       const PartMotion& motion_b, const ListedStretch& stretch) {
  return ListedSweep(a, b, near, motion_a, motion_b, stretch).run();
}

NearestPair nearestListed(const MeshCollider& a, const MeshCollider& b, const NearPairs& near, const Pose& X_AB,
                          double limit, TriangleIndices& pair) {
  NearestPair best;
  best.squared = limit * limit;
  const double worn = near.movedSince(X_AB);
  const Placing X{X_AB.R(), X_AB.p};
  bool found = false;
  for (const TrianglePair& listed : near.pairs()) {
    const double bound = listed.distance - worn;
    if (bound > 0.0 && bound * bound >= best.squared) continue;
    if (!improveTriangleDistance(a.mesh().corners(listed.triangle_a), X * b.mesh().corners(listed.triangle_b), best))
      continue;
    found = true;
    pair = {listed.triangle_a, listed.triangle_b};
  }
  return found ? best : NearestPair{};
}

}  // namespace hapticell::collision
