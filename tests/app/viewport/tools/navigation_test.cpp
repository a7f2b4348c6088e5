// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/tools/navigation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace hapticell::app {
namespace {

using Motion = std::optional<ViewMotion>;

TEST(Navigation, EveryPresetTurnsShiftsAndZoomsByGesturesOfItsOwn) {
  for (const QString& name : navigationPresets()) {
    const Navigation preset = navigationPreset(name);
    for (const ViewMotion motion : {ViewMotion::kOrbit, ViewMotion::kPan, ViewMotion::kZoom}) {
      ASSERT_FALSE(preset.of(motion).empty()) << name.toStdString();
      for (const ViewGesture& gesture : preset.of(motion))
        EXPECT_EQ(preset.motionFor(gesture.buttons, gesture.modifiers, gesture.released), Motion(motion))
            << name.toStdString() << " " << gestureText(gesture, true).toStdString();
    }
  }
}

TEST(Navigation, TheDefaultLeavesTheLeftAndTheRightButtonFree) {
  const Navigation usual = navigationPreset("hapticell");
  for (const auto modifiers : {Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier}) {
    EXPECT_FALSE(usual.uses(Qt::LeftButton, modifiers));
    EXPECT_FALSE(usual.uses(Qt::RightButton, modifiers));
  }
  EXPECT_EQ(usual.motionFor(Qt::MiddleButton, Qt::NoModifier), Motion(ViewMotion::kOrbit));
  EXPECT_EQ(usual.motionFor(Qt::MiddleButton, Qt::ShiftModifier), Motion(ViewMotion::kPan));
}

TEST(Navigation, CatiaTurnsWithTwoButtonsAndZoomsOnceOneOfThemIsLetGo) {
  const Navigation catia = navigationPreset("catia");
  EXPECT_EQ(catia.motionFor(Qt::MiddleButton, Qt::NoModifier), Motion(ViewMotion::kPan));
  EXPECT_EQ(catia.motionFor(Qt::MiddleButton | Qt::LeftButton, Qt::NoModifier), Motion(ViewMotion::kOrbit));
  EXPECT_EQ(catia.motionFor(Qt::MiddleButton, Qt::NoModifier, true), Motion(ViewMotion::kZoom));
}

RC_GTEST_PROP(Navigation, WhatIsWrittenIsReadAgain, ()) {
  Navigation own;
  const auto gesture = [] {
    ViewGesture made;
    made.buttons = Qt::MouseButtons(*rc::gen::inRange(1, 8));
    if (*rc::gen::arbitrary<bool>()) made.modifiers |= Qt::ShiftModifier;
    if (*rc::gen::arbitrary<bool>()) made.modifiers |= Qt::ControlModifier;
    if (*rc::gen::arbitrary<bool>()) made.modifiers |= Qt::AltModifier;
    made.released = *rc::gen::arbitrary<bool>();
    return made;
  };
  for (const ViewMotion motion : {ViewMotion::kOrbit, ViewMotion::kPan, ViewMotion::kZoom})
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) own.of(motion).push_back(gesture());
  own.wheel_turns = *rc::gen::arbitrary<bool>();
  own.wheel_reversed = *rc::gen::arbitrary<bool>();
  own.zoom_to_pointer = *rc::gen::arbitrary<bool>();
  const auto read = navigationFromText(navigationText(own));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == own);
}

TEST(Navigation, WhatIsNoneIsRefused) {
  for (const char* text : {"", ";;", "middle;shift+middle;x;", "shift;middle;middle;", "middle;middle;middle"})
    EXPECT_FALSE(navigationFromText(text).has_value()) << text;
}

}  // namespace
}  // namespace hapticell::app
