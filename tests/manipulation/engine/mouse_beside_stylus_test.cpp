// SPDX-License-Identifier: Apache-2.0
// A stylus in one hand and a 3-D mouse, which moves entities too, in the other: a driver's device as second stylus.
#include <gtest/gtest.h>

#include <string>

#include "haptic/devices/driver_device.h"
#include "tests/haptic/devices/scripted_driver.h"
#include "tests/manipulation/engine/two_stations.h"

namespace hapticell::manipulation {
namespace {

constexpr workcell::EntityId kHeld = kBox, kOther = kShelf;

workcell::Entity cube(workcell::EntityId id, const char* name, double x) {
  return test::solid(id, name, geometry::makeBox(dvec3(0.05)), Pose::translation({x, 0.0, 0.0}));
}

/// The stylus is simulated; the 3-D mouse speaks through its driver, called in virtual time.
struct StylusAndMouse {
  explicit StylusAndMouse(std::vector<workcell::Entity> cell) {
    first_link = stylus.makeLink();
    first = std::make_unique<ManipulationEngine>(*first_link, configuration);
    auto link = std::make_unique<haptic::InMemoryLink>(loop, clock, haptic::describe(device));
    mouse_link = link.get();
    second = std::make_unique<SecondStylus>(std::move(link), *first);
    const auto scene = PreparedScene::prepare(std::move(cell), {}, {0.001, 0.01}, nullptr);
    first->setScene(scene);
    first->apply(command::SetAxes{{AxesMode::kCell, {}}});
    second->holder().apply(command::SetAxes{{AxesMode::kCell, {}}});
    stylus.hold({});
    run(1000);
  }
  haptic::Device& opened() {
    driver.device.about.kind = driver::Kind::kSpaceMouse;
    driver.device.about.driven_axes = 0;
    driver.device.about.peak_force = 0.0;
    EXPECT_TRUE(device.open());
    return device;
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      stylus.link->step();
      mouse_link->step();
      if (i % 10 != 0) continue;
      first->step(stylus.clock.now());
      second->step(stylus.clock.now());
    }
  }
  /// Its cap is deflected along D's x for so long.
  void push(double deflection, int ticks) {
    driver.device.state.motion[0] = deflection;
    run(ticks);
    driver.device.state.motion[0] = 0.0;
    run(100);
  }
  void pressMouse() {
    for (const std::uint32_t buttons : {1u, 0u}) {
      driver.device.state.buttons = buttons;
      run(50);
    }
  }
  template <typename Holder>
  bool wasTold(Holder& holder, const std::string& sentence) {
    for (const Result& one : holder.takeResults()) {
      const auto* notice = std::get_if<result::Notice>(&one);
      if (notice && english(notice->sentence).find(sentence) != std::string::npos) return true;
    }
    return false;
  }
  dvec3 at(workcell::EntityId id) const { return first->placement(id).X_WE.p; }

  config::Configuration configuration;
  Station stylus;
  haptic::VirtualClock clock;
  driver::ScriptedDriver driver;
  haptic::DriverDevice device{driver, "", {.calls = haptic::DriverCalls::kInline}};
  haptic::ForceLoop loop{opened(), clock, haptic::configuredLoop(device, {})};
  haptic::InMemoryLink* mouse_link = nullptr;
  std::unique_ptr<haptic::InMemoryLink> first_link;
  std::unique_ptr<ManipulationEngine> first;
  std::unique_ptr<SecondStylus> second;
};

TEST(MouseBesideStylus, EachMovesWhatItHolds) {
  StylusAndMouse both({cube(kHeld, "held", -0.2), cube(kOther, "other", 0.2)});
  both.first->apply(command::Grab{kHeld});
  both.second->holder().apply(command::ChooseEntity{kOther});
  both.pressMouse();
  ASSERT_NE(both.second->holder().held(), nullptr);
  EXPECT_EQ(both.second->holder().held()->id(), kOther);
  const dvec3 held = both.at(kHeld), other = both.at(kOther);
  both.push(1.0, 200);  // 0.12 m/s for 0.2 s.
  EXPECT_NEAR(both.at(kOther).x - other.x, 0.024 * both.configuration.scale.medium, 0.002);
  EXPECT_LT(glm::length(both.at(kHeld) - held), 1e-4) << "that is the stylus's";
  both.stylus.hold({0.0, 0.0, 0.02});
  both.run(800);
  EXPECT_NEAR(both.at(kHeld).z - held.z, 0.02 * both.configuration.scale.medium, 0.002);
  both.pressMouse();
  EXPECT_EQ(both.second->holder().held(), nullptr) << "its button lets go";
  const dvec3 left_at = both.at(kOther);
  both.push(1.0, 200);
  EXPECT_EQ(both.at(kOther), left_at);
}

/// What the one holds the other does not take, whichever comes first, and says so.
TEST(MouseBesideStylus, TheSameEntityIsMovedByWhoTookItFirst) {
  StylusAndMouse both({cube(kHeld, "held", 0.0)});
  both.first->apply(command::Grab{kHeld});
  both.second->holder().apply(command::ChooseEntity{kHeld});
  both.run(20);
  both.pressMouse();
  EXPECT_EQ(both.second->holder().held(), nullptr);
  EXPECT_TRUE(both.wasTold(both.second->holder(), "held is held by the other stylus"));
  const dvec3 before = both.at(kHeld);
  both.push(1.0, 200);
  EXPECT_LT(glm::length(both.at(kHeld) - before), 1e-4);

  both.first->apply(command::Release{});
  both.run(20);
  both.pressMouse();
  ASSERT_NE(both.second->holder().held(), nullptr) << "it was let go";
  both.run(20);
  both.first->apply(command::Grab{kHeld});
  both.run(20);
  EXPECT_EQ(both.first->held(), nullptr);
  EXPECT_TRUE(both.wasTold(*both.first, "held is held by the other stylus"));
  both.push(1.0, 200);
  EXPECT_GT(both.at(kHeld).x, before.x + 0.01) << "now the 3-D mouse moves it";
}

/// What the 3-D mouse holds stops at what the stylus holds, and the stylus feels it when it presses.
TEST(MouseBesideStylus, WhatTheyHoldIsInEachOthersWay) {
  StylusAndMouse both({cube(kHeld, "held", 0.0), cube(kOther, "other", -0.08)});
  both.first->apply(command::SetForces{true});
  both.first->apply(command::Grab{kHeld});
  both.second->holder().apply(command::ChooseEntity{kOther});
  both.pressMouse();
  ASSERT_NE(both.second->holder().held(), nullptr);
  for (int i = 0; i < 10; ++i) both.push(1.0, 200);
  EXPECT_GT(both.at(kOther).x, -0.06) << "it was not moved";
  EXPECT_LE(both.at(kOther).x, both.at(kHeld).x - 0.05 + 1e-5) << "it went into what the stylus holds";
  both.stylus.hold({-0.01, 0.0, 0.0});
  both.run(1500);
  EXPECT_GT(both.stylus.force(), 0.3);
}

}  // namespace
}  // namespace hapticell::manipulation
