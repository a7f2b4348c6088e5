// SPDX-License-Identifier: Apache-2.0
#include "cli/session/session_report.h"

#include "cli/kit/result_writer.h"
#include "cli/session/session_plan.h"

namespace hapticell::cli {

namespace {

using manipulation::SessionOptions;
using manipulation::SessionReport;
using nlohmann::ordered_json;

ordered_json poseJson(const Pose& pose) {
  return {{"position", toJson(pose.p)}, {"quaternion", {pose.q.w, pose.q.x, pose.q.y, pose.q.z}}};
}

ordered_json contactsJson(const SessionReport& report, const SessionOptions& options) {
  const auto nameOf = [&](workcell::EntityId id) {
    for (const workcell::Entity& entity : options.entities) {
      if (entity.id == id) return entity.name;
    }
    return std::string();
  };
  ordered_json contacts = ordered_json::array();
  for (const manipulation::ContactInterval& event : report.contacts) {
    contacts.push_back({{"entities", {nameOf(event.entity), nameOf(event.other)}},
                        {"parts", {event.moved_part, event.other_part}},
                        {"time_in", event.time_in},
                        {"time_out", event.time_out},
                        {"max_force", event.max_force}});
  }
  return contacts;
}

const kinematics::RobotModel* modelOf(const SessionOptions& options) {
  for (const workcell::Entity& entity : options.entities) {
    if (entity.name == options.entity) return entity.robot().get();
  }
  return nullptr;
}

ordered_json limitsJson(const SessionReport& report, const kinematics::RobotModel* model) {
  ordered_json limits = ordered_json::array();
  for (const manipulation::LimitInterval& event : report.limits) {
    ordered_json json = {{"kind", toString(event.kind)}, {"text", event.text}};
    if (model && event.joint >= 0) json["joint"] = model->joints[static_cast<std::size_t>(event.joint)].name;
    json["time_in"] = event.time_in;
    json["time_out"] = event.time_out;
    limits.push_back(json);
  }
  return limits;
}

ordered_json jointsJson(const SessionReport& report, const kinematics::RobotModel* model) {
  ordered_json joints = ordered_json::array();
  for (const manipulation::JointUse& use : report.joints) {
    if (!model) break;
    joints.push_back({{"name", model->joints[static_cast<std::size_t>(use.joint)].name},
                      {"lowest", use.lowest},
                      {"highest", use.highest},
                      {"max_speed", use.max_speed},
                      {"speed_limit", use.greatest_speed}});
  }
  return joints;
}

}  // namespace

ordered_json sessionJson(const SessionReport& report, const SessionOptions& options) {
  ordered_json axes = ordered_json::array();
  for (const auto& [name, at] : report.end.axes) {
    axes.push_back({{"name", name}, {"pose", poseJson(at.X_WE)}, {"joints", at.joints}});
  }
  ordered_json json = {
      {"entity", options.entity},
      {"assumptions", options.hand.assumptions()},
      {"duration_s", report.duration_s},
      {"rates",
       {{"haptic_hz", report.rate_haptic_hz},
        {"manipulation_hz", report.rate_manipulation_hz},
        {"gui_hz", report.rate_gui_hz}}},
      {"ticks", report.ticks},
      {"ticks_missed", report.ticks_missed},
      {"latency", {{"p50_ms", report.delays.latency_p50_ms}, {"p99_ms", report.delays.latency_p99_ms}}},
      {"force", {{"max_n", report.forces.force_max_n}, {"max_step_n_per_ms", report.forces.force_max_step_n_per_ms}}},
      {"penetration",
       {{"max_m", report.forces.penetration_max_m}, {"blocked_max_m", report.forces.penetration_blocked_m}}},
      {"energy", {{"min_j", report.forces.energy_min_j}}},
      {"contacts", contactsJson(report, options)},
      {"limits", limitsJson(report, modelOf(options))},
      {"joints", jointsJson(report, modelOf(options))},
      {"final_state",
       {{"held", report.end.held},
        {"pose", poseJson(report.end.configuration.X_WE)},
        {"joints", report.end.configuration.joints},
        {"axes", std::move(axes)},
        {"moved_frame", poseJson(report.end.X_WM)},
        {"touches", report.end.contacts},
        {"limits", report.end.limits}}},
      {"timing",
       {{"machine_time_s", report.machine_time_s},
        {"step_median_ms", report.delays.step_median_ms},
        {"step_p99_ms", report.delays.step_p99_ms},
        {"step_max_ms", report.delays.step_max_ms}}}};
  if (report.plan) json["plan"] = planJson(*report.plan, options);
  return json;
}

}  // namespace hapticell::cli
