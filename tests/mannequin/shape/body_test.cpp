// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/body_skin.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "geometry/shapes/mass_properties.h"
#include "mannequin/shape/face_shape.h"
#include "mannequin/shape/figure_model.h"
#include "mannequin/posture/hand_differential.h"
#include "mannequin/shape/head_flesh.h"
#include "mannequin/posture/vision.h"
#include "tests/mannequin/posture/random_postures.h"

namespace hapticell::mannequin {
namespace {

/// Number of connected pieces of a mesh.
std::size_t piecesOf(const geometry::TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const geometry::Triangle& t : mesh.triangles) {
    parent[root(t[0])] = root(t[1]);
    parent[root(t[1])] = root(t[2]);
  }
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < parent.size(); ++v) count += parent[v] == v ? 1 : 0;
  return count;
}

TEST(Body, EverySegmentIsAClosedSolidAboutItsCentreOfMass) {
  const Figure figure = *makeFigure({Sex::kFemale, 1.626});
  const std::vector<Flesh> flesh = fleshOf(figure);
  ASSERT_EQ(flesh.size(), kBodies);
  for (std::size_t i = 0; i < kBodies; ++i) {
    const geometry::TriangleMesh mesh = bodyMesh(flesh[i], i < kSegmentCount ? 0.012 : 0.005);
    EXPECT_TRUE(geometry::isClosed(mesh)) << i;
    EXPECT_GT(geometry::massProperties(mesh).volume, 0.0) << i;
    EXPECT_EQ(piecesOf(mesh), 1u) << i;
  }
}

TEST(Body, TheSkinIsOnePieceInEveryPostureAndAsTallAsTheFigure) {
  for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
    const Figure figure = *makeFigure({sex, 1.7});
    for (const char* name : {"zero", sex == Sex::kMale ? "overhead" : "squatting"}) {
      const Skin skin = skinOf(figure, *libraryPosture(figure, name), 0.016);
      EXPECT_TRUE(geometry::isClosed(skin.mesh)) << name;
      EXPECT_EQ(skin.body_of_vertex.size(), skin.mesh.vertices.size());
      std::size_t large = piecesOf(skin.mesh);
      EXPECT_EQ(large, 1u) << name;
      const geometry::Bounds bounds = skin.mesh.bounds();
      EXPECT_NEAR(bounds.min.z, 0.0, 0.015) << name;
      if (std::string(name) == "zero") {
        EXPECT_NEAR(bounds.max.z, 1.7, 0.015);
      }
      // Flesh weighs about what water weighs.
      const double density = figure.totalMass() / geometry::massProperties(skin.mesh).volume;
      EXPECT_GT(density, 800.0);
      EXPECT_LT(density, 1250.0);
    }
  }
}

TEST(Body, KneelingFiguresKneelOnTheFloor) {
  for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
    const Figure figure = *makeFigure({sex, 1.7});
    for (const char* name : {"kneeling", "kneeling_one"}) {
      const Skin skin = skinOf(figure, *libraryPosture(figure, name), 0.016);
      const auto lowest = [&](Segment segment) {
        double z = 1e9;
        for (std::size_t v = 0; v < skin.mesh.vertices.size(); ++v)
          if (skin.body_of_vertex[v] == indexOf(segment)) z = std::min(z, skin.mesh.vertices[v].z);
        return z;
      };
      EXPECT_NEAR(std::min(lowest(Segment::kRightThigh), lowest(Segment::kRightShank)), 0.0, 0.025) << name;
      EXPECT_NEAR(lowest(Segment::kRightToes), 0.0, 0.025) << name;
      if (std::string(name) == "kneeling_one") {
        EXPECT_NEAR(lowest(Segment::kLeftFoot), 0.0, 0.025) << "the front foot";
      }
    }
  }
}

TEST(Body, AStraightLegDoesNotSwellAtTheKnee) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const Posture posture = *libraryPosture(figure, "zero");
  const Skin skin = skinOf(figure, posture, 0.012);
  const double knee = forwardKinematics(figure, posture)[Segment::kLeftShank].p_WS.z;
  const auto width = [&](double z) {
    double low = 1e9, high = -1e9;
    for (const dvec3& v : skin.mesh.vertices) {
      if (std::abs(v.z - z) > 0.008 || v.y < 0.0) continue;
      low = std::min(low, v.x);
      high = std::max(high, v.x);
    }
    return high - low;
  };
  EXPECT_LT(width(knee), width(knee + 0.06) + 0.004);
}

