// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/hand_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/test_data.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

std::string problem(std::string_view text) {
  const auto path = parseHandPath(text, "hand.csv");
  return path ? "no problem" : path.error().message();
}

TEST(HandPath, interpolatesPosesAndHoldsButtonsAndEnds) {
  const auto path = parseHandPath(
      "t,x,y,z,qw,qx,qy,qz,button\n"
      "1.0,0,0,0,1,0,0,0,0\n"
      "2.0,0.01,0.02,-0.03,0.7071067811865476,0,0,0.7071067811865476,1\n",
      "hand.csv");
  ASSERT_TRUE(path.has_value()) << path.error().message();
  EXPECT_EQ(path->duration(), 2.0);
  const HandSample middle = path->at(1.5);
  EXPECT_NEAR(middle.X_DH.p.y, 0.01, 1e-15);
  EXPECT_NEAR(rotationVector(middle.X_DH.q).z, M_PI / 4.0, 1e-12);
  EXPECT_EQ(middle.buttons, 0u);
  EXPECT_EQ(path->at(0.0).X_DH.p, dvec3(0.0));
  EXPECT_EQ(path->at(99.0).X_DH.p, dvec3(0.01, 0.02, -0.03));
  EXPECT_EQ(path->at(2.0).buttons, 1u);
}

TEST(HandPath, takesColumnsInAnyOrderAndWithoutTurning) {
  const auto path =
      parseHandPath("\xEF\xBB\xBFz, y ,x,note,t\r\n# a remark\r\n0.3,0.2,+0.1,hello,0\r\n\r\n", "hand.csv");
  ASSERT_TRUE(path.has_value()) << path.error().message();
  EXPECT_EQ(path->at(0.0).X_DH.p, dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(path->at(0.0).X_DH.q, dquat(1, 0, 0, 0));
}

TEST(HandPath, twoSamplesAtOneTimeAreAStep) {
  const auto path = parseHandPath("t,x,y,z\n0,0,0,0\n1,0,0,0\n1,0.1,0,0\n2,0.1,0,0\n", "hand.csv");
  ASSERT_TRUE(path.has_value());
  EXPECT_NEAR(path->at(0.999).X_DH.p.x, 0.0, 1e-12);
  EXPECT_NEAR(path->at(1.0).X_DH.p.x, 0.1, 1e-12);
}

TEST(HandPath, namesLineAndColumnOfWhatIsWrong) {
  EXPECT_EQ(problem("t,x,y,z\n0,0,0,0\n1,zero,0,0\n"), "hand.csv, line 3, column 'x': \"zero\"; expected a number");
  EXPECT_THAT(problem("t,x,y,z\n0,0,0\n"), HasSubstr("line 2, column 'z'"));
  EXPECT_THAT(problem("t,x,y,z\n0,nan,0,0\n"), HasSubstr("column 'x'"));
  EXPECT_THAT(problem("t,x,y,z\n0,1e999,0,0\n"), HasSubstr("column 'x'"));
  EXPECT_THAT(problem("t,x,y\n0,0,0\n"), HasSubstr("column 'z': the column is missing"));
  EXPECT_THAT(problem("t,x,y,z,qw\n0,0,0,0,1\n"), HasSubstr("column 'qx': the column is missing"));
  EXPECT_THAT(problem("t,x,y,z\n1,0,0,0\n0,0,0,0\n"), HasSubstr("line 3, column 't'"));
  EXPECT_THAT(problem("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,0,0,0,0\n"), HasSubstr("quaternion"));
  for (const char* button : {"-1", "7", "0.5", "4"}) {
    EXPECT_THAT(problem(std::string("t,x,y,z,button\n0,0,0,0,") + button + "\n"), HasSubstr("column 'button'"));
  }
  EXPECT_THAT(problem("t,x,y,z\n"), HasSubstr("there is no row"));
  EXPECT_THAT(problem(""), HasSubstr("there is no row"));
}

TEST(HandPath, readsAFileAndSaysWhenItCannot) {
  const test::TemporaryFolder folder;
  const auto path = readHandPath(folder.write("hand.csv", "t,x,y,z\n0,0.01,0,0\n"));
  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(path->samples().size(), 1u);
  EXPECT_FALSE(readHandPath(folder.path() / "none.csv").has_value());
}

}  // namespace
}  // namespace hapticell::haptic
