// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/sitting.h"

#include <numbers>

#include <gtest/gtest.h>

#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/figure_model.h"
#include "tests/mannequin/body/median_man.h"

namespace hapticell::mannequin {
namespace {

double lowestSole(const Figure& figure, const Posture& posture) {
  const FigurePose pose = forwardKinematics(figure, posture);
  return std::min(footPose(pose, Side::kLeft).p.z, footPose(pose, Side::kRight).p.z) + figure.sole.z;
}

TEST(Sitting, FeetStandOnTheFloorBeforeAChairThatSuits) {
  for (const auto& [sex, stature] :
       {std::pair{Sex::kFemale, 1.525}, std::pair{Sex::kMale, 1.756}, std::pair{Sex::kMale, 1.87}}) {
    const Figure figure = *makeFigure({sex, stature});
    const auto model = figureModel(figure);
    for (const double seat : {0.36, 0.42}) {
      const Sitting sitting = sitOn(figure, *model, {1.0, 2.0, seat}, 0.0);
      EXPECT_EQ(sitting.feet_above_floor_m, 0.0) << stature << " m on " << seat;
      EXPECT_NEAR(lowestSole(figure, sitting.posture), 0.0, 2e-3) << stature << " m on " << seat;
      const FigurePose pose = forwardKinematics(figure, sitting.posture);
      EXPECT_NEAR(pose[Segment::kPelvis].p_WS.x, 1.0, 1e-6);
      EXPECT_NEAR(pose[Segment::kPelvis].p_WS.y, 2.0, 1e-6);
      EXPECT_GT(pose[Segment::kPelvis].p_WS.z, seat);
      EXPECT_GT(footPose(pose, Side::kLeft).p.x, 1.2) << "the feet are before the seat";
    }
  }
}

TEST(Sitting, LooksWhereItIsTold) {
  const Figure figure = medianMan();
  const Sitting sitting = sitOn(figure, *figureModel(figure), {0.0, 0.0, 0.45}, -0.5 * std::numbers::pi);
  EXPECT_LT(footPose(forwardKinematics(figure, sitting.posture), Side::kLeft).p.y, -0.2);
}

TEST(Sitting, SaysByHowMuchTheFeetHangOverTheFloorOfAHighStool) {
  const Figure figure = *makeFigure({Sex::kFemale, 1.525});
  const Sitting sitting = sitOn(figure, *figureModel(figure), {0.0, 0.0, 0.80}, 0.0);
  EXPECT_GT(sitting.feet_above_floor_m, 0.05);
  EXPECT_LT(sitting.feet_above_floor_m, 0.45);
}

}  // namespace
}  // namespace hapticell::mannequin
