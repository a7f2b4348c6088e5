// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/cell_sources.h"

#include "exchange/recordings/recording_reader.h"
#include "haptic/client/server_address.h"
#include "haptic/client/server_watch.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::bridge {

using workcell::Entity;

Expected<std::shared_ptr<const Entity>> robotToPublish(const workcell::Document& document, const std::string& entity,
                                                           const std::string& cell) {
  std::shared_ptr<const Entity> found;
  std::string names;
  int robots = 0;
  for (const auto& candidate : document.state().entities) {
    if (!workcell::isMachine(*candidate)) continue;
    if (!entity.empty() && candidate->name == entity) return candidate;
    names += (names.empty() ? "" : ", ") + candidate->name;
    found = candidate;
    ++robots;
  }
  if (entity.empty() && robots == 1) return found;
  return makeError({.file = cell,
                    .place = entity.empty() ? Text("robots") : Text("entity '%1'", entity),
                    .found = names.empty() ? Text("no robot") : Text("the robots %1", names),
                    .expected = "one robot",
                    .fix = "Name it by --entity."});
}

Expected<manipulation::MotionReplay> replayOfFile(const workcell::Document& document, const Entity& robot,
                                                  const std::string& file, std::vector<Text>& notes) {
  auto motion = exchange::isMcapFile(file) ? exchange::readMcapMotion(file, {}, &notes) : trajectory::readTrajectory(file, &notes);
  HAPTICELL_TRY(motion);
  auto replay = manipulation::MotionReplay::create(document.state().entities, robot.name,
                                                   std::make_shared<const trajectory::Trajectory>(std::move(*motion)));
  if (!replay) replay.error().file = file;
  return replay;
}

Expected<std::unique_ptr<haptic::TcpLink>> watchedServer(const std::string& server, std::string_view option) {
  if (server.empty()) return std::unique_ptr<haptic::TcpLink>();
  const auto address = haptic::parseServerAddress(server, option);
  HAPTICELL_TRY(address);
  return haptic::watchServer(address->host, address->port, "hapticell-ros2");
}

}  // namespace hapticell::bridge
