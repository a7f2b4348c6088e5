// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/hand_targets.h"

#include <gtest/gtest.h>

#include "tests/support/test_data.h"

namespace hapticell::manipulation {
namespace {

TEST(HandTargets, RowsOfOneStepBelongTogether) {
  const hapticell::test::TemporaryFolder folder;
  const auto stepped = readHandTargets(folder.write("a.csv",
                                                    "# by hand\nstep,hand,x,y,z,qw,qx,qy,qz\n2,left,1,2,3,1.0005,0,0,0\n"
                                                    "5,right,0,0,1,0,1,0,0\n\n2,right,4,5,6,1,0,0,0\n"));
  ASSERT_TRUE(stepped) << stepped.error().message();
  ASSERT_EQ(stepped->size(), 2U);
  EXPECT_EQ((*stepped)[0].step, 2.0);
  ASSERT_TRUE((*stepped)[0].hands[0] && (*stepped)[0].hands[1]);
  EXPECT_EQ((*stepped)[0].hands[0]->p, dvec3(1.0, 2.0, 3.0));
  EXPECT_NEAR(glm::length((*stepped)[0].hands[0]->q), 1.0, 1e-15) << "normalised";
  EXPECT_FALSE((*stepped)[1].hands[0]);
  EXPECT_EQ((*stepped)[1].hands[1]->q.x, 1.0);
  const auto rows = readHandTargets(
      folder.write("b.csv", "hand;x;y;z;qw;qx;qy;qz\nleft;0;0;1;1;0;0;0\nleft;0;0;2;1;0;0;0\n"));
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2U) << "without steps each row is one";
  EXPECT_EQ((*rows)[1].step, 1.0);
}

TEST(HandTargets, ErrorsNameLineAndColumn) {
  const hapticell::test::TemporaryFolder folder;
  const std::string head = "step,hand,x,y,z,qw,qx,qy,qz\n";
  const std::pair<std::string, const char*> cases[] = {
      {"", "an empty file"},
      {head, "no line after the header"},
      {"hand,x,y,z\nleft,0,0,0\n", "line 1, column 'qw'"},
      {head + "1,middle,0,0,0,1,0,0,0\n", "line 2, column 'hand'"},
      {head + "1,left,0,nan,0,1,0,0,0\n", "line 2, column 'y'"},
      {head + "1,left,0,0\n", "line 2, column 'z'"},
      {head + "x,left,0,0,0,1,0,0,0\n", "column 'step'"},
      {head + "1,left,0,0,0,1.002,0,0,0\n", "qw,qx,qy,qz"},
      {head + "1,left,0,0,0,1,0,0,0\n1,left,0,0,1,1,0,0,0\n", "a second left hand"}};
  for (const auto& [text, part] : cases) {
    const auto read = readHandTargets(folder.write("bad.csv", text));
    ASSERT_FALSE(read) << text;
    EXPECT_NE(read.error().message().find(part), std::string::npos) << read.error().message();
  }
  EXPECT_FALSE(readHandTargets(folder.path() / "none.csv"));
}

}  // namespace
}  // namespace hapticell::manipulation
