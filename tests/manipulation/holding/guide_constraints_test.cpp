// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/guide_constraints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace hapticell::manipulation {
namespace {

using haptic::Constraint;
using haptic::ConstraintKind;
using workcell::Guide;
using workcell::GuideKind;

const Pose kGuide{dvec3(0.3, -0.2, 0.5), quaternionFromRotationVector({0.4, -0.9, 0.3})};
const Pose kPlaced{dvec3(0.55, 0.1, 0.4), quaternionFromRotationVector({-0.2, 0.6, 1.0})};

dvec3 axisOf(const Pose& X_WG) {
  return X_WG.rotate(dvec3(0, 0, 1));
}

Guide guideOf(GuideKind kind) {
  Guide guide;
  guide.kind = kind;
  guide.X_WG = kGuide;
  return guide;
}

haptic::Vector6 between(const Pose& X_WM, const Pose& X_WTo) {
  const Twist t = difference(X_WTo, X_WM);
  return {t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
}

/// The largest of what the equalities, made at one pose, say of another.
double offAt(const Guide& guide, const Pose& X_WM, const Pose& X_WTo) {
  double off = 0.0;
  for (const Constraint& row : guideConstraints(guide, X_WM, kPlaced, 0)) {
    if (row.kind == ConstraintKind::kEquality)
      off = std::max(off, std::abs(haptic::evaluate(row, between(X_WM, X_WTo))));
  }
  return off;
}

/// The placed frame turned about the guide's axis.
Pose turned(double angle) {
  const dquat q = quaternionFromRotationVector(angle * axisOf(kGuide));
  return {kGuide.p + q * (kPlaced.p - kGuide.p), glm::normalize(q * kPlaced.q)};
}

TEST(GuideConstraints, AHingeIsExactAllTheWayRound) {
  const Guide guide = guideOf(GuideKind::kHinge);
  for (const double from : {0.0, 1.0, -2.5}) {
    for (const double to : {0.1, 0.9, 2.0, 3.1}) EXPECT_LT(offAt(guide, turned(from), turned(from + to)), 1e-12);
  }
  Pose aside = turned(0.7);
  aside.p += 0.003 * axisOf(kGuide);
  EXPECT_NEAR(offAt(guide, turned(0.0), aside), 0.003, 1e-9) << "along its axis it does not go";
}

TEST(GuideConstraints, ACircleTellsTheDistanceToIt) {
  Guide guide = guideOf(GuideKind::kCircle);
  guide.radius = 0.08;
  const auto at = [&](double radius, double angle) {
    return Pose::translation(kGuide * dvec3(radius * std::cos(angle), radius * std::sin(angle), 0.0));
  };
  for (const double angle : {0.2, 2.0, 4.0}) EXPECT_LT(offAt(guide, at(0.08, 0.0), at(0.08, angle)), 1e-12);
  // (r^2 - R^2) / 2R
  EXPECT_NEAR(offAt(guide, at(0.08, 0.0), at(0.09, 3.0)), (0.09 * 0.09 - 0.08 * 0.08) / 0.16, 1e-12);
}

TEST(GuideConstraints, StopsAreWhereTheyAreTold) {
  for (const GuideKind kind : {GuideKind::kHinge, GuideKind::kSlider}) {
    Guide guide = guideOf(kind);
    guide.lower = -0.05;
    guide.upper = 0.11;
    guide.detents = {0.03};
    const auto at = [&](double s) {
      return kind == GuideKind::kHinge ? turned(s) : Pose{kPlaced.p + s * axisOf(kGuide), kPlaced.q};
    };
    // What is made at one place holds at others: free, at a stop, beyond one.
    for (const double from : {0.0, 0.08}) {
      double lower = 0.0, upper = 0.0, pull = 1.0;
      const auto look = [&](double to) {
        lower = upper = 1.0;
        for (const Constraint& row : guideConstraints(guide, at(from), kPlaced, 0)) {
          const double value = haptic::evaluate(row, between(at(from), at(to)));
          if (row.kind == ConstraintKind::kPull) pull = value;
          if (row.kind != ConstraintKind::kInequality) continue;
          (lower == 1.0 ? lower : upper) = value;
        }
      };
      look(0.0);
      EXPECT_GT(lower, 0.0);
      EXPECT_GT(upper, 0.0);
      look(-0.05);
      EXPECT_NEAR(lower, 0.0, 1e-12);
      look(-0.06);
      EXPECT_LT(lower, -1e-3);
      look(0.11);
      EXPECT_NEAR(upper, 0.0, 1e-12);
      look(0.12);
      EXPECT_LT(upper, -1e-3);
      look(0.03);
      EXPECT_NEAR(pull, 0.0, 1e-12) << "it snaps in";
    }
  }
}

TEST(GuideConstraints, AScrewAdvancesByItsPitch) {
  Guide guide = guideOf(GuideKind::kScrew);
  guide.pitch = 0.02;
  const Pose start{kGuide.p, kPlaced.q};
  const auto along = [&](double angle) {
    return Pose{start.p + guide.pitch * angle / (2.0 * std::numbers::pi) * axisOf(kGuide),
                glm::normalize(quaternionFromRotationVector(angle * axisOf(kGuide)) * start.q)};
  };
  const auto off = [&](const Pose& X_WTo) {
    double most = 0.0;
    for (const Constraint& row : guideConstraints(guide, start, start, 0))
      most = std::max(most, std::abs(haptic::evaluate(row, between(start, X_WTo))));
    return most;
  };
  for (const double angle : {0.3, -1.2, 2.5}) EXPECT_LT(off(along(angle)), 1e-12) << angle;
  EXPECT_NEAR(off({along(1.0).p, start.q}), 0.02 / (2.0 * std::numbers::pi), 1e-12) << "it does not go without turning";
}

TEST(GuideConstraints, NumberTheirGroupsFromTheFirstOne) {
  for (const GuideKind kind : {GuideKind::kPoint, GuideKind::kLine, GuideKind::kPlane, GuideKind::kHinge,
                               GuideKind::kSlider, GuideKind::kScrew}) {
    std::set<std::uint32_t> groups;
    std::set<std::uint64_t> ids;
    const auto rows = guideConstraints(guideOf(kind), kPlaced, kPlaced, 7);
    ASSERT_FALSE(rows.empty());
    for (const Constraint& row : rows) {
      groups.insert(row.group);
      ids.insert(row.id);
    }
    EXPECT_EQ(groups.size(), rows.size()) << "each holds";
    EXPECT_EQ(ids.size(), rows.size());
    EXPECT_EQ(*groups.begin(), 7U);
  }
  EXPECT_TRUE(guideConstraints(guideOf(GuideKind::kSurface), kPlaced, kPlaced, 7).empty()) << "it needs a query";
}

TEST(GuidedTurn, IsThatOfTheDoorWhereverTheHandLeadsIt) {
  const Guide guide = guideOf(GuideKind::kHinge);
  for (const double angle : {0.0, 0.8, -2.0}) {
    const auto turn = guidedTurn(guide, turned(angle), kPlaced);
    ASSERT_TRUE(turn);
    EXPECT_LT(glm::length(difference({dvec3(0.0), turn->q_WM}, {dvec3(0.0), turned(angle).q}).angular), 1e-12);
    // Its rate, by a difference: along the circle, away from the axis and along it.
    for (const dvec3& step : {turned(angle + 1e-6).p - turned(angle).p, dvec3(1e-6, 0, 0), dvec3(0, 2e-6, -1e-6)}) {
      const Pose moved{turned(angle).p + step, turned(angle).q};
      const dvec3 by =
          difference({dvec3(0.0), guidedTurn(guide, moved, kPlaced)->q_WM}, {dvec3(0.0), turn->q_WM}).angular;
      EXPECT_LT(glm::length(turn->rate * step - by), 1e-10);
    }
  }
}

TEST(GuidedTurn, IsGivenOnlyWhereThePlaceTellsTheTurn) {
  Guide lock = guideOf(GuideKind::kLock);
  lock.locked = {true, false, false, true, true, false};
  EXPECT_FALSE(guidedTurn(lock, kPlaced, kPlaced)) << "one turn is free";
  lock.locked[5] = true;
  EXPECT_EQ(guidedTurn(lock, turned(1.0), kPlaced)->q_WM, kPlaced.q);
  EXPECT_EQ(guidedTurn(guideOf(GuideKind::kSlider), turned(1.0), kPlaced)->rate, dmat3(0.0));
  const Pose on_axis{kGuide * dvec3(0.0, 0.0, 0.2), kPlaced.q};
  EXPECT_FALSE(guidedTurn(guideOf(GuideKind::kHinge), on_axis, on_axis)) << "held on the axis the wrist turns it";
  for (const GuideKind kind : {GuideKind::kPoint, GuideKind::kLine, GuideKind::kScrew, GuideKind::kTube})
    EXPECT_FALSE(guidedTurn(guideOf(kind), kPlaced, kPlaced));
}

TEST(GuidedTurn, SlavedRowsSayTheSameOfTheTranslationAlone) {
  const dmat3 rate(dvec3(0.3, -1.2, 0.8), dvec3(2.0, 0.1, -0.4), dvec3(-0.7, 0.6, 1.5));
  Constraint row;
  row.gap = 0.01;
  for (std::size_t i = 0; i < 6; ++i) row.gradient[i] = std::sin(1.0 + 2.3 * static_cast<double>(i));
  for (std::size_t i = 0; i < 6; ++i) row.trim_gradient[i] = std::cos(1.7 * static_cast<double>(i));
  for (std::size_t i = 0; i < 21; ++i) row.curvature[i] = 5.0 * std::sin(0.4 + 1.9 * static_cast<double>(i));
  Constraint slaved = row;
  slaveTurning(rate, slaved);
  for (const dvec3& v : {dvec3(0.02, -0.01, 0.03), dvec3(-0.1, 0.2, 0.05)}) {
    const dvec3 w = rate * v;
    EXPECT_NEAR(haptic::evaluate(slaved, {v.x, v.y, v.z, 0.4, -0.3, 0.2}),
                haptic::evaluate(row, {v.x, v.y, v.z, w.x, w.y, w.z}), 1e-12);
    const haptic::Vector6 xi{v.x, v.y, v.z, w.x, w.y, w.z};
    double trim = 0.0, slaved_trim = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      trim += row.trim_gradient[i] * xi[i];
      slaved_trim += slaved.trim_gradient[i] * xi[i];
    }
    EXPECT_NEAR(slaved_trim, trim, 1e-12);
  }
}

}  // namespace
}  // namespace hapticell::manipulation
