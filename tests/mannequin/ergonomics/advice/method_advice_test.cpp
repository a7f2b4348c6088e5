// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/method_advice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "mannequin/ergonomics/advice/better_place.h"
#include "mannequin/ergonomics/advice/posture_advice.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Figure;
using mannequin::Posture;
using mannequin::Side;

Figure woman() {
  return *mannequin::makeFigure(
      {mannequin::Sex::kFemale, *mannequin::statureOfPercentile(mannequin::Sex::kFemale, 50)});
}

WorkTask often() {
  WorkTask task;
  task.load_kg = {1.0, 1.0};
  task.repetitions_per_min = 3.0;
  task.is_static = true;
  task.grip = Grip::kGood;
  task.duration_h = 1.0;
  return task;
}

PostureScores scoresOf(const Figure& figure, const Posture& posture) {
  return scorePosture(figure, posture, mannequin::forwardKinematics(figure, posture), often());
}

/// The posture with the changes in it, by the fields' names of `ergonomics en1005 --input`.
ZonePosture with(ZonePosture posture, const std::vector<FieldChange>& changes) {
  const std::map<std::string_view, double MeasuredPosture::*> angles{
      {"trunk_flexion", &MeasuredPosture::trunk_flexion},
      {"trunk_twist", &MeasuredPosture::trunk_twist},
      {"trunk_side_bend", &MeasuredPosture::trunk_side_bend},
      {"upper_arm_flexion", &MeasuredPosture::upper_arm_flexion},
      {"upper_arm_abduction", &MeasuredPosture::upper_arm_abduction},
      {"shoulder_raised_deg", &MeasuredPosture::girdle_elevation}};
  for (const FieldChange& change : changes) {
    if (const auto angle = angles.find(change.field); angle != angles.end()) {
      EXPECT_NEAR(posture.measured.*angle->second, change.from, 1e-12);
      posture.measured.*angle->second = change.to;
      if (change.field.starts_with("upper_arm")) posture.measured.upper_arm_elevation.reset();
    } else if (change.field == "gaze_below_horizontal") {
      posture.gaze_below_horizontal = change.to;
    } else if (change.field == "head_inclination") {
      posture.head_inclination = change.to;
    } else if (change.field == "trunk_supported") {
      posture.use.trunk_supported = change.to > 0.5;
    } else if (change.field == "arm_supported") {
      posture.use.arm_supported = change.to > 0.5;
    } else {
      ADD_FAILURE() << change.field;
    }
  }
  return posture;
}

int levelOf(PostureMethod method, const ZonePosture& posture) {
  return levelOf((method == PostureMethod::kEn1005
                      ? en1005(posture.measured, posture.gaze_below_horizontal, posture.use)
                      : iso11226(posture.measured, posture.head_inclination, posture.use))
                     .worst);
}

/// Each angle a fifth of a degree less far.
std::vector<FieldChange> lessFar(std::vector<FieldChange> changes) {
  for (FieldChange& change : changes) {
    if (!change.is_flag)
      change.to += std::copysign(std::min(0.2, std::abs(change.from - change.to)), change.from - change.to);
  }
  return changes;
}

TEST(MethodAdvice, ZonesComeDownByTheNearestAnglesOfTheirWorstParts) {
  const Figure figure = woman();
  int lowered = 0;
  for (const auto& library : mannequin::postureLibrary()) {
    const PostureScores scores = scoresOf(figure, *mannequin::libraryPosture(figure, library.name));
    for (const PostureMethod method : {PostureMethod::kEn1005, PostureMethod::kIso11226}) {
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const ZonePosture posture = zonePosture(scores, side, often());
        const MethodAdvice advice = advise(scores, method, side, often());
        ASSERT_EQ(advice.now.level, levelOf(method, posture));
        if (advice.now.level == 1) {
          EXPECT_TRUE(advice.drivers.empty() && !advice.next) << library.name;
          continue;
        }
        EXPECT_FALSE(advice.drivers.empty()) << library.name << nameOf(method);
        for (const MethodDriver& driver : advice.drivers)
          EXPECT_EQ(levelOf(method, with(posture, driver.changes)), driver.level) << driver.part;
        ASSERT_TRUE(advice.next) << library.name << ", " << nameOf(method);
        EXPECT_LT(advice.next->score.level, advice.now.level);
        EXPECT_EQ(levelOf(method, with(posture, advice.next->changes)), advice.next->score.level);
        if (std::none_of(advice.next->changes.begin(), advice.next->changes.end(), [](auto& c) { return c.is_flag; })) {
          ZonePosture letter = posture;
          letter.use.measured = false;
          EXPECT_EQ(levelOf(method, with(letter, lessFar(advice.next->changes))), levelOf(method, letter))
              << library.name << ", " << nameOf(method) << ": there is a nearer one";
        }
        ++lowered;
      }
    }
  }
  EXPECT_GT(lowered, 20);
}

