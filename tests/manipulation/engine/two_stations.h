// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/in_memory_link.h"
#include "manipulation/engine/second_stylus.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/figure_model.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {

inline constexpr workcell::EntityId kWorker = 7, kShelf = 8, kBox = 9;

inline workcell::Entity worker(const char* posture) {
  workcell::EntityLoader loader(".");
  Diagnostics diagnostics;
  workcell::Entity entity = *loader.load("mannequin:male:50", 1.0, diagnostics);
  entity.id = kWorker;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure(), *mannequin::libraryPosture(*entity.figure(), posture));
  entity.X_WE = model.X_WE;
  entity.setJoints(model.joints);
  return entity;
}

inline Pose gripOf(const workcell::Entity& figure, const EntityConfiguration& at, mannequin::Side side) {
  const auto pose =
      mannequin::forwardKinematics(*figure.figure(), mannequin::toPosture(*figure.figure(), {at.X_WE, at.joints}));
  return mannequin::handPose(pose, side);
}

inline config::DeviceProfile withTwoButtons() {
  config::DeviceProfile profile;
  profile.buttons = 2;
  return profile;
}

/// A stylus with all that belongs to it, in virtual time.
struct Station {
  Station() : loop(opened(), clock, haptic::configuredLoop(device, {})) {}
  haptic::Device& opened() {
    EXPECT_TRUE(device.open());
    device.place({});
    return device;
  }
  std::unique_ptr<haptic::InMemoryLink> makeLink() {
    auto made = std::make_unique<haptic::InMemoryLink>(loop, clock, haptic::describe(device));
    link = made.get();
    return made;
  }
  void hold(const dvec3& p_D, bool pressed = false) { device.hand().hold(Pose::translation(p_D), pressed ? 1 : 0); }
  double force() const { return glm::length(loop.current().force_D); }

  haptic::VirtualClock clock;
  haptic::SimulatedDevice device{withTwoButtons()};
  haptic::ForceLoop loop;
  haptic::InMemoryLink* link = nullptr;
};

/// Both styluses on one cell; a step of both every ten ticks.
struct TwoStations {
  explicit TwoStations(std::vector<workcell::Entity> entities) : cell(std::move(entities)) {
    first_link = a.makeLink();
    first = std::make_unique<ManipulationEngine>(*first_link, configuration);
    second = std::make_unique<SecondStylus>(b.makeLink(), *first);
    const auto scene = PreparedScene::prepare(cell, {}, {0.001, 0.01}, nullptr);
    first->setScene(scene);
    for (const Command& command :
         {Command(command::SetAxes{{AxesMode::kCell, {}}}), Command(command::SetForces{true})}) {
      first->apply(command);
      second->holder().apply(command);
    }
    a.hold({});
    b.hold({});
    run(2000);
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      a.link->step();
      b.link->step();
      if (i % 10 != 0) continue;
      first->step(a.clock.now());
      second->step(a.clock.now());
    }
  }
  void takeBothHands() {
    first->apply(command::SetMovedBy{by::Hand{.side = mannequin::Side::kRight, .locks = {.trunk = true}}});
    second->holder().apply(command::SetMovedBy{by::Hand{.side = mannequin::Side::kLeft, .locks = {.trunk = true}}});
    first->apply(command::Grab{kWorker});
    run(20);
    second->holder().apply(command::Grab{kWorker});
    run(20);
    ASSERT_NE(first->held(), nullptr);
    ASSERT_NE(second->holder().held(), nullptr);
  }

  config::Configuration configuration;
  std::vector<workcell::Entity> cell;
  Station a, b;
  std::unique_ptr<haptic::InMemoryLink> first_link;
  std::unique_ptr<ManipulationEngine> first;
  std::unique_ptr<SecondStylus> second;
};

}  // namespace hapticell::manipulation
