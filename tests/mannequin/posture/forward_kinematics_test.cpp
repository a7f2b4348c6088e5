// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/forward_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mannequin/posture/segment_places.h"
#include "tests/mannequin/posture/random_postures.h"

namespace hapticell::mannequin {
namespace {

/// The same by quaternions and the table of degrees of freedom, one turn after the other.
std::array<Pose, kSegmentCount> slowKinematics(const Figure& figure, const Posture& posture) {
  std::array<Pose, kSegmentCount> poses;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const Segment segment = static_cast<Segment>(i);
    Pose pose = posture.X_WR;
    if (const auto parent = segmentInfo(segment).parent) {
      pose = poses[indexOf(*parent)] * Pose::translation(figure.p_PS[i]);
      for (const int axis : {1, 0, 2}) {
        for (std::size_t k = 0; k < kDofCount; ++k) {
          const DofInfo& info = dofInfo(static_cast<Dof>(k));
          const std::string_view joint = info.joint;
          if (info.segment != segment || info.axis != axis || joint.find("index") != joint.npos ||
              joint.find("thumb") != joint.npos)
            continue;
          dvec3 vector(0.0);
          vector[axis] = info.sign * posture.angles[k];
          pose = pose * Pose::rotation(quaternionFromRotationVector(vector));
        }
      }
    }
    poses[i] = pose;
  }
  return poses;
}

TEST(ForwardKinematics, AgreesWithTurnsTakenOneByOne) {
  std::mt19937_64 random(3);
  const Figure figure = *makeFigure({Sex::kFemale, 1.7});
  for (int n = 0; n < 200; ++n) {
    const Posture posture = randomPosture(random);
    const FigurePose fast = forwardKinematics(figure, posture);
    const auto slow = slowKinematics(figure, posture);
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const Twist error = difference(fast.segments[i].pose(), slow[i]);
      EXPECT_LT(glm::length(error.linear), 1e-12);
      EXPECT_LT(glm::length(error.angular), 1e-7);  // The quaternion of a matrix is good to half the digits only.
    }
  }
}

TEST(SegmentPlaces, HangOnTheRootThatIsAlreadyPlaced) {
  std::mt19937_64 random(4);
  const Figure figure = *makeFigure({Sex::kMale, 1.8});
  const Pose X = Pose{{3.0, -2.0, 0.5}, quaternionFromRotationVector({0.4, -1.0, 2.0})};
  for (int n = 0; n < 50; ++n) {
    const Posture posture = randomPosture(random);
    SineCosine sc;
    for (std::size_t i = 0; i < kDofCount; ++i) {
      sc.sine[i] = std::sin(posture.angles[i]);
      sc.cosine[i] = std::cos(posture.angles[i]);
    }
    BallRotations balls;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      balls[i] = ballRotationOf(posture, armDof(side, Dof::kLeftShoulderFlexion));
      balls[2 + i] = ballRotationOf(posture, legDof(side, Dof::kLeftHipFlexion));
    }
    FigurePose pose;
    const Pose moved_root = X * posture.X_WR;
    pose[Segment::kPelvis] = {glm::mat3_cast(moved_root.q), moved_root.p};
    placeSegments(figure, sc, balls, pose);
    const auto slow = slowKinematics(figure, posture);
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const Twist error = difference(pose.segments[i].pose(), X * slow[i]);
      EXPECT_LT(glm::length(error.linear), 1e-12) << segmentInfo(static_cast<Segment>(i)).name;
      EXPECT_LT(glm::length(error.angular), 1e-7) << segmentInfo(static_cast<Segment>(i)).name;
    }
  }
}

TEST(ForwardKinematics, SinesAndCosinesAreExactToRounding) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> angle(-8.0, 8.0);
  SineCosine sc;
  for (int n = 0; n < 500; ++n) {
    JointAngles angles;
    for (double& a : angles) a = angle(random);
    sinesAndCosines(angles, sc);
    for (std::size_t i = 0; i < kDofCount; ++i) {
      EXPECT_NEAR(sc.sine[i], std::sin(angles[i]), 1e-15);
      EXPECT_NEAR(sc.cosine[i], std::cos(angles[i]), 1e-15);
    }
  }
}

