// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "geometry/shapes/pose.h"
#include "mannequin/body/anthropometry.h"
#include "mannequin/body/body_request_text.h"
#include "mannequin/body/joint_names.h"
#include "mannequin/body/rotations.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {
namespace {

// --- Texts of bodies

TEST(BodyRequestText, SizesMassesAndOwnMeasuresAreRead) {
  const auto small = parseBodyRequest("mannequin:female:5");
  ASSERT_TRUE(small) << small.error().message();
  EXPECT_EQ(small->sex, Sex::kFemale);
  EXPECT_EQ(small->stature, *statureOfPercentile(Sex::kFemale, 5));
  EXPECT_FALSE(small->mass);
  const auto tall = parseBodyRequest("mannequin:male:1800.5mm:82.5kg");
  ASSERT_TRUE(tall);
  EXPECT_NEAR(tall->stature, 1.8005, 1e-12);
  EXPECT_EQ(tall->mass, 82.5);
  const std::string word(nameOf(static_cast<Dimension>(0)));
  const auto own = parseBodyRequest("mannequin:male:1800mm:" + word + "=0.5");
  ASSERT_TRUE(own) << own.error().message();
  EXPECT_EQ(own->own[0], 0.5);
}

TEST(BodyRequestText, WhatIsNoMannequinIsRefused) {
  for (const char* bad :
       {"", "mannequin", "mannequin:", "mannequin:male", "mannequin:male:", "robot:male:50", "mannequin:child:50",
        "mannequin:male:tall", "mannequin:male:1.8m", "mannequin:male:mm", "mannequin:male:nan",
        "mannequin:male:50:heavy", "mannequin:male:50:infkg", "mannequin:male:50:nose=0.1",
        "mannequin:male:50:stature=", "mannequin:male:50:", "mannequin:male:1,8mm"}) {
    EXPECT_FALSE(parseBodyRequest(bad)) << bad;
  }
}

RC_GTEST_PROP(BodyRequestText, IsReadAgainToATenthOfAMillimetre, ()) {
  BodyRequest request;
  request.sex = *rc::gen::element(Sex::kMale, Sex::kFemale);
  request.stature = 1e-5 * *rc::gen::inRange(140'000, 210'000);
  if (*rc::gen::arbitrary<bool>()) request.mass = 1e-3 * *rc::gen::inRange(40'000, 150'000);
  const auto dimension = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(kDimensionCount)));
  if (*rc::gen::arbitrary<bool>()) request.own[dimension] = 1e-5 * *rc::gen::inRange(5'000, 90'000);
  const auto again = parseBodyRequest(bodyRequestText(request));
  RC_ASSERT(again.has_value());
  RC_ASSERT(again->sex == request.sex);
  RC_ASSERT(std::abs(again->stature - request.stature) <= 0.5001e-4);
  RC_ASSERT(again->mass.has_value() == request.mass.has_value());
  if (request.mass) RC_ASSERT(std::abs(*again->mass - *request.mass) <= 0.50001e-2);
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    RC_ASSERT(again->own[i].has_value() == request.own[i].has_value());
    if (request.own[i]) RC_ASSERT(std::abs(*again->own[i] - *request.own[i]) <= 0.5001e-4);
  }
}

TEST(BodyRequestText, HasAPointWhateverTheLocale) {
  BodyRequest request;
  request.stature = 1.7555;
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool is_there = false;
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
    is_there = is_there || std::setlocale(LC_ALL, name) != nullptr;
  const std::string text = bodyRequestText(request);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(text, "mannequin:male:1755.5mm");
  if (!is_there) GTEST_SKIP() << "no locale with a decimal comma is installed";
}

// --- Names of joints

JointName oneName(const std::string& name) {
  return jointNames({name}).at(0);
}