TEST(MethodAdvice, AnArmOffBothWaysComesDownAlongOneOfThem) {
  ZonePosture posture;
  posture.measured.upper_arm_flexion = 50.0;
  posture.measured.upper_arm_abduction = 50.0;
  posture.gaze_below_horizontal = 10.0;
  const MethodAdvice advice = adviseZones(PostureMethod::kEn1005, posture);
  EXPECT_EQ(advice.now.level, 3);
  ASSERT_TRUE(advice.next);
  ASSERT_EQ(advice.next->changes.size(), 1u);
  // The arm's elevation by its direction: 50 deg out of the sagittal plane, and in it the angle that was found.
  const double forward = advice.next->changes[0].to * std::numbers::pi / 180.0, out = 50.0 * std::numbers::pi / 180.0;
  const dvec3 arm(std::cos(out) * std::sin(forward), std::sin(out), -std::cos(out) * std::cos(forward));
  EXPECT_NEAR(std::acos(-arm.z) * 180.0 / std::numbers::pi, 60.0, 0.1);
  posture.measured.upper_arm_flexion = posture.measured.upper_arm_abduction = 80.0;
  const MethodAdvice both = adviseZones(PostureMethod::kEn1005, posture);
  ASSERT_TRUE(both.next);
  EXPECT_EQ(both.next->changes.size(), 2u) << "neither way alone is enough";
}

TEST(MethodAdvice, SeveralWorstPartsAllHaveToChange) {
  ZonePosture posture;
  posture.measured.trunk_flexion = 70.0;
  posture.measured.trunk_twist = -30.0;
  posture.use.movements_per_min = 5.0;
  posture.gaze_below_horizontal = -10.0;
  const MethodAdvice advice = adviseZones(PostureMethod::kEn1005, posture);
  EXPECT_EQ(advice.drivers.size(), 3u);
  for (const MethodDriver& driver : advice.drivers) EXPECT_EQ(driver.level, 3) << "one alone leaves the others";
  ASSERT_TRUE(advice.next);
  EXPECT_EQ(advice.next->changes.size(), 3u);
  EXPECT_EQ(advice.next->score.level, 1);
}

/// OWAS of a posture by its printed table alone.
int category(const OwasPosture& posture) {
  const auto values = owasValues(posture);
  return Owas().score(std::vector<int>{*values[0], *values[1], *values[2], *values[3]});
}

OwasPosture with(OwasPosture posture, const std::vector<FieldChange>& changes) {
  for (const FieldChange& change : changes) {
    if (change.field == "trunk_flexion") posture.trunk_flexion = change.to;
    if (change.field == "trunk_twist") posture.trunk_twist = change.to;
    if (change.field == "trunk_side_bend") posture.trunk_side_bend = change.to;
    if (change.field == "arms_at_or_above_shoulder") posture.arms_at_or_above_shoulder = static_cast<int>(change.to);
    if (change.field == "on_one_leg") posture.on_one_leg = change.to > 0.5;
    if (change.field == "knee_flexion") {
      posture.left_knee_flexion = std::min(posture.left_knee_flexion, change.to);
      posture.right_knee_flexion = std::min(posture.right_knee_flexion, change.to);
    }
    if (change.field == "kneeling") {
      posture.kneeling = false;
      posture.left_knee_flexion = posture.right_knee_flexion = 0.0;
    }
  }
  return posture;
}

