// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bridge/ros2/checked_motion.h"
#include "tests/support/test_data.h"

namespace hapticell::bridge {

/// A sliding robot of one joint, and a wall 0.5 m ahead.
struct SlideCell {
  test::TemporaryFolder folder;
  MotionToSend wanted;

  explicit SlideCell(double far, double duration, double velocity = 2.0) {
    folder.write("slide.urdf", R"(<robot name="slide"><link name="base"/><link name="block"><collision><geometry>
      <box size="0.1 0.1 0.1"/></geometry></collision><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
      <joint name="x" type="prismatic"><parent link="base"/><child link="block"/><axis xyz="1 0 0"/>
      <limit lower="-1" upper="1" velocity=")" + std::to_string(velocity) + R"(" effort="1"/></joint></robot>)");
    wanted.workcell = folder.write("cell.hcell", R"({"format": "hapticell-workcell", "version": 1, "entities": [
      {"name": "slide", "source": {"file": "slide.urdf"}},
      {"name": "wall", "source": {"file": "box:0.1,1,1"}, "placement": {"position": [0.5, 0, 0]}}]})").string();
    std::string rows;
    for (int i = 0; i <= 50; ++i) {
      const double s = i / 50.0;
      rows += std::string(i > 0 ? "," : "") + "[" + std::to_string(duration * s) + ",0,0,0,1,0,0,0," +
              std::to_string(far * s * s * (3.0 - 2.0 * s)) + "]";
    }
    wanted.motion = folder.write("motion.htraj", R"({"format": "hapticell-trajectory", "version": 1, "entity": "slide",
      "joints": ["x"], "has_poses": false, "frames": [)" + rows + "]}").string();
    wanted.action = "/a";
  }
};

}  // namespace hapticell::bridge
