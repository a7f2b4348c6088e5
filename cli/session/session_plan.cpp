// SPDX-License-Identifier: Apache-2.0
#include "cli/session/session_plan.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "planning/live/live_planner.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/csv_table.h"

namespace hapticell::cli {

namespace {

/// A quaternion typed with three digits is within this of length 1. Half: such ones are refused; twice: slips pass.
constexpr double kTypedUnit = 1e-2;

tl::unexpected<Error> noGoal(const std::string& text) {
  return makeError({.place = "--set plan_goal",
                    .found = "'" + text + "'",
                    .expected = "out, frame:NAME, pose:x,y,z,qw,qx,qy,qz (metres and a quaternion of length 1) or "
                                "joints:q1,q2,... (radians or metres)"});
}

std::optional<std::vector<double>> goalNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = trajectory::parseNumber(text.substr(begin, end - begin));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

/// Where a frame of an entity, or an entity itself, stands in the document.
Expected<Pose> frameByName(const std::string& name, const manipulation::SessionOptions& options) {
  for (const workcell::Entity& entity : options.entities) {
    if (entity.name == name) return entity.X_WE;
    for (const workcell::Frame& frame : entity.frames)
      if (frame.name == name) return entity.X_WE * frame.X_EF;
  }
  return makeError({.place = "--set plan_goal",
                    .found = Text("no frame is named '%1'", name),
                    .expected = "the name of an entity or of a frame of one"});
}

Expected<planning::Goal> parseGoal(const std::string& text, const manipulation::SessionOptions& options) {
  if (text == "out") return planning::Goal(planning::goal::OutOfCell{});
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon), rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "frame" && !rest.empty()) {
    const auto pose = frameByName(rest, options);
    HAPTICELL_TRY(pose);
    return planning::Goal(planning::goal::ToPose{*pose});
  }
  const auto numbers = goalNumbers(rest);
  if (!numbers) return noGoal(text);
  if (kind == "joints") return planning::Goal(planning::goal::ToJoints{*numbers});
  if (kind != "pose" || numbers->size() != 7) return noGoal(text);
  const std::vector<double>& n = *numbers;
  const dquat q(n[3], n[4], n[5], n[6]);
  if (std::abs(glm::length(q) - 1.0) > kTypedUnit) return noGoal(text);
  return planning::Goal(planning::goal::ToPose{{{n[0], n[1], n[2]}, glm::normalize(q)}});
}

Expected<void> checkJoints(const planning::Goal& goal, const manipulation::SessionOptions& options) {
  const auto* to = std::get_if<planning::goal::ToJoints>(&goal);
  if (to == nullptr) return {};
  for (const workcell::Entity& entity : options.entities) {
    if (entity.name != options.entity || entity.joints().size() == to->joints.size()) continue;
    return makeError({.place = "--set plan_goal",
                      .found = Text("%1 joints", to->joints.size()),
                      .expected = Text("%1: one a variable of '%2'", entity.joints().size(), entity.name)});
  }
  return {};
}

}  // namespace

Expected<void> addPlanner(const SessionPlanWords& words, bool realtime, manipulation::SessionOptions& options) {
  if (words.goal.empty()) {
    if (words.hints.empty()) return {};
    return makeError({.place = "--set plan_hints", .found = "no plan_goal", .expected = "--set plan_goal=... with it"});
  }
  const auto goal = parseGoal(words.goal, options);
  HAPTICELL_TRY(goal);
  HAPTICELL_TRY(checkJoints(*goal, options));
  planning::LiveOptions live;
  live.goal = *goal;
  live.clearance = options.configuration.manipulation.plan_clearance;
  live.in_virtual_time = !realtime;
  if (!words.hints.empty()) {
    const auto motion = trajectory::readTrajectory(words.hints);
    HAPTICELL_TRY(motion);
    for (const trajectory::Trajectory::Frame& frame : motion->frames()) live.hints.push_back(frame.X_WT);
  }
  options.assistance = {std::make_shared<planning::LivePlanner>(std::move(live), options.configuration),
                        options.configuration.manipulation.plan_authority};
  return {};
}

nlohmann::ordered_json planJson(const manipulation::SessionPlan& plan, const manipulation::SessionOptions& options) {
  nlohmann::ordered_json json{{"solved", plan.solved},
                              {"solved_s", plan.solved ? nlohmann::ordered_json(plan.solved_s) : nullptr},
                              {"ways", plan.ways},
                              {"insistences", plan.insistences}};
  // What addPlanner() made.
  const auto& planner = static_cast<const planning::LivePlanner&>(*options.assistance->planner);
  const planning::LivePlanner::Figures figures = planner.figures();
  json["searches"] = figures.searches;
  json["searches_found"] = figures.found;
  json["failure"] = figures.failure ? nlohmann::ordered_json(english(figures.failure->reason)) : nullptr;
  json["authority"] = nlohmann::ordered_json::array();
  for (const auto& [t, value] : plan.authority) json["authority"].push_back({t, value});
  return json;
}

}  // namespace hapticell::cli