TEST(ForwardKinematics, MotionsGoTheWayTheirNamesSay) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const FigurePose zero = forwardKinematics(figure, Posture{});
  const auto moved = [&](Dof dof, Segment segment, const dvec3& point) {
    Posture posture;
    posture[dof] = 0.3;
    return forwardKinematics(figure, posture)[segment].point(point) - zero[segment].point(point);
  };
  const dvec3 tip(0.0, 0.0, -0.15), up(0.0, 0.0, 0.2), toe(0.2, 0.0, 0.0);
  EXPECT_GT(moved(Dof::kVl5Flexion, Segment::kHead, up).x, 0.05);
  EXPECT_LT(moved(Dof::kVl1RightBend, Segment::kHead, up).y, -0.05);
  EXPECT_GT(moved(Dof::kVt6LeftTurn, Segment::kHead, {0.1, 0.0, 0.0}).y, 0.02);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double out = side == Side::kLeft ? 1.0 : -1.0;
    const Segment hand = armSegment(side, Segment::kLeftHand), foot = legSegment(side, Segment::kLeftFoot);
    EXPECT_GT(moved(armDof(side, Dof::kLeftShoulderFlexion), hand, tip).x, 0.1);
    EXPECT_GT(moved(armDof(side, Dof::kLeftShoulderAbduction), hand, tip).y * out, 0.1);
    EXPECT_GT(moved(armDof(side, Dof::kLeftElbowFlexion), hand, tip).x, 0.05);
    EXPECT_LT(moved(armDof(side, Dof::kLeftPronation), hand, {0.05, 0.0, 0.0}).y * out, -0.01);
    EXPECT_LT(moved(armDof(side, Dof::kLeftShoulderInternalRotation), hand, {0.05, 0.0, 0.0}).y * out, -0.01);
    EXPECT_LT(moved(armDof(side, Dof::kLeftWristFlexion), hand, tip).y * out, -0.02);
    EXPECT_LT(moved(armDof(side, Dof::kLeftWristUlnarDeviation), hand, tip).x, -0.02);
    EXPECT_GT(moved(armDof(side, Dof::kLeftClavicleElevation), hand, tip).z, 0.02);
    EXPECT_GT(moved(armDof(side, Dof::kLeftClavicleProtraction), hand, tip).x, 0.02);
    EXPECT_GT(moved(legDof(side, Dof::kLeftHipFlexion), foot, toe).x, 0.1);
    EXPECT_GT(moved(legDof(side, Dof::kLeftHipAbduction), foot, toe).y * out, 0.1);
    EXPECT_LT(moved(legDof(side, Dof::kLeftKneeFlexion), foot, toe).x, -0.05);
    EXPECT_LT(moved(legDof(side, Dof::kLeftAnklePlantarFlexion), foot, toe).z, -0.03);
    EXPECT_GT(moved(legDof(side, Dof::kLeftAnkleInversion), foot, {0.0, -0.04 * out, 0.0}).z, 0.005);
  }
}

TEST(ForwardKinematics, AnglesOfARotationGiveTheRotationBack) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  for (int n = 0; n < 500; ++n) {
    dvec3 angles(angle(random), angle(random), angle(random));
    if (n % 10 == 0) angles.x = std::numbers::pi / 2;  // gimbal
    const dmat3 R = rotationYXZ(angles);
    const dmat3 again = rotationYXZ(anglesYXZ(R));
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(R[c] - again[c]), 1e-9);
  }
}

TEST(ForwardKinematics, LoadsInTheHandsMoveTheCentreOfMass) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const FigurePose pose = forwardKinematics(figure, *libraryPosture(figure, "both_hands_forward"));
  const dvec3 plain = centerOfMass(figure, pose);
  const std::array<HandLoad, 2> loads = {HandLoad{5.0, {}}, HandLoad{5.0, {}}};
  const dvec3 loaded = centerOfMass(figure, pose, loads);
  const dvec3 hands = 0.5 * (handPose(pose, Side::kLeft).p + handPose(pose, Side::kRight).p);
  const dvec3 expected = (plain * figure.totalMass() + hands * 10.0) / (figure.totalMass() + 10.0);
  EXPECT_LT(glm::length(loaded - expected), 1e-12);
}

}  // namespace
}  // namespace hapticell::mannequin
