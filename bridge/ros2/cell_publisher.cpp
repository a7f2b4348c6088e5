// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/cell_publisher.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>
#include <vector>

#include "bridge/ros2/cell_sources.h"
#include "bridge/ros2/contact_markers.h"
#include "bridge/ros2/published_cell.h"
#include "bridge/ros2/ros_conversion.h"
#include "geometry/system/scratch_folder.h"
#include "haptic/client/tcp_link.h"
#include "manipulation/checks/motion_replay.h"
#include "workcell/format/document_io.h"

namespace hapticell::bridge {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using nlohmann::ordered_json;

/// The motion, sent once to a controller that listens.
Expected<void> sendTrajectory(RosNode& node, const manipulation::MotionReplay& replay, const PublishOptions& options,
                              const std::atomic<bool>& stop) {
  const trajectory::Trajectory motion = replay.withJoints();
  if (!motion.hasJoints())
    return makeError({.file = options.motion, .place = "joints", .found = "none", .expected = "a motion of a robot"});
  const auto writer =
      node.advertise(options.trajectory_topic, trajectory_msgs_msg_dds__JointTrajectory__desc, RosQuality::kDefault);
  HAPTICELL_TRY(writer);
  const auto end = Clock::now() + std::chrono::duration<double>(options.wait);
  while (node.readersOf(*writer) == 0) {
    if (Clock::now() > end || stop)
      return makeError({.file = options.trajectory_topic,
                        .found = "no reader",
                        .expected = "a controller that listens on this topic",
                        .fix = "Start the controller, or use a longer --wait."});
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const JointTrajectoryMessage message(motion);
  HAPTICELL_TRY(node.write(*writer, message.message()));
  if (!node.flush(options.wait))
    return makeError({.file = options.trajectory_topic,
                      .found = "the reader did not acknowledge the motion",
                      .expected = "an acknowledgement"});
  return {};
}

}  // namespace

Expected<ordered_json> publishCell(const PublishOptions& options, const std::atomic<bool>& stop) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.workcell, notes);
  HAPTICELL_TRY(document);
  const auto robot = robotToPublish(*document, options.entity, options.workcell);
  HAPTICELL_TRY(robot);
  std::optional<manipulation::MotionReplay> replay;
  if (!options.motion.empty()) {
    auto read = replayOfFile(*document, **robot, options.motion, notes.warnings);
    HAPTICELL_TRY(read);
    replay = std::move(*read);
  }
  if (!options.trajectory_topic.empty() && !replay)
    return makeError({.place = "--trajectory", .found = "--motion is missing", .expected = "a motion to send"});
  if (options.contacts && !replay)
    return makeError({.place = "--contacts", .found = "--motion is missing", .expected = "a motion"});
  const auto scratch = ScratchFolder::make();
  HAPTICELL_TRY(scratch);
  auto description = robotDescription(**robot, options.folder.empty() ? scratch->path() : fs::path(options.folder), notes);
  HAPTICELL_TRY(description);
  const auto link = watchedServer(options.server, "--server");
  HAPTICELL_TRY(link);
  auto node = RosNode::create(options.node);
  HAPTICELL_TRY(node);
  PublishedCell publisher(**node, *document, *robot, replay, options.simulated_clock);
  HAPTICELL_TRY(publisher.open());
  if (*link) HAPTICELL_TRY(publisher.openStylus());
  if (options.contacts) {
    auto markers = ContactMarkers::create(*document, (*robot)->name, *replay, options.rate_hz);
    HAPTICELL_TRY(markers);
    HAPTICELL_TRY(publisher.openContacts(std::move(*markers)));
  }
  HAPTICELL_TRY(publisher.publishLatched(std::move(*description)));
  if (!options.trajectory_topic.empty()) HAPTICELL_TRY(sendTrajectory(**node, *replay, options, stop));

  const double start = replay ? replay->motion()[0].t : 0.0;
  const double duration = replay ? replay->motion().duration() : 0.0;
  const double length = options.seconds > 0.0 || options.repeat ? options.seconds : duration;
  const bool is_endless = options.seconds == 0.0 && (!replay || options.repeat);
  const auto begin = Clock::now();
  std::uint64_t ticks = 0, late = 0;
  for (; !stop; ++ticks) {
    const double t = static_cast<double>(ticks) / options.rate_hz;
    if (!is_endless && t > std::max(length, options.repeat ? 0.0 : duration)) break;
    const auto due = begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(t));
    std::this_thread::sleep_until(due);
    if (Clock::now() - due > std::chrono::milliseconds(5)) ++late;
    const double moved = options.repeat && duration > 0.0 ? std::fmod(t, duration) : std::min(t, duration);
    HAPTICELL_TRY(publisher.publishMoment(t, start + moved));
    if (!*link) continue;
    if (const auto state = (*link)->latestState()) HAPTICELL_TRY(publisher.publishStylus(*state, t));
  }
  HAPTICELL_TRY(publisher.publishEnd(static_cast<double>(ticks) / options.rate_hz));
  ordered_json result = publisher.result();
  (*node)->flush(1.0);
  result["ticks"] = ticks;
  result["late_5ms"] = late;
  result["assumptions"] = ordered_json::array();
  for (const Text& note : notes.warnings) result["assumptions"].push_back(english(note));
  return result;
}

}  // namespace hapticell::bridge
