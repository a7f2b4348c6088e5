// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/configuration.h"

namespace hapticell::config {

/// The one list of keys: calls `visit` with (key, value, limits) for each setting. Reading a file, setting one key and
/// listing all are three visitors of it.
struct NumberRange {
  double min, max;
};
using Choices = std::vector<std::string>;  ///< Empty: any text.

template <typename AnyConfiguration, typename Visitor>
void visitSettings(AnyConfiguration& c, Visitor&& visit) {
  visit("haptic.rate_hz", c.haptic.rate_hz, NumberRange{100, 4000});
  visit("haptic.device", c.haptic.device, Choices{});
  visit("haptic.stiffness", c.haptic.stiffness, NumberRange{0, 10000});
  visit("haptic.damping", c.haptic.damping, NumberRange{0, 50});
  visit("haptic.force_ramp_s", c.haptic.force_ramp_s, NumberRange{0.05, 1});
  visit("server.host", c.server.host, Choices{});
  visit("server.port", c.server.port, NumberRange{1, 65535});
  visit("manipulation.rate_hz", c.manipulation.rate_hz, NumberRange{10, 1000});
  visit("manipulation.zone_radius", c.manipulation.zone_radius, NumberRange{0.005, 0.5});
  visit("manipulation.hold_to_move", c.manipulation.hold_to_move, NumberRange{0, 1});
  visit("manipulation.on_contact", c.manipulation.on_contact, Choices{"stop", "slide", "pass"});
  visit("manipulation.force_class", c.manipulation.force_class, Choices{"constant", "contact", "dynamics"});
  visit("manipulation.safety_distance", c.manipulation.safety_distance, NumberRange{0, 1});
  visit("manipulation.near_miss", c.manipulation.near_miss, NumberRange{0, 10});
  visit("manipulation.gravity_compensation", c.manipulation.gravity_compensation, NumberRange{0, 1});
  visit("manipulation.edge_drift", c.manipulation.edge_drift, NumberRange{0, 0.5});
  visit("manipulation.plan_authority", c.manipulation.plan_authority, NumberRange{0, 1});
  visit("manipulation.plan_clearance", c.manipulation.plan_clearance, NumberRange{0, 0.1});
  visit("manipulation.felt_mass", c.manipulation.felt_mass, NumberRange{0, 2});
  visit("manipulation.load_damping", c.manipulation.load_damping, NumberRange{0, 20});
  visit("robot.at_singularity", c.robot.at_singularity,
        Choices{"keep_position", "keep_orientation", "keep_joint_4", "stop"});
  visit("robot.self_collision", c.robot.self_collision, NumberRange{0, 1});
  visit("scale.rough", c.scale.rough, NumberRange{0.001, 1000});
  visit("scale.medium", c.scale.medium, NumberRange{0.001, 1000});
  visit("scale.fine", c.scale.fine, NumberRange{0.001, 1000});
  visit("scale.screen", c.scale.screen, NumberRange{0.01, 100});
  visit("scale.rotation", c.scale.rotation, NumberRange{0.01, 10});
  visit("gui.rate_hz", c.gui.rate_hz, NumberRange{10, 240});
  visit("gui.theme", c.gui.theme, Choices{"dark", "light"});
  visit("gui.motion", c.gui.motion, NumberRange{0, 1});
  visit("gui.sound", c.gui.sound, NumberRange{0, 1});
  visit("gui.original_colors", c.gui.original_colors, NumberRange{0, 1});
  visit("hand.mass", c.hand.mass, NumberRange{0.01, 10});
  visit("hand.stiffness", c.hand.stiffness, NumberRange{0, 5000});
  visit("hand.damping", c.hand.damping, NumberRange{0, 100});
  for (auto& [name, material] : c.materials) {
    visit("materials." + name + ".stiffness", material.stiffness, NumberRange{1, 10000});
    visit("materials." + name + ".damping", material.damping, NumberRange{0, 50});
    visit("materials." + name + ".friction", material.friction, NumberRange{0, 2});
  }
}

}  // namespace hapticell::config
