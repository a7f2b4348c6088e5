// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/skeleton.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>
#include <string>

namespace hapticell::mannequin {
namespace {

TEST(Skeleton, HasFiftySixDegreesOfFreedomSharedAsInTheAsfLayout) {
  std::map<std::string, int> of_joint;
  std::set<std::string> names;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i));
    ++of_joint[info.joint];
    names.insert(info.name);
    EXPECT_LT(info.lower, info.upper) << info.name;
    EXPECT_LE(info.lower, info.comfort_lower) << info.name;
    EXPECT_GE(info.upper, info.comfort_upper) << info.name;
  }
  EXPECT_EQ(names.size(), 56u);
  for (const char* joint :
       {"vl5", "vl1", "vt6", "vc7", "vc4", "skullbase", "l_shoulder", "r_shoulder", "l_hip", "r_hip"}) {
    EXPECT_EQ(of_joint[joint], 3) << joint;
  }
  for (const char* joint : {"l_sternoclavicular", "r_wrist"}) EXPECT_EQ(of_joint[joint], 2) << joint;
  for (const char* joint : {"l_elbow", "r_knee", "l_metatarsal", "r_radioulnar"})
    EXPECT_EQ(of_joint[joint], 1) << joint;
}

TEST(Skeleton, SpineLimitsAddUpToTheClinicalRangesOfTheTrunk) {
  const auto sum = [](std::initializer_list<Dof> dofs, bool upper) {
    double total = 0.0;
    for (const Dof dof : dofs) total += upper ? dofInfo(dof).upper : -dofInfo(dof).lower;
    return total * 180.0 / std::numbers::pi;
  };
  // AAOS thoracolumbar 80/25/35/45, neck 45/60/45/80 (flexion, extension, side, turn).
  EXPECT_NEAR(sum({Dof::kVl5Flexion, Dof::kVl1Flexion, Dof::kVt6Flexion}, true), 80.0, 1e-9);
  EXPECT_NEAR(sum({Dof::kVl5Flexion, Dof::kVl1Flexion, Dof::kVt6Flexion}, false), 25.0, 1e-9);
  EXPECT_NEAR(sum({Dof::kVl5RightBend, Dof::kVl1RightBend, Dof::kVt6RightBend}, true), 35.0, 1e-9);
  EXPECT_NEAR(sum({Dof::kVl5LeftTurn, Dof::kVl1LeftTurn, Dof::kVt6LeftTurn}, true), 45.0, 1e-9);
  EXPECT_NEAR(sum({Dof::kVc7Flexion, Dof::kVc4Flexion, Dof::kSkullbaseFlexion}, true), 45.0, 1e-9);
  EXPECT_NEAR(sum({Dof::kVc7Flexion, Dof::kVc4Flexion, Dof::kSkullbaseFlexion}, false), 60.0, 1e-9);
  EXPECT_NEAR(sum({Dof::kVc7LeftTurn, Dof::kVc4LeftTurn, Dof::kSkullbaseLeftTurn}, true), 80.0, 1e-9);
}

TEST(Skeleton, MirroringPairsLeftWithRightAndIsItsOwnInverse) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = static_cast<Dof>(i);
    EXPECT_EQ(mirrored(mirrored(dof)), dof);
    std::string name = dofInfo(dof).name;
    if (name.starts_with("l_"))
      name[0] = 'r';
    else if (name.starts_with("r_"))
      name[0] = 'l';
    EXPECT_EQ(name, dofInfo(mirrored(dof)).name);
    EXPECT_EQ(findDof(dofInfo(dof).name), dof);
  }
  EXPECT_FALSE(findDof("l_tail_flexion").has_value());
}

TEST(Skeleton, ParentsComeBeforeTheirChildren) {
  for (std::size_t i = 1; i < kSegmentCount; ++i) {
    const auto parent = segmentInfo(static_cast<Segment>(i)).parent;
    ASSERT_TRUE(parent.has_value());
    EXPECT_LT(indexOf(*parent), i);
  }
  EXPECT_FALSE(segmentInfo(Segment::kPelvis).parent.has_value());
}

}  // namespace
}  // namespace hapticell::mannequin