TEST(JointNames, SidesAreSeenHoweverTheyAreWritten) {
  for (const char* left :
       {"LeftArm", "leftArm", "l_arm", "arm_l", "Arm.L", "mixamorig:LeftArm", "Actor|LeftArm", "L Arm", "larm"}) {
    EXPECT_EQ(oneName(left).side, JointName::Of::kLeft) << left;
    EXPECT_EQ(oneName(left).part, "arm") << left;
  }
  for (const char* right : {"RightUpLeg", "r_upleg", "upleg_r", "rupleg", "RightUpLeg1"}) {
    EXPECT_EQ(oneName(right).side, JointName::Of::kRight) << right;
    EXPECT_EQ(oneName(right).part, "upleg") << right;
  }
  for (const char* middle : {"Spine", "spine_01", "Hips", "Neck1", "lumbar", "root", "Head"}) {
    EXPECT_EQ(oneName(middle).side, JointName::Of::kMiddle) << middle;
  }
  EXPECT_EQ(oneName("spine_01").part, "spine");
  EXPECT_EQ(oneName("lumbar").part, "lumbar") << "an l in front of what is no limb is a letter";
}

TEST(JointNames, AWordThatNearlyAllBeginWithIsLeftOut) {
  const auto names = jointNames({"Bip01 Pelvis", "Bip01 Spine", "Bip01 L Thigh", "Bip01 R Thigh", "Bip01 Head"});
  ASSERT_EQ(names.size(), 5u);
  EXPECT_EQ(names[0].part, "pelvis");
  EXPECT_EQ(names[2].part, "thigh");
  EXPECT_EQ(names[2].side, JointName::Of::kLeft);
  EXPECT_EQ(names[3].side, JointName::Of::kRight);
  EXPECT_TRUE(jointNames({}).empty());
  EXPECT_EQ(jointNames({"", "_", ":"}).size(), 3u) << "one a name, whatever it is";
}

TEST(JointNames, LimbsAreWords) {
  for (const char* limb : {"femur", "foot", "uparm", "hand", "finger2"}) EXPECT_TRUE(isLimbWord(limb)) << limb;
  for (const char* other : {"", "umbar", "spine", "head", "feet2"}) EXPECT_FALSE(isLimbWord(other)) << other;
}

// --- Rotations

double differenceOfMatrices(const dmat3& a, const dmat3& b) {
  double most = 0.0;
  for (int i = 0; i < 3; ++i) most = std::max(most, glm::distance(a[i], b[i]));
  return most;
}

TEST(Rotations, AboutTheAxesAreThoseOfQuaternions) {
  for (double angle = -7.0; angle < 7.0; angle += 0.37) {
    EXPECT_LT(differenceOfMatrices(aboutX(angle), glm::mat3_cast(glm::angleAxis(angle, dvec3(1, 0, 0)))), 1e-14);
    EXPECT_LT(differenceOfMatrices(aboutY(angle), glm::mat3_cast(glm::angleAxis(angle, dvec3(0, 1, 0)))), 1e-14);
    EXPECT_LT(differenceOfMatrices(aboutZ(angle), glm::mat3_cast(glm::angleAxis(angle, dvec3(0, 0, 1)))), 1e-14);
  }
}

TEST(Rotations, TheLeastTurnIsAboutTheNormalOfBoth) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return glm::normalize(dvec3(normal(random), normal(random), normal(random))); };
  for (int i = 0; i < 200; ++i) {
    const dvec3 a = direction(), b = direction();
    const dmat3 R = leastTurn(a, b);
    EXPECT_LT(glm::distance(R * a, b), 1e-9);
    EXPECT_LT(differenceOfMatrices(R * glm::transpose(R), dmat3(1.0)), 1e-9);
    EXPECT_NEAR(glm::length(rotationVector(glm::quat_cast(R))), std::acos(glm::dot(a, b)), 1e-6)
        << "no larger than needed";
  }
  EXPECT_LT(differenceOfMatrices(leastTurn({0, 0, 1}, {0, 0, 1}), dmat3(1.0)), 1e-15);
}

TEST(Rotations, InTheMirrorATurnGoesTheOtherWay) {
  const dmat3 mirror(dvec3(1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, 1));
  const dmat3 R = aboutZ(0.4) * aboutX(0.2) * aboutY(-0.7);
  EXPECT_LT(differenceOfMatrices(mirroredRotation(R), mirror * R * mirror), 1e-15);
  EXPECT_LT(differenceOfMatrices(mirroredRotation(mirroredRotation(R)), R), 1e-15);
  EXPECT_EQ(outwardSign(Side::kLeft), 1.0);
  EXPECT_EQ(outwardSign(Side::kRight), -1.0);
}

}  // namespace
}  // namespace hapticell::mannequin
