// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/link_problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptic/protocol/messages.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

TEST(LinkProblem, IsOneTextOfWhatThereIs) {
  EXPECT_TRUE(LinkProblem{}.empty());
  EXPECT_EQ(english(LinkProblem{}), "");
  EXPECT_EQ(english(LinkProblem{"It is off."}), "It is off.");
  EXPECT_EQ(english(LinkProblem{"It is off.", "Switch it on."}), "It is off. Switch it on.");
  EXPECT_EQ(english(LinkProblem{{}, "Switch it on."}), "Switch it on.");
  EXPECT_FALSE((LinkProblem{{}, "Switch it on."}).empty());
}

TEST(LinkProblem, OfEachRefusalNamesItsSubject) {
  for (const RefusalReason reason : {RefusalReason::kControlled, RefusalReason::kTakenOver, RefusalReason::kSilent,
                                     RefusalReason::kFull, RefusalReason::kFullOfMachine}) {
    const LinkProblem problem = problemOf({.sentence = "unused", .reason = reason, .subject = "the other"});
    EXPECT_THAT(english(problem), HasSubstr("the other")) << static_cast<int>(reason);
    EXPECT_EQ(english(problem).find("unused"), std::string::npos) << static_cast<int>(reason);
  }
  EXPECT_FALSE(problemOf({.reason = RefusalReason::kControlled}).fix.empty());
}

TEST(LinkProblem, OfAReasonThatIsNotKnownIsTheServersSentence) {
  EXPECT_EQ(english(problemOf({.sentence = "Plain words, %1."})), "Plain words, %1.") << "no place is filled in it";
  EXPECT_EQ(english(problemOf({.sentence = "Of a newer server.", .reason = static_cast<RefusalReason>(200)})),
            "Of a newer server.");
}

}  // namespace
}  // namespace hapticell::haptic