TEST(MethodAdvice, OwasComesDownByWhatItsDigitsSee) {
  int cases = 0;
  for (const double trunk : {0.0, 45.0}) {
    for (const double twist : {0.0, -30.0}) {
      for (const int arms : {0, 1, 2}) {
        for (int legs = 0; legs < 5; ++legs) {
          OwasPosture posture;
          posture.trunk_flexion = trunk;
          posture.trunk_twist = twist;
          posture.arms_at_or_above_shoulder = arms;
          posture.left_knee_flexion = legs == 1 || legs == 2 ? 60.0 : 0.0;
          posture.right_knee_flexion = legs == 1 ? 50.0 : 0.0;
          posture.on_one_leg = legs == 3;
          posture.kneeling = legs == 4;
          const MethodAdvice advice = adviseOwas(posture);
          ASSERT_EQ(advice.now.level, category(posture));
          for (const MethodDriver& driver : advice.drivers) {
            EXPECT_LT(driver.score, advice.now.score);
            EXPECT_EQ(category(with(posture, driver.changes)), driver.level);
          }
          if (advice.now.level == 1) continue;
          ASSERT_TRUE(advice.next) << "straight and standing is always 1";
          EXPECT_EQ(category(with(posture, advice.next->changes)), advice.next->score.level);
          EXPECT_LT(advice.next->score.level, advice.now.level);
          ++cases;
        }
      }
    }
  }
  EXPECT_GT(cases, 30);
  OwasPosture walking;
  walking.walking = true;
  walking.trunk_flexion = 40.0;
  walking.load_kg = 15.0;
  EXPECT_EQ(adviseOwas(walking).now.level, 3);
  ASSERT_TRUE(adviseOwas(walking).next);
  EXPECT_EQ(adviseOwas(walking).next->changes[0].field, "trunk_flexion");
  EXPECT_EQ(adviseOwas(walking).next->changes[0].to, 20.0);
}

TEST(MethodAdvice, EawsLinesComeDownToTheNextLevel) {
  EawsObservation overhead;
  overhead.hands_above_head = overhead.elbow_at_shoulder = true;
  const MethodAdvice advice = adviseEaws(overhead);
  EXPECT_EQ(advice.now.score, 100.0) << "line 6, held all the time";
  ASSERT_TRUE(advice.next);
  EXPECT_EQ(advice.next->changes.size(), 2u) << "hands under the head and elbows under the shoulders";
  EXPECT_EQ(advice.next->score.score, 13.0);
  EawsObservation bent;
  bent.trunk_flexion = 75.0;
  EXPECT_EQ(adviseEaws(bent).now.level, 3);
  ASSERT_TRUE(adviseEaws(bent).next);
  EXPECT_EQ(adviseEaws(bent).next->changes[0].to, 60.0);
  EXPECT_EQ(adviseEaws(bent).next->score.level, 2);
  EXPECT_FALSE(adviseEaws(EawsObservation{}).next);
}

std::size_t at(EawsPosture posture) {
  return static_cast<std::size_t>(posture);
}

TEST(MethodAdvice, EawsSharesAreMovedNoFurtherThanTheLevelNeeds) {
  std::array<double, kEawsPostureCount> shares{};
  shares[at(EawsPosture::kStandBentForward)] = 0.67;
  shares[at(EawsPosture::kStandHandsAboveHead)] = 0.20;
  ASSERT_EQ(eawsPosturePoints(shares), 58.0);
  const auto drivers = eawsDrivers(shares);
  ASSERT_EQ(drivers.size(), 2u);
  EXPECT_EQ(drivers[0].posture, EawsPosture::kStandBentForward);
  EXPECT_EQ(drivers[0].points, 32.0);
  EXPECT_EQ(drivers[0].score, 26.0 + 1.5) << "as much standing and walking instead";
  const auto shifts = eawsNextLevel(shares);
  ASSERT_EQ(shifts.size(), 1u);
  const auto pointsWith = [&](double share) {
    auto moved = shares;
    moved[at(shifts[0].from)] -= share;
    moved[at(shifts[0].to)] += share;
    return eawsPosturePoints(moved);
  };
  EXPECT_NEAR(pointsWith(shifts[0].share), shifts[0].score, 1e-9);
  EXPECT_LE(pointsWith(shifts[0].share), 50.0);
  EXPECT_GT(pointsWith(shifts[0].share - 0.002), 50.0);
  shares.fill(0.0);
  shares[at(EawsPosture::kClimb)] = 0.3;
  EXPECT_TRUE(eawsNextLevel(shares).empty()) << "climbing has no easier kind";
}

