// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/mechanism_format.h"

#include <cmath>
#include <limits>
#include <utility>

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kJointWords = {"fixed", "revolute", "prismatic", "screw"};

Json jsonFromJoint(const MechanismJoint& joint) {
  Json json;
  json["name"] = joint.name;
  json["type"] = wordOf(joint.type);
  json["parent"] = joint.parent;
  json["child"] = joint.child;
  json["point"] = {joint.p_MJ.x, joint.p_MJ.y, joint.p_MJ.z};
  json["axis"] = {joint.axis_M.x, joint.axis_M.y, joint.axis_M.z};
  if (std::isfinite(joint.lower)) json["lower"] = joint.lower;
  if (std::isfinite(joint.upper)) json["upper"] = joint.upper;
  json["velocity"] = joint.velocity;
  json["friction"] = joint.friction;
  if (joint.type == MechanismJointType::kScrew) json["pitch"] = joint.pitch;
  if (joint.coupling) {
    json["coupling"] = {
        {"joint", joint.coupling->joint}, {"ratio", joint.coupling->ratio}, {"offset", joint.coupling->offset}};
  }
  return json;
}

void readPart(const Json& json, const Text& place, const FormatContext& context, SourceReader& sources,
              MechanismDefinition& definition) {
  MechanismPart part;
  std::vector<double> color;
  FieldReader fields(json, place, context.error);
  fields.require("name");
  fields.require("source");
  fields.read("name", part.name);
  if (const Json* source = fields.object("source")) sources.read(*source, place, part.source);
  fields.read("placement", part.X_MP);
  if (fields.readNumbers("color", 3, color)) {
    for (std::size_t k = 0; k < 3; ++k) part.color[k] = static_cast<float>(color[k]);
  }
  fields.read("material", part.material);
  if (context.error) return;
  fields.warnAboutOthers(context.diagnostics);
  Expected<Entity> loaded = context.loader.loadSource(part.source, context.diagnostics);
  if (!loaded) return context.failIn(place, loaded.error());
  if (!loaded->mesh()) return fields.fail("source", Text("a robot"), Text("a solid"));
  part.mesh = loaded->mesh();
  part.source = loaded->source;
  definition.parts.push_back(std::move(part));
}

void readMechanismJoint(const Json& json, const Text& place, const FormatContext& context,
                        MechanismDefinition& definition) {
  MechanismJoint joint;
  int type = static_cast<int>(joint.type);
  std::vector<double> point, axis;
  FieldReader fields(json, place, context.error);
  for (const char* key : {"name", "parent", "child", "axis"}) fields.require(key);
  fields.read("name", joint.name);
  fields.readWord("type", kJointWords, type);
  fields.read("parent", joint.parent);
  fields.read("child", joint.child);
  if (fields.readNumbers("point", 3, point)) joint.p_MJ = {point[0], point[1], point[2]};
  if (fields.readNumbers("axis", 3, axis)) joint.axis_M = {axis[0], axis[1], axis[2]};
  joint.lower = -std::numeric_limits<double>::infinity();
  joint.upper = std::numeric_limits<double>::infinity();
  fields.read("lower", joint.lower);
  fields.read("upper", joint.upper);
  fields.read("velocity", joint.velocity);
  fields.read("friction", joint.friction);
  fields.read("pitch", joint.pitch);
  if (const Json* coupling = fields.object("coupling")) {
    JointCoupling read;
    FieldReader coupling_fields(*coupling, Text("%1, \"%2\"", place, "coupling"), context.error);
    coupling_fields.require("joint");
    coupling_fields.read("joint", read.joint);
    coupling_fields.read("ratio", read.ratio);
    coupling_fields.read("offset", read.offset);
    if (!context.error) coupling_fields.warnAboutOthers(context.diagnostics);
    joint.coupling = std::move(read);
  }
  joint.type = static_cast<MechanismJointType>(type);
  if (!context.error) fields.warnAboutOthers(context.diagnostics);
  definition.joints.push_back(std::move(joint));
}

}  // namespace

Json jsonFromMechanism(const MechanismDefinition& definition, const fs::path& folder) {
  Json parts = Json::array(), joints = Json::array();
  for (const MechanismPart& part : definition.parts) {
    parts.push_back({{"name", part.name},
                     {"source", jsonFromSource(part.source, folder)},
                     {"placement", toJson(part.X_MP)},
                     {"color", jsonFromColor(part.color)},
                     {"material", part.material}});
  }
  for (const MechanismJoint& joint : definition.joints) joints.push_back(jsonFromJoint(joint));
  return {{"parts", std::move(parts)}, {"joints", std::move(joints)}};
}

Expected<Entity> mechanismFromJson(const Json& json, const std::string& name, const Text& place,
                                   const FormatContext& context, SourceReader& sources) {
  auto definition = std::make_shared<MechanismDefinition>();
  FieldReader fields(json, Text("%1, \"%2\"", place, "mechanism"), context.error);
  const Json* parts = fields.array("parts");
  const Json* joints = fields.array("joints");
  if (!context.error) fields.warnAboutOthers(context.diagnostics);
  for (std::size_t k = 0; parts && k < parts->size() && !context.error; ++k)
    readPart((*parts)[k], Text("%1, part %2", place, k + 1), context, sources, *definition);
  for (std::size_t k = 0; joints && k < joints->size() && !context.error; ++k)
    readMechanismJoint((*joints)[k], Text("%1, joint %2", place, k + 1), context, *definition);
  if (context.error) return makeError(*context.error);
  auto model = buildMechanism(name, *definition);
  HAPTICELL_TRY(model);
  Entity entity;
  entity.body = Mechanism{{std::make_shared<const kinematics::RobotModel>(std::move(*model))}, std::move(definition)};
  return entity;
}

}  // namespace hapticell::workcell
