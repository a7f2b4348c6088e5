// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/motion_check.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/listed_sweep.h"
#include "collision/queries/motion_bound.h"
#include "collision/queries/swept_check.h"

namespace hapticell::collision {

namespace {

/// Distance queries of one motion, 10 to 100 us each (Performance): 4 to 40 ms. Then it ends where it is proven. Half:
/// long ways along surfaces are cut sooner; twice: steps of 80 ms.
constexpr int kMostQueries = 400;
/// m of motion between two looks while parts that began inside each other still are. Half: twice the queries until
/// free; twice: a place where they are free for 3 mm may be passed.
constexpr double kStepWhileColliding = 2e-3;
/// m of motion: the longest step that is tried first to be proven of whole boxes. It is adapted at once by
/// kStrideFactor; half and twice cost a try more or less.
constexpr double kFirstStride = 0.02;
/// In plain steps: a shorter stride is not worth the proof, which takes about as long as a query. Half: proofs for
/// nothing; twice: plain steps where proofs would be quicker.
constexpr double kLeastStride = 2.0;
/// By which the stride grows when proven and shrinks when not. 4 until whole boxes were proven (commit 2ff5c1c2). Half:
/// more proofs until it fits; twice: more that fail.
constexpr double kStrideFactor = 6.0;
/// By which the stride grows with each plain step, so that it is what it was after ten (1.2^10 = 6, kStrideFactor).
/// Half of the fifth: after 19; twice: after 5.
constexpr double kStrideRecovery = 1.2;

/// The list is made for so many times the motion that is asked for, so that it is good for the next steps too. Half:
/// made twice as often; twice: twice as many pairs in it.
constexpr double kListReserve = 4.0;
/// m: at least so wide; some steps of a hand that goes 0.1 m/s at 1000 Hz. Half: slow hands make lists more often;
/// twice: more pairs in each.
constexpr double kListLeast = 0.3e-3;
/// Tries with smaller lists (by 0.3 each) where there are too many pairs: to 1/11. Half: plain steps sooner; twice:
/// lists too small to be of use.
constexpr int kListTries = 3;
/// Of a new list's reach: an old one is used until then (commit 95bc9f00). Half: shorter stretches of each; twice:
/// lists made up to twice as often.
constexpr double kListWorn = 0.25;

struct Sample {
  double s = 0.0;
  double distance = 0.0;
};

/// One motion of one pair.
class Advancement {
 public:
  Advancement(ProximityQuery& query, const PartMotion& a, const PartMotion& b, const MotionDemand& demand)
      : query_(query),
        a_(a),
        b_(b),
        until_(std::min(demand.until, 1.0)),
        clearance_(std::max(demand.clearance, kLeastClearance)),
        rate_(a.path_bound + b.path_bound),
        stride_(kFirstStride / std::max(rate_, kFirstStride)) {}

  MotionStop run() {
    MotionStop result;
    result.s = until_;
    Sample good;
    const double reach_of_list = query_.near().reachAt(a_.at(0.0).inverse() * b_.at(0.0));
    const bool listed = reach_of_list >= clearance_ + rate_ * until_;
    DistanceResult here = listed ? query_.distanceOfListed(a_.at(0.0), b_.at(0.0)) : at(0.0);
    result.began_colliding = began_colliding_ = here.colliding;
    while (here.colliding) {
      if (good.s >= until_ || queries_ >= kMostQueries) return result;
      good.s = std::min(until_, good.s + kStepWhileColliding / std::max(rate_, kStepWhileColliding));
      here = at(good.s);
    }
    good.distance = here.distance;
    clearance_ = std::min(clearance_, here.distance);
    while (good.s < until_ && good.distance < clearance_ + rate_ * (until_ - good.s)) {
      if (queries_ >= kMostQueries) return stoppedAt(good.s, at(good.s));
      const double plain = (good.distance - 0.5 * clearance_) / rate_;
      proven_ = 0.0;
      if (double stretch = 0.0; followList(good, plain, stretch)) {
        const ListedStop stop = sweep(good.s, good.s + stretch);
        if (stop.stopped) return stoppedBy(stop);
        good = {stop.s, stop.distance_at_least};
        continue;
      }
      if (proven_ == 0.0) stride_ = std::max(stride_, plain) * kStrideRecovery;
      const double s = std::min(until_, good.s + std::max(plain, proven_));
      here = at(s);
      if (violates(here)) return stopBetween(good, s, here);
      good = {s, here.distance};
    }
    result.distance_at_least = std::max(0.0, good.distance - rate_ * (until_ - good.s));
    return result;
  }

 private:
  /// Only as exact as the rest of the motion needs: farther than it can still go is far enough.
  DistanceResult at(double s) {
    ++queries_;
    return query_.distance(a_.at(s), b_.at(s), clearance_ + rate_ * (until_ - s) + kRounding);
  }

  ListedStop sweep(double from, double to) {
    ++queries_;
    stride_ *= kStrideRecovery;
    const ListedStop stop = sweepListed(query_.a(), query_.b(), query_.near(), a_, b_, {from, to, clearance_});
    query_.certifyApart(a_.at(stop.s), b_.at(stop.s), stop.distance_at_least);
    return stop;
  }

  /// How far the list is good for as it is; 0 where that is less than `worth`, or little of what a new one would be.
  double knownStretch(double from, double worth) const {
    const double rest = until_ - from;
    const NearPairs& near = query_.near();
    const double known = (near.reachAt(a_.at(from).inverse() * b_.at(from)) - clearance_) / rate_;
    const double anew = (near.likelyRadius() - clearance_) / rate_;
    return known >= rest || known >= std::max(worth, kListWorn * anew) ? std::min(rest, known) : 0.0;
  }

