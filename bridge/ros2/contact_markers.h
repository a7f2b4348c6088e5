// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros2_messages.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "manipulation/checks/motion_replay.h"
#include "workcell/document/document.h"

namespace hapticell::bridge {

/// The contacts of a motion as visualization_msgs/MarkerArray, in the frame "world".
///
/// A pair is in contact while the motion lists it (the contacts of the session that it was recorded in; the parts then
/// are the safety distance apart), or while its meshes intersect and did not at the first moment (a robot on its table).
/// Each contact has the namespace "FIRST / SECOND" and two markers: the arrow `kArrow` begins at the place, points along
/// the normal towards the moved part and is as long as the recorded force along it; the ball `kBall` at the place is as
/// wide as the parts are deep in each other. One thread.
class ContactMarkers {
 public:
  static constexpr std::int32_t kArrow = 0, kBall = 1;  ///< Marker::id.
  // Lengths in m. kShortest is the length of an arrow without a force and the width of a ball without depth.
  static constexpr double kShortest = 0.010;     // A finger's width in RViz. Half: lost beside the robot; twice: hides it.
  static constexpr double kLengthPerN = 0.010;   // 10 N, a firm push, are 0.1 m. Half and twice: still on the screen.

  /// Prepares the cell: as long as its meshes need. `rate_hz`: how often update() is called. Errors: the entity is locked
  /// or cannot move in this way.
  static Expected<std::unique_ptr<ContactMarkers>> create(const workcell::Document& cell, const std::string& entity,
                                                          const manipulation::MotionReplay& replay, double rate_hz);
  ~ContactMarkers();

  /// The markers of `t` (s of the motion): those in contact are added or changed, those that were and are no more are
  /// deleted. Null: nothing to say. Valid until the next call.
  const visualization_msgs_msg_dds__MarkerArray_* update(std::int64_t stamp_ns, double t);
  /// Deletes all markers. Null: nothing is shown.
  const visualization_msgs_msg_dds__MarkerArray_* clear(std::int64_t stamp_ns);

 private:
  class Contacts;
  ContactMarkers(std::unique_ptr<Contacts> contacts, double rate_hz);
  void add(std::int64_t stamp_ns, const std::string& name, std::int32_t id, std::int32_t action);
  const visualization_msgs_msg_dds__MarkerArray_* message();

  std::unique_ptr<Contacts> contacts_;
  double lifetime_;
  std::vector<std::string> shown_;  ///< Namespaces with markers.
  std::deque<std::string> names_;   ///< Those of the message.
  std::vector<visualization_msgs_msg_dds__Marker_> markers_;
  visualization_msgs_msg_dds__MarkerArray_ message_{};
};

}  // namespace hapticell::bridge
