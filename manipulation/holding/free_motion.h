// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/queries/motion_check.h"
#include "collision/queries/placed_bounds.h"
#include "collision/queries/proximity_query.h"
#include "manipulation/manipulators/manipulator.h"

namespace hapticell::manipulation {

/// A moved part against an obstacle at rest, or against another moved part (of the same robot).
struct MotionPair {
  std::uint32_t part = 0;
  std::uint32_t obstacle = 0;
  bool blocks = true;   ///< False: distances are measured, but motion is not stopped.
  int other_part = -1;  ///< Not -1: the part that it is checked against; `obstacle` is then unused.
};

/// Something at rest that the moved parts must not enter.
struct Obstacle {
  std::shared_ptr<const collision::MeshCollider> collider;
  Pose X_WO;
};

/// Result of a motion check.
struct MotionAnswer {
  double s = 1.0;                     ///< Free from 0 to here, checked continuously.
  bool blocked = false;               ///< Something blocks the motion at `s`.
  std::uint32_t pair = 0;             ///< Index of the pair that blocks.
  collision::DistanceResult contact;  ///< Its nearest points there, A on the moved part.
};

/// The exact check of the motion from one accepted configuration to the next, by conservative advancement (Mirtich
/// 1996; Zhang, Lee, Kim 2006): a step never exceeds the measured distance divided by the speed bound of the part.
///
/// Keeps a lower bound of every pair's distance, reduced by motion, so that a pair is measured again only when it could
/// have come near. What is far is not even looked at: a list of the near pairs is kept, and rebuilt when the far ones
/// could have come near, so that a step costs what is near. Pairs that touch or intersect at reset() are `soft`: they
/// do not block until they have come apart once, because otherwise nothing could move. The caller must ensure that they
/// get no deeper. One thread.
class FreeMotion {
 public:
  /// m left between surfaces when a motion is blocked: a quarter of kSkin, five times kLeastClearance. Half: more
  /// queries to slide along; twice: half of the skin is used up.
  static constexpr double kStandOff = 5e-6;
  /// m that frees a pair that only touches; twice kStandOff, half of kSkin; see guard(). Half: it stays soft; twice: it
  /// may be entered by 0.02 mm.
  static constexpr double kGuard = 1e-5;

  FreeMotion(std::vector<std::shared_ptr<const collision::MeshCollider>> parts, std::vector<Obstacle> obstacles,
             std::vector<MotionPair> pairs);

  /// Restarts at this configuration.
  void reset(const Manipulator& manipulator, const EntityConfiguration& at);

  /// Gives the direction in which a soft pair that only touches comes free. If a small shift along the unit vector
  /// `nhat_W` frees the pair, it blocks from now on as if the obstacle were moved back by that shift, until the pair
  /// has come apart.
  void guard(std::uint32_t pair, const dvec3& nhat_W);

  /// Moves an obstacle to X_WO; nothing else moves. New contacts block from then on.
  void moveObstacle(std::uint32_t obstacle, const Pose& X_WO);

  /// Moves along manipulator.between(from, to, .) as far as it is free; `from` must be the end of the last call.
  MotionAnswer advance(const Manipulator& manipulator, const EntityConfiguration& from, const EntityConfiguration& to);

  /// Exact present distances of all pairs nearer than `limit`, in the order of the pairs.
  struct PairDistance {
    std::uint32_t pair = 0;
    collision::DistanceResult result;
  };
  void distances(double limit, std::vector<PairDistance>& near) { distances(limit, 0, near); }
  /// The same for the pairs from `first` on.
  void distances(double limit, std::uint32_t first, std::vector<PairDistance>& near);

  const std::vector<std::shared_ptr<const collision::MeshCollider>>& parts() const { return parts_; }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  const std::vector<MotionPair>& pairs() const { return pairs_; }
  const Obstacle& obstacle(std::uint32_t index) const { return obstacles_[index]; }
  bool isSoft(std::uint32_t pair) const { return states_[pair].soft; }
  bool anySoft() const;
  const std::vector<Pose>& partPoses() const { return X_WP_; }
  const std::vector<PartSphere>& spheres() const { return spheres_; }

 private:
  struct PairState {
    collision::ProximityQuery query;
    double clearance = 0.0;  ///< Lower bound of the distance, m: now; of a far pair less its part's way since.
    double way = 0.0;        ///< Of a far pair: that of its part when it became one.
    double bound = 0.0;      ///< Scratch: how far the two may come together along the motion,
    double reached = 0.0;    ///< and s where the clearance was last measured.
    bool near = true;
    bool soft = false;
    dvec3 stand_back_W{0.0};  ///< Shift of the obstacle, for blocking only; zero if the pair is not guarded.
    bool guarded() const { return stand_back_W != dvec3(0.0); }
  };
  struct Motion {
    const Manipulator& manipulator;
    const EntityConfiguration& from;
    const EntityConfiguration& to;
    double turned;
  };

  collision::DistanceResult measure(std::uint32_t pair, const Pose& X_WP, double limit);
  Pose standingPose(std::uint32_t pair) const;
  Pose obstaclePose(std::uint32_t pair) const;
  double boundsGap(std::uint32_t pair) const;
  void placeParts();
  void listNear(double least);
  bool isLookedAt(std::uint32_t pair) const;
  void advancePair(const Motion& motion, std::uint32_t pair, MotionAnswer& answer);
  Pose partPoseAt(const Motion& motion, std::uint32_t part, double s);
  void boundPairs(const Motion& motion);

  std::vector<std::shared_ptr<const collision::MeshCollider>> parts_;
  std::vector<Obstacle> obstacles_;
  std::vector<MotionPair> pairs_;
  std::vector<PairState> states_;
  std::vector<PartSphere> spheres_;
  std::vector<Pose> X_WP_;  ///< At the accepted configuration.
  std::vector<double> bounds_;
  std::vector<std::uint32_t> own_;               ///< Indices of the pairs of two parts,
  std::vector<Manipulator::OwnPair> own_parts_;  ///< and their parts.
  std::vector<double> own_bounds_;               ///< Scratch: one per own pair.
  std::vector<std::uint32_t> near_;              ///< Pairs that are examined, in order; those of two parts always.
  double far_clearance_ = 0.0;                   ///< m: no other pair is nearer than this.
  std::vector<double> way_;                      ///< m: no point of the part has moved farther than this in all.
  std::vector<collision::PlacedBounds> part_bounds_, obstacle_bounds_;
  std::vector<std::vector<std::uint32_t>> pairs_of_;  ///< The pairs of each obstacle.
  EntityConfiguration at_s_;                          ///< Scratch: at the last s asked for.
  double scratch_s_ = -1.0;
};

}  // namespace hapticell::manipulation
