// SPDX-License-Identifier: Apache-2.0
#include "trajectory/files/pose_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>

#include "tests/support/test_data.h"

namespace hapticell::trajectory {
namespace {

using testing::HasSubstr;

class PoseCsv : public testing::Test {
 protected:
  std::string poseError(const std::string& text) {
    const auto poses = readPoseCsv(folder_.write("poses.csv", text));
    return poses ? "no error" : poses.error().message();
  }
  std::string handError(const std::string& text) {
    const auto samples = readHandCsv(folder_.write("hand.csv", text));
    return samples ? "no error" : samples.error().message();
  }
  test::TemporaryFolder folder_;
};

TEST_F(PoseCsv, ReadsColumnsByNameInAnyOrder) {
  const auto poses = readPoseCsv(folder_.write(
      "poses.csv", "\xEF\xBB\xBFqw, qx,qy,qz,z,note,y,x\r\n1,0,0,0,0.3,7,-2e-1,+.1\r\n\r\n# aside\r\n0,1,0,0,3,7,2,1"));
  ASSERT_TRUE(poses) << poses.error().message();
  ASSERT_EQ(poses->size(), 2u);
  EXPECT_EQ((*poses)[0].p, dvec3(0.1, -0.2, 0.3));
  EXPECT_EQ((*poses)[1].q, dquat(0, 1, 0, 0));
}

TEST_F(PoseCsv, PointIsThePointInEveryLocale) {
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const auto poses = readPoseCsv(folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n0.5,0,0,1,0,0,0\n"));
  if (set) std::setlocale(LC_ALL, "C");
  ASSERT_TRUE(poses);
  EXPECT_EQ(poses->front().p.x, 0.5);
}

TEST_F(PoseCsv, NormalisesNearlyUnitQuaternionsAndRefusesOthers) {
  const auto poses = readPoseCsv(folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n0,0,0,0.7071,0,0,0.7072\n"));
  ASSERT_TRUE(poses);
  EXPECT_NEAR(glm::length(poses->front().q), 1.0, 1e-15);
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,1,0,0,0.5\n"), HasSubstr("line 3, columns qw"));
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy,qz\n0,0,0,0,0,0,0\n"), HasSubstr("length 0.000000"));
}

TEST_F(PoseCsv, ErrorsNameLineAndColumn) {
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy,qz\n0,0,nan,1,0,0,0\n"), HasSubstr("line 2, column 'z': 'nan'"));
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy,qz\n0,0,1e999,1,0,0,0\n"), HasSubstr("column 'z'"));
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy,qz\n0,0,,1,0,0,0\n"), HasSubstr("nothing"));
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0\n"), HasSubstr("line 2: 6 fields; expected 7"));
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy\n"), HasSubstr("no column 'qz'"));
  EXPECT_THAT(poseError("0,0,0,1,0,0,0\n"), HasSubstr("no column 'x'"));
  EXPECT_THAT(poseError("x,x,y,z,qw,qx,qy,qz\n"), HasSubstr("two columns 'x'"));
  EXPECT_THAT(poseError(""), HasSubstr("an empty file"));
  EXPECT_THAT(poseError("x,y,z,qw,qx,qy,qz\n# nothing\n"), HasSubstr("no line after the header"));
  EXPECT_THAT(poseError(std::string(100000, 'x')), HasSubstr("too long"));
  EXPECT_THAT(readPoseCsv(folder_.path() / "none.csv").error().message(),
              HasSubstr("none.csv: the file does not exist"));
  EXPECT_THAT(readPoseCsv(folder_.path()).error().message(), HasSubstr("a folder"));
}

TEST_F(PoseCsv, HandFilesHaveTimesAndAButton) {
  const auto samples =
      readHandCsv(folder_.write("hand.csv", "t,x,y,z,qw,qx,qy,qz,button\n0,0,0,0,1,0,0,0,0\n0.5,0.1,0,0,1,0,0,0,1\n"));
  ASSERT_TRUE(samples) << samples.error().message();
  EXPECT_FALSE((*samples)[0].button);
  EXPECT_TRUE((*samples)[1].button);
  EXPECT_EQ((*samples)[1].t, 0.5);
  const auto without = readHandCsv(folder_.write("hand.csv", "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n"));
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->front().button);
  EXPECT_THAT(handError("t,x,y,z,qw,qx,qy,qz\n1,0,0,0,1,0,0,0\n1,0,0,0,1,0,0,0\n"), HasSubstr("line 3, column 't'"));
  EXPECT_THAT(handError("t,x,y,z,qw,qx,qy,qz,button\n1,0,0,0,1,0,0,0,2\n"), HasSubstr("column 'button'"));
}

TEST_F(PoseCsv, JointsComeInTheOrderAskedFor) {
  const auto file = folder_.write("joints.csv", "joint_2,joint_1\n0.2,0.1\n-2,-1\n");
  const auto rows = readJointCsv(file, {"joint_1", "joint_2"});
  ASSERT_TRUE(rows);
  EXPECT_EQ((*rows)[1], (std::vector<double>{-1, -2}));
  EXPECT_THAT(readJointCsv(file, {"joint_1", "joint_3"}).error().message(), HasSubstr("no column 'joint_3'"));
}

}  // namespace
}  // namespace hapticell::trajectory