TEST(FigureModel, StandsAsTheFigureDoes) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const auto model = figureModel(figure);
  EXPECT_EQ(model->dof(), kModelVariables) << "56 and the gaze";
  std::mt19937_64 random(13);
  for (int n = 0; n < 20; ++n) {
    Posture posture = randomPosture(random);
    posture.gaze = {0.01 * n, -0.005 * n};
    const ModelConfiguration configuration = toModel(figure, posture);
    std::vector<Pose> X_EL;
    kinematics::forwardKinematics(*model, configuration.joints, X_EL);
    const FigurePose pose = forwardKinematics(figure, posture);
    for (std::size_t link = 0; link < model->links.size(); ++link) {
      const int body = bodyOfLink(*model, static_cast<int>(link));
      if (body < 0) continue;
      const dvec3 p = (configuration.X_WE * X_EL[link]).p;
      if (static_cast<std::size_t>(body) < kSegmentCount) {
        EXPECT_LT(glm::length(p - pose.segments[static_cast<std::size_t>(body)].p_WS), 1e-9) << model->links[link].name;
      } else {
        const std::size_t finger = static_cast<std::size_t>(body) - kSegmentCount;
        const Side side = finger < kDigits * kPhalanges ? Side::kLeft : Side::kRight;
        const auto places = phalanxPlaces(figure, posture, side, pose[armSegment(side, Segment::kLeftHand)]);
        const std::size_t of_hand = finger % (kDigits * kPhalanges);
        EXPECT_LT(glm::length(p - places[of_hand / kPhalanges][of_hand % kPhalanges].p_WS), 1e-9)
            << model->links[link].name;
      }
    }
    const Posture again = toPosture(figure, configuration);
    EXPECT_EQ(again.angles, posture.angles);
    EXPECT_EQ(again.gaze.yaw, posture.gaze.yaw);
    EXPECT_EQ(again.gaze.pitch, posture.gaze.pitch);
    for (const char* name : {"l_eyeball", "r_eyeball"}) {
      const Pose eye = configuration.X_WE * X_EL[static_cast<std::size_t>(model->findLink(name))];
      const dvec3 looks = eyePose(figure, pose, posture.gaze).rotate({0.0, 0.0, -1.0});
      EXPECT_LT(glm::length(eye.rotate({1.0, 0.0, 0.0}) - looks), 1e-9) << name;
    }
    EXPECT_LT(glm::length(again.X_WR.p - posture.X_WR.p), 1e-12);
  }
}

TEST(Face, EyesSitInTheirSocketsAndAreSeenFromAhead) {
  for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
    for (const double stature : {1.45, 1.7, 1.95}) {
      const Figure figure = *makeFigure({sex, stature});
      const Flesh head = headFlesh(figure);
      double radius = 0.0;
      const auto eyes = eyePieces(figure);
      for (const dvec3& v : eyes[0].mesh.vertices) radius = std::max(radius, glm::length(v));
      EXPECT_NEAR(radius, 0.012, 0.002) << "an eye is 24 mm wide";
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const dvec3 eye = eyeCentre(figure, side);
        EXPECT_LT(head.distance(eye), 0.5 * radius) << "in the head";
        EXPECT_GT(head.distance(eye + radius * dvec3(1.0, 0.0, 0.0)), 0.0) << "its front is free";
        EXPECT_LT(head.distance(eye - radius * dvec3(1.0, 0.0, 0.0)), 0.0) << "its back is not";
      }
      const dvec3 between = 0.5 * (eyeCentre(figure, Side::kLeft) + eyeCentre(figure, Side::kRight));
      EXPECT_NEAR(between.z, figure.p_HeadEyes.z, 1e-9) << "at the height that is measured";
    }
  }
}

TEST(Hands, GraspsKeepTheLimitsAndCloseTheFingers) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  Posture posture;
  const auto tip = [&] {
    const FigurePose pose = forwardKinematics(figure, posture);
    return phalanxPlaces(figure, posture, Side::kRight, pose[Segment::kRightHand])[2][2].p_WS;
  };
  const dvec3 open = tip();
  for (const char* grasp : {"open", "flat", "power", "pinch", "pointing"}) {
    EXPECT_TRUE(setGrasp(posture, Side::kRight, grasp));
    EXPECT_TRUE(limitViolations(posture).empty());
  }
  EXPECT_FALSE(setGrasp(posture, Side::kRight, "juggling"));
  setGrasp(posture, Side::kRight, "power");
  EXPECT_GT(tip().z, open.z + 0.05);  // Curled up towards the palm,
  EXPECT_GT(tip().y, open.y + 0.02);  // which on the right faces left.
}

TEST(HandDifferential, TheHandGoesWhereItIsAskedAndTheFeetStand) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const Posture posture = *libraryPosture(figure, "both_hands_forward");
  const Pose hand = handPose(forwardKinematics(figure, posture), Side::kRight);
  PostureTask task;
  task.hands[1] = hand;
  const Pose X_WM{hand.p + dvec3(0.05, 0.0, -0.03), hand.q};
  const HandDifferential free = differentiateHand(figure, posture, task, Side::kRight, X_WM);
  task.trunk_locked = true;
  const HandDifferential locked = differentiateHand(figure, posture, task, Side::kRight, X_WM);
  for (std::size_t i = 0; i < 6; ++i) {
    dvec3 unit(0.0);
    unit[static_cast<int>(i % 3)] = 1.0;
    const dvec3 linear = i < 3 ? unit : glm::cross(unit, hand.p - X_WM.p), angular = i < 3 ? dvec3(0.0) : unit;
    for (const HandDifferential* d : {&free, &locked}) {
      EXPECT_LT(glm::length((*d)[indexOf(Segment::kRightHand)][i].linear - linear), 2e-3);
      EXPECT_LT(glm::length((*d)[indexOf(Segment::kRightHand)][i].angular - angular), 2e-3);
      EXPECT_LT(glm::length((*d)[indexOf(Segment::kLeftFoot)][i].linear), 1e-4);
    }
    EXPECT_EQ(glm::length(locked[indexOf(Segment::kThorax)][i].linear), 0.0);
  }
}

}  // namespace
}  // namespace hapticell::mannequin
