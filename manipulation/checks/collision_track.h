// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "manipulation/checks/path_finding.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

/// Everything that could meet, as the held entity knows it: its own parts, what hangs on it, and what stands. A motion
/// is looked at whole, so every pair blocks, those that the user passes through too. `held` must outlive it.
struct MeetingBodies {
  const HeldEntity& held;
  std::vector<MotionPair> pairs;

  explicit MeetingBodies(const HeldEntity& of);
  FreeMotion motionOf(std::vector<MotionPair> some) const;
  /// Names of the two parts of a pair: "robot/link_3".
  std::string first(std::uint32_t pair) const;
  std::string second(std::uint32_t pair) const;
};

/// Follows each pair through the motion and keeps an interval for each time that it meets. Times in s, distances in m,
/// points in the world. `bodies` and `manipulator` must outlive it. One thread.
class CollisionTrack {
 public:
  /// `look`: clearances above it are not measured.
  CollisionTrack(const MeetingBodies& bodies, const Manipulator& manipulator, double look);

  /// The first frame: pairs that touch there are kept apart from findings.
  void start(const EntityConfiguration& at, double t, PathCheckResult& result);
  /// From one frame to the next, looked at continuously.
  void step(const EntityConfiguration& from, const EntityConfiguration& to, double t0, double t1,
            PathCheckResult& result);
  /// What still meets ends here.
  void finish(PathCheckResult& result);

 private:
  PathFinding finding(std::uint32_t pair, double t) const;
  void note(const MotionAnswer& answer, std::uint32_t pair, double t0, double t1);
  void noteOthers(const EntityConfiguration& from, const EntityConfiguration& to, std::uint32_t first, double t0,
                  double t1);
  void close(std::uint32_t pair, PathCheckResult& result);
  void look(double t, PathCheckResult& result);

  const MeetingBodies& bodies_;
  const Manipulator& manipulator_;
  const double look_;
  FreeMotion motion_;
  std::vector<std::optional<PathFinding>> open_;
  std::vector<std::uint32_t> at_start_;
  std::vector<FreeMotion::PairDistance> near_;
};

}  // namespace hapticell::manipulation
