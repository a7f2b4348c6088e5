// SPDX-License-Identifier: Apache-2.0
// A mannequin whose feet may step: straight ways, round to a side, and random ways through where it stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "manipulation/manipulators/mannequin_manipulator.h"
#include "manipulation/manipulators/mannequin_steps.h"
#include "mannequin/shape/figure_model.h"
#include "mannequin/posture/limb_inverse.h"
#include "mannequin/posture/support_polygon.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

using Hands = MannequinManipulator::Hands;
using mannequin::Side;

constexpr double kTick = 0.006;    ///< m that the hand is drawn a tick.
constexpr int kToComeAfter = 400;  ///< Ticks that the figure has to come after.

/// One that is drawn by a hand, and what is watched about it.
class Walker {
 public:
  explicit Walker(Hands hands) : entity_(worker()), hand_(manipulatorOf(hands)) {
    at_ = {entity_.X_WE, entity_.joints()};
    wanted_ = hand_.movedFrame(at_);
    taken_ = feet_ = feetNow();
  }

  /// The moved frame is wanted at `p_W` from now on.
  void tick(const dvec3& p_W) {
    wanted_.p = p_W;
    at_ = hand_.propose(at_, wanted_, 1.0);
    const mannequin::FigurePose pose = poseNow();
    const FootPlaces before = std::exchange(feet_, feetNow());
    const auto support = mannequin::supportPolygon(
        *entity_.figure(), {pose[mannequin::Segment::kLeftFoot], pose[mannequin::Segment::kRightFoot]});
    least_margin = std::min(least_margin, support.margin(glm::dvec2(mannequin::centerOfMass(*entity_.figure(), pose))));
    for (std::size_t k = 0; k < 2; ++k) {
      const double height = feet_[k].p.z - taken_[k].p.z;
      const dvec3 way = feet_[k].p - before[k].p;
      const bool stood = std::max(height, before[k].p.z - taken_[k].p.z) < 1e-4;
      if (stood) glided = std::max(glided, std::hypot(way.x, way.y));
      highest = std::max(highest, height);
      lowest = std::min(lowest, height);
    }
    both_lifted = both_lifted || std::min(feet_[0].p.z - taken_[0].p.z, feet_[1].p.z - taken_[1].p.z) > 1e-3;
    nearest = std::min(nearest, std::hypot(feet_[0].p.x - feet_[1].p.x, feet_[0].p.y - feet_[1].p.y));
  }
  /// Straight to there, then held.
  void drawTo(const dvec3& p_W) {
    const dvec3 from = wanted_.p;
    const int ticks = std::max(1, static_cast<int>(glm::length(p_W - from) / kTick));
    for (int i = 1; i <= ticks + kToComeAfter; ++i)
      tick(glm::mix(from, p_W, std::min(1.0, i / static_cast<double>(ticks))));
  }

  const Pose& wanted() const { return wanted_; }
  const FootPlaces& taken() const { return taken_; }
  dvec3 gone(std::size_t foot) const { return feet_[foot].p - taken_[foot].p; }
  double turned() const { return turnedFeet(taken_, feet_); }
  dvec3 pelvis() const { return poseNow()[mannequin::Segment::kPelvis].p_WS; }
  /// m, a radian counting like 0.1.
  double leftOut() const {
    const Twist off = difference(hand_.movedFrame(at_), wanted_);
    return std::max(glm::length(off.linear), 0.1 * glm::length(off.angular));
  }

  double highest = 0.0, lowest = 0.0;  ///< m of any foot above where it stood.
  bool both_lifted = false;
  double nearest = 1e9;       ///< m between the feet, along the floor.
  double least_margin = 1e9;  ///< m of the centre of mass between the sole that stands and where the other one lands.
  double glided = 0.0;        ///< m a tick that a foot went along the floor without being lifted.