  /// How far the list of near pairs is good for from here, where it is made again if it does not reach `enough`; 0
  /// where there are too many for one that would be worth having.
  double listedStretch(double from, double enough, double worth) {
    const double rest = until_ - from;
    const Pose X_AB = a_.at(from).inverse() * b_.at(from);
    NearPairs& near = query_.near();
    if (const double known = knownStretch(from, std::min(enough, worth)); known > 0.0) return known;
    double radius = clearance_ + std::max(kListReserve * rate_ * enough, kListLeast);
    for (int tries = 0; tries < kListTries; ++tries) {
      radius = std::min(radius, near.likelyRadius());
      const double stretch = std::min(rest, (radius - clearance_ - kRounding) / rate_);
      if (stretch < std::min(enough, worth)) break;
      ++queries_;
      if (near.fill(query_.a(), query_.b(), X_AB, radius)) return stretch;
    }
    near.forgive();
    return 0.0;
  }

  /// What distance and speed allow in any direction is little along a surface. There as far as the list reaches, if it
  /// does to the end; else as far as can be proven of whole boxes (over a plane that is far); else as far as it
  /// reaches.
  bool followList(const Sample& good, double plain, double& stretch) {
    const double rest = until_ - good.s, worth = kLeastStride * plain;
    if (plain >= rest) return false;
    stretch = knownStretch(good.s, worth);
    if (stretch > 0.0) return true;
    const bool short_enough = clearance_ + rate_ * rest < query_.near().likelyRadius();
    if (short_enough || stride_ < worth || !provenStride(good)) {
      stretch = listedStretch(good.s, rest, worth);
      return stretch > 0.0;
    }
    return false;
  }

  /// Tries the stride; what it proves is left in proven_.
  bool provenStride(const Sample& good) {
    const double longer = std::min(until_ - good.s, stride_);
    ++queries_;
    const SweptPair sweep{a_.at(good.s),  a_.at(good.s + longer),
                          b_.at(good.s),  b_.at(good.s + longer),
                          rate_ * longer, (a_.bend_bound + b_.bend_bound) * longer * longer / 8.0};
    const bool is_proven = staysApart(query_.a(), query_.b(), sweep, 0.5 * clearance_);
    stride_ = is_proven ? longer * kStrideFactor : longer / kStrideFactor;
    proven_ = is_proven ? longer : 0.0;
    return is_proven;
  }

  bool violates(const DistanceResult& here) const { return here.colliding || here.distance < clearance_ - kRounding; }

  MotionStop stoppedAt(double s, const DistanceResult& nearest) const {
    MotionStop result;
    result.s = s;
    result.stopped = true;
    result.began_colliding = began_colliding_;
    result.distance_at_least = nearest.distance;
    result.nearest = nearest;
    return result;
  }

  MotionStop stoppedBy(const ListedStop& listed) const {
    MotionStop result;
    result.s = listed.s;
    result.stopped = true;
    result.began_colliding = began_colliding_;
    result.distance_at_least = listed.distance_at_least;
    DistanceResult& nearest = result.nearest;
    nearest.p_WA = listed.nearest.p;
    nearest.p_WB = listed.nearest.q;
    nearest.distance = glm::distance(nearest.p_WA, nearest.p_WB);
    nearest.nhat_BA_W = (nearest.p_WA - nearest.p_WB) / nearest.distance;
    nearest.triangle_A = listed.pair.a;
    nearest.triangle_B = listed.pair.b;
    return result;
  }

  /// The whole stretch is free; finds how far along it the clearance still holds: with the list, or by searches (regula
  /// falsi with halving).
  MotionStop stopBetween(Sample good, double bad, DistanceResult nearest) {
    if (listedStretch(good.s, bad - good.s, bad - good.s) >= bad - good.s) {
      const ListedStop stop = sweep(good.s, bad);
      if (stop.stopped) return stoppedBy(stop);
    }
    for (int i = 0; i < 40 && (bad - good.s) * rate_ > kStopAccuracy; ++i) {
      const double above = good.distance - clearance_, below = clearance_ - nearest.distance;
      const double share = i % 3 == 2 || above <= 0.0 ? 0.5 : std::clamp(above / (above + below), 0.05, 0.95);
      const double s = good.s + share * (bad - good.s);
      const DistanceResult here = at(s);
      if (violates(here)) {
        bad = s;
        nearest = here;
      } else {
        good = {s, here.distance};
      }
    }
    return stoppedAt(good.s, nearest);
  }

  ProximityQuery& query_;
  const PartMotion& a_;
  const PartMotion& b_;
  double until_;
  double clearance_;  ///< What is kept: what was asked or, if less, what it began with.
  double rate_;
  bool began_colliding_ = false;
  double proven_ = 0.0;
  double stride_;  ///< Of s: the longer step that is tried next.
  int queries_ = 0;
};

}  // namespace

PartMotion straightMotion(const Pose& X_WStart, const Pose& X_WEnd, const MeshCollider& part) {
  const double angle = glm::length(difference(X_WEnd, X_WStart).angular);
  const double bend = angle * angle * (glm::length(part.center()) + part.radius());
  return {X_WStart, X_WEnd, pathBound(X_WStart, X_WEnd, part.center(), part.radius()), bend, {}};
}

PartMotion standingStill(const Pose& X_WP) {
  return {X_WP, X_WP, 0.0, 0.0, {}};
}

MotionStop advance(ProximityQuery& query, const PartMotion& a, const PartMotion& b, const MotionDemand& demand) {
  return Advancement(query, a, b, demand).run();
}

}  // namespace hapticell::collision