TEST(MethodAdvice, RulaAndRebaOfAFigureDoWhatTheySay) {
  const Figure figure = woman();
  const PostureScores scores = scoresOf(figure, *mannequin::libraryPosture(figure, "overhead"));
  const Rula rula;
  const Reba reba;
  for (const PostureMethod method : {PostureMethod::kRula, PostureMethod::kReba}) {
    const Side side = worseSide(scores, method);
    const SideScores& one = scores.sides[static_cast<std::size_t>(side)];
    const MethodAdvice advice = advise(scores, method, often());
    EXPECT_EQ(advice.now.score, scoreBy(scores, method).score);
    ASSERT_FALSE(advice.drivers.empty());
    ASSERT_TRUE(advice.next);
    PostureAngles changed = one.angles;
    for (const FieldChange& change : advice.next->changes) {
      for (const PostureField& field : postureFields()) {
        if (field.name != change.field) continue;
        if (field.angle != nullptr) changed.*field.angle = change.to;
        if (field.flag != nullptr) changed.*field.flag = change.to > 0.5;
      }
    }
    std::vector<std::string_view> unknown;
    std::optional<int> score;
    if (method == PostureMethod::kRula) {
      auto values = rulaValues(changed, unknown);
      for (std::size_t i = Rula::kMuscleUseArm; i < Rula::kCount; ++i) values[i] = one.rula[i];
      score = assess(rula, values).score;
    } else {
      auto values = rebaValues(changed, unknown);
      for (std::size_t i = Reba::kLoad; i < Reba::kCount; ++i) values[i] = one.reba[i];
      score = assess(reba, values).score;
    }
    EXPECT_EQ(score, static_cast<int>(advice.next->score.score)) << nameOf(method);
  }
}

TEST(BetterPlaces, EachMethodsPlaceIsReachedAndLower) {
  const Figure figure = woman();
  int found = 0;
  for (const char* name : {"overhead", "reaching", "stooping"}) {
    const Posture posture = *mannequin::libraryPosture(figure, name);
    const PostureScores now = scoresOf(figure, posture);
    const BetterPlaces places = betterPlaces(figure, posture, often());
    for (const PostureMethod method : kPostureMethods) {
      const auto& place = places[static_cast<std::size_t>(method)];
      if (!place) continue;
      ++found;
      const PostureScores there = scoresOf(figure, place->posture);
      EXPECT_EQ(scoreBy(there, method).score, place->score.score) << name << nameOf(method);
      EXPECT_LT(place->score.level, scoreBy(now, method).level) << name << nameOf(method);
      EXPECT_TRUE(mannequin::limitViolations(place->posture).empty());
      EXPECT_LE(glm::length(place->shift_W), 0.6 + 1e-9);
    }
    const auto alone = betterPlace(figure, posture, often(), PostureMethod::kEaws);
    const auto& together = places[static_cast<std::size_t>(PostureMethod::kEaws)];
    ASSERT_EQ(alone.has_value(), together.has_value()) << name;
    if (alone) {
      EXPECT_EQ(alone->shift_W, together->shift_W) << "asked alone it is the same";
    }
  }
  EXPECT_GE(found, 3);
}

TEST(Comfort, EachDriverIsAJointOutsideItsRange) {
  const Figure figure = woman();
  Posture posture;
  EXPECT_EQ(comfortDrivers(posture).size(),
            static_cast<std::size_t>(std::lround(mannequin::kDofCount * (1.0 - scoresOf(figure, posture).comfort))));
  posture[mannequin::Dof::kRightElbowFlexion] = 2.5;
  const auto drivers = comfortDrivers(posture);
  ASSERT_FALSE(drivers.empty());
  EXPECT_EQ(drivers[0].field, "r_elbow_flexion");
  const auto& info = mannequin::dofInfo(mannequin::Dof::kRightElbowFlexion);
  EXPECT_NEAR(drivers[0].to, info.comfort_upper * 57.295779513082323, 1e-9);
}

}  // namespace
}  // namespace hapticell::ergonomics