 private:
  static workcell::Entity worker() {
    Diagnostics diagnostics;
    workcell::Entity entity = *workcell::EntityLoader(".").load("mannequin:male:50", 1.0, diagnostics);
    const auto model =
        mannequin::toModel(*entity.figure(), *mannequin::libraryPosture(*entity.figure(), "both_hands_forward"));
    entity.X_WE = model.X_WE;
    entity.setJoints(model.joints);
    return entity;
  }
  MannequinManipulator manipulatorOf(Hands hands) const {
    MannequinManipulator::Locks locks;
    locks.may_step = true;
    return {entity_.figure(), entity_.robot(), hands, locks, {entity_.X_WE, entity_.joints()}, {}};
  }
  mannequin::FigurePose poseNow() const {
    return mannequin::forwardKinematics(*entity_.figure(),
                                        mannequin::toPosture(*entity_.figure(), {at_.X_WE, at_.joints}));
  }
  FootPlaces feetNow() const {
    const mannequin::FigurePose pose = poseNow();
    return {mannequin::footPose(pose, Side::kLeft), mannequin::footPose(pose, Side::kRight)};
  }

  workcell::Entity entity_;
  MannequinManipulator hand_;
  EntityConfiguration at_;
  Pose wanted_;
  FootPlaces taken_, feet_;
};

void expectWalked(const Walker& walker) {
  EXPECT_GT(walker.highest, 0.03) << "it lifts its feet";
  EXPECT_GT(walker.lowest, -1e-3);
  EXPECT_FALSE(walker.both_lifted);
  EXPECT_GT(walker.nearest, 0.06) << "no foot on the other";
  EXPECT_LT(walker.glided, 3e-4);
}

TEST(MannequinWalk, OneFootAfterTheOtherToWhereTheHandIsReached) {
  for (const dvec3& way : {dvec3(1.44, 0.0, 0.0), dvec3(0.0, 1.2, 0.0), dvec3(0.0, -1.2, 0.0), dvec3(1.0, 0.6, 0.0)}) {
    Walker walker(Hands::kRight);
    walker.drawTo(walker.wanted().p + way);  // Far beyond the reach of standing feet.
    EXPECT_LT(walker.leftOut(), 5e-3);
    expectWalked(walker);
    EXPECT_GT(walker.least_margin, -2e-3) << "between the foot that stands and where the other one lands";
    for (const std::size_t foot : {0u, 1u}) {
      EXPECT_GT(glm::dot(walker.gone(foot), glm::normalize(way)), 0.2 * glm::length(way));
      EXPECT_LT(std::abs(walker.gone(foot).z), 1e-3) << "on the floor in the end";
    }
  }
}

TEST(MannequinWalk, RoundToWhatTheHandWorksAt) {
  for (const double side : {1.0, -1.0}) {
    Walker walker(Hands::kRight);
    const dvec3 middle = 0.5 * (walker.taken()[0].p + walker.taken()[1].p), arm = walker.wanted().p - middle;
    // At arm's length from straight ahead round to the side and a little behind.
    for (int i = 1; i <= 600; ++i) {
      const double angle = side * 1.9 * std::min(1.0, i / 300.0);
      walker.tick(middle + glm::angleAxis(angle, dvec3(0.0, 0.0, 1.0)) * arm);
    }
    EXPECT_LT(walker.leftOut(), 5e-3) << side;
    EXPECT_GT(side * walker.turned(), 0.6) << "the feet came round";
    expectWalked(walker);
    EXPECT_GT(walker.least_margin, -2e-3);
    for (const std::size_t foot : {0u, 1u}) EXPECT_LT(std::abs(walker.gone(foot).z), 1e-3) << "both stand in the end";
  }
}

