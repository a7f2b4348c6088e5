// SPDX-License-Identifier: Apache-2.0
#include "cli/session/session_recording.h"

#include <string>

namespace hapticell::cli {

namespace {

/// "robot/link_3"; "fixture" where the part has the entity's name.
std::string partName(const manipulation::SessionOptions& options, workcell::EntityId id, const std::string& part) {
  for (const workcell::Entity& entity : options.entities) {
    if (entity.id != id) continue;
    if (part.empty() || part == entity.name) return entity.name;
    return part.starts_with(entity.name + "/") ? part : entity.name + "/" + part;
  }
  return part;
}

}  // namespace

exchange::StylusSample stylusSampleOf(const manipulation::TraceRow& row) {
  return {row.t, row.X_DS, row.X_DP, row.force_D, row.torque_D, row.buttons, row.contact, row.X_WM};
}

void addSession(exchange::Recording& recording, const manipulation::SessionReport& report,
                const manipulation::SessionOptions& options, const nlohmann::ordered_json& result) {
  recording.has_moved_frame = true;
  if (!report.recording.empty()) recording.motions.push_back(report.recording);
  for (const trajectory::Trajectory& other : report.other_recordings)
    if (!other.empty()) recording.motions.push_back(other);
  for (const manipulation::ContactInterval& contact : report.contacts) {
    recording.contacts.push_back({contact.time_in, contact.time_out,
                                  partName(options, contact.entity, contact.moved_part),
                                  partName(options, contact.other, contact.other_part), contact.max_force});
  }
  nlohmann::ordered_json kept = result;
  kept.erase("timing");  // Of the machine, not of the session.
  recording.files.emplace_back("session.json", kept.dump(1) + "\n");
}

}  // namespace hapticell::cli
