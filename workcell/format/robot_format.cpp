// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/robot_format.h"

#include <utility>

namespace hapticell::workcell {

namespace {

Json jsonFromJoints(const Entity& entity) {
  Json joints = Json::object();
  for (std::size_t k = 0; k < entity.joints().size(); ++k) {
    joints[entity.robot()->joints[static_cast<std::size_t>(entity.robot()->moving[k])].name] = entity.joints()[k];
  }
  return joints;
}

Json jsonFromTools(const Entity& entity) {
  Json tools = Json::array();
  for (const ToolFrame& tool : entity.jointed().tools) {
    tools.push_back({{"name", tool.name}, {"tip_link", tool.tip_link}, {"placement", toJson(tool.X_LT)}});
  }
  return tools;
}

Json jsonFromPoses(const Entity& entity) {
  Json poses = Json::array();
  for (const kinematics::NamedPose& pose : entity.jointed().named_poses) {
    Json joints = Json::object();
    for (std::size_t i = 0; i < pose.q.size(); ++i) {
      joints[entity.robot()->joints[static_cast<std::size_t>(entity.robot()->moving[i])].name] = pose.q[i];
    }
    poses.push_back({{"name", pose.name}, {"joints", joints}});
  }
  return poses;
}

/// Positions by the joints' names; those that are not there as in `before`, or at rest where that is empty.
std::vector<double> readJoints(const Json& json, const Text& place, const FormatContext& context,
                               const kinematics::RobotModel& model, const std::vector<double>& before) {
  FieldReader fields(json, Text("%1, \"%2\"", place, "joints"), context.error);
  std::vector<double> positions = before.size() == model.dof() ? before : kinematics::restPositions(model);
  for (std::size_t i = 0; i < model.moving.size(); ++i) {
    fields.read(model.joints[static_cast<std::size_t>(model.moving[i])].name.c_str(), positions[i]);
  }
  if (!context.error) fields.warnAboutOthers(context.diagnostics);
  return positions;
}

void readTools(const Json& tools, const Text& place, const FormatContext& context, Entity& entity) {
  for (const Json& json : tools) {
    ToolFrame tool;
    FieldReader fields(json, Text("%1, tool %2", place, entity.jointed().tools.size() + 1), context.error);
    fields.require("name");
    fields.read("name", tool.name);
    fields.read("tip_link", tool.tip_link);
    fields.read("placement", tool.X_LT);
    if (!context.error) fields.warnAboutOthers(context.diagnostics);
    entity.editJointed().tools.push_back(std::move(tool));
  }
}

void readPoses(const Json& poses, const Text& place, const FormatContext& context, Entity& entity) {
  for (const Json& json : poses) {
    kinematics::NamedPose pose;
    const Text here = Text("%1, pose %2", place, entity.jointed().named_poses.size() + 1);
    FieldReader fields(json, here, context.error);
    fields.require("name");
    fields.read("name", pose.name);
    const Json* joints = fields.object("joints");
    pose.q =
        joints ? readJoints(*joints, here, context, *entity.robot(), {}) : kinematics::restPositions(*entity.robot());
    if (!context.error) fields.warnAboutOthers(context.diagnostics);
    entity.editJointed().named_poses.push_back(std::move(pose));
  }
}

}  // namespace

void addRobotFields(const Entity& entity, Json& json) {
  if (entity.robot()) {
    json["joints"] = jsonFromJoints(entity);
    json["tip_link"] = entity.jointed().tip_link;
    json["tool"] = toJson(entity.jointed().X_LT);
  }
  if (!entity.jointed().tools.empty()) json["tools"] = jsonFromTools(entity);
  if (!entity.jointed().tool.empty()) json["chosen_tool"] = entity.jointed().tool;
  if (!entity.jointed().named_poses.empty()) json["poses"] = jsonFromPoses(entity);
}

void readRobotFields(FieldReader& fields, const Text& place, const FormatContext& context, Entity& entity) {
  if (!entity.robot()) return;
  if (const Json* tools = fields.array("tools")) readTools(*tools, place, context, entity);
  if (const Json* poses = fields.array("poses")) readPoses(*poses, place, context, entity);
  Jointed& robot = entity.editJointed();
  fields.read("chosen_tool", robot.tool);
  fields.read("tip_link", robot.tip_link);
  fields.read("tool", robot.X_LT);
  if (const Json* joints = fields.object("joints")) {
    robot.joints = readJoints(*joints, place, context, *robot.model, robot.joints);
  }
}

}  // namespace hapticell::workcell