/// Three ways, each from where the hand is through the pelvis and beyond, at some height; then to where it works well.
/// Returns how many of the three ended short of their end.
int drawThroughTheBody(std::uint64_t seed, Walker& walker) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const double floor = walker.taken()[0].p.z;
  int ended_short = 0;
  for (int leg = 0; leg < 3; ++leg) {
    const dvec3 pelvis = walker.pelvis();
    dvec3 way = pelvis - walker.wanted().p;
    way.z = 0.0;
    way = glm::normalize(way);
    const double beyond = between(0.2, 1.2), beside = between(-0.4, 0.4);
    dvec3 goal = pelvis + beyond * way + beside * dvec3(-way.y, way.x, 0.0);
    goal.z = floor + between(0.75, 1.35);
    walker.drawTo(goal);
    ended_short += walker.leftOut() > 5e-3 ? 1 : 0;
  }
  const dvec3 pelvis = walker.pelvis();
  walker.drawTo({pelvis.x + 0.45, pelvis.y, floor + 1.1});
  EXPECT_LT(walker.leftOut(), 5e-3) << "seed " << seed << ": it came to a stand";
  return ended_short;
}

/// How many of three ways a figure ended short, for eight figures drawn by each of `ways`.
int endedShort(std::initializer_list<Hands> ways) {
  int ended_short = 0;
  for (const Hands hands : ways) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      Walker walker(hands);
      ended_short += drawThroughTheBody(seed, walker);
      expectWalked(walker);
    }
  }
  return ended_short;
}

TEST(MannequinWalk, ThroughWhereItStandsItMakesWayAndNoFootGlides) {
  EXPECT_LE(endedShort({Hands::kRight, Hands::kLeft}), 1) << "of 48 ways";
}

TEST(MannequinWalk, WithBothHandsItMakesWayAsWell) {
  EXPECT_LE(endedShort({Hands::kBoth}), 1) << "of 24 ways of what both hold";
  EXPECT_LE(endedShort({Hands::kBothApart}), 1) << "of 24 ways of hands that go apart";
}

TEST(StoodOn, AnAnkleAHairBeyondItsLimitDoesNotHoldTheBodyBack) {
  const mannequin::Figure figure = *mannequin::makeFigure({mannequin::Sex::kMale, 1.755});
  const mannequin::Posture start = *mannequin::libraryPosture(figure, "standing");
  const mannequin::FigurePose pose = mannequin::forwardKinematics(figure, start);
  const FootPlaces feet{mannequin::footPose(pose, Side::kLeft), mannequin::footPose(pose, Side::kRight)};
  const auto beyond = [&](double down) {
    const mannequin::SegmentPlace pelvis{glm::mat3_cast(start.X_WR.q), start.X_WR.p - dvec3(0.0, 0.0, down)};
    const auto leg = mannequin::legInverse(figure, Side::kLeft, pelvis, {glm::mat3_cast(feet[0].q), feet[0].p});
    return leg.violation;
  };
  // As low as the ankles let it, and 0.1 um lower.
  double reached = 0.0, too_low = 0.4;
  ASSERT_EQ(beyond(reached), 0.0);
  ASSERT_GT(beyond(too_low), 0.0);
  while (too_low - reached > 1e-9)
    (beyond(std::midpoint(reached, too_low)) > 0.0 ? too_low : reached) = std::midpoint(reached, too_low);
  mannequin::Posture there = start;
  there.X_WR.p.z -= too_low + 1e-7;
  const mannequin::Posture stood = stoodOn(figure, start, there, feet);
  EXPECT_NEAR(stood.X_WR.p.z, there.X_WR.p.z, 1e-6) << "not a part of the way only";
  EXPECT_LE(beyond(start.X_WR.p.z - stood.X_WR.p.z), 0.0);
  const mannequin::FigurePose stands = mannequin::forwardKinematics(figure, stood);
  for (const Side side : {Side::kLeft, Side::kRight})
    EXPECT_LT(glm::distance(mannequin::footPose(stands, side).p, feet[static_cast<std::size_t>(side)].p), 1e-12);
}

}  // namespace
}  // namespace hapticell::manipulation
