// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/presence_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/haptic/devices/scripted_driver.h"

namespace hapticell::haptic {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(PresenceWatch, TellsWhoSeesOthersOnce) {
  driver::ScriptedDriver first, second;
  first.seen = 7, second.seen = 8;
  PresenceWatch watch({{"first.so", &first, {}}, {"broken.so", nullptr, {}}, {"second.so", &second, {}}});
  EXPECT_THAT(watch.look(), IsEmpty());
  second.seen = 9;
  EXPECT_THAT(watch.look(), ElementsAre(2));
  EXPECT_THAT(watch.look(), IsEmpty());
  first.seen = second.seen = 3;
  EXPECT_THAT(watch.look(), ElementsAre(0, 2));
  EXPECT_EQ(first.opened + second.opened, 0);
}

TEST(PresenceWatch, LeavesOutWhoCannotTell) {
  driver::ScriptedDriver mute;
  PresenceWatch watch({{"mute.so", &mute, {}}});
  mute.seen = 5;
  EXPECT_THAT(watch.look(), IsEmpty());
}

TEST(PresenceNumber, IsAnotherForAnythingElse) {
  const auto of = [](std::initializer_list<const char*> texts) {
    driver::PresenceNumber number;
    for (const char* text : texts) number.add(text);
    return number.value();
  };
  EXPECT_EQ(of({"ab", "c"}), of({"ab", "c"}));
  EXPECT_NE(of({"ab", "c"}), of({"a", "bc"}));
  EXPECT_NE(of({"ab", "c"}), of({"c", "ab"}));
  EXPECT_NE(of({}), of({""}));
  EXPECT_NE(of({}), 0u);
}

}  // namespace
}  // namespace hapticell::haptic
