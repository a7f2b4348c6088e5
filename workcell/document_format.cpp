// SPDX-License-Identifier: Apache-2.0
#include "workcell/document_format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

#include "workcell/command.h"
#include "workcell/document_io.h"
#include "workcell/entity_source.h"
#include "workcell/guide_format.h"
#include "workcell/mechanism.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFormat = "hapticell-workcell";
constexpr int kVersion = 1;
const std::vector<std::string> kKindWords = {"solid", "robot", "mechanism", "assembly", "mannequin"};  // As EntityKind.
const std::vector<std::string> kAxisWords = {"x", "y", "z"};                                           // As UpAxis.
const std::vector<std::string> kJointWords = {"fixed", "revolute", "prismatic", "screw"};
const std::vector<std::string> kOnContactWords = {"stop", "slide", "pass"};
const std::vector<std::string> kForceClassWords = {"constant", "contact", "dynamics"};

std::string relativeName(const std::string& path, const fs::path& folder) {
  const fs::path relative = fs::path(path).lexically_relative(folder);
  const std::string name = relative.empty() ? path : relative.generic_string();
  return isBuiltIn(name) ? "./" + name : name;
}

/// Colours are kept to four decimals: 0.72, not 0.7200000286102295.
double rounded(float part) {
  return std::round(static_cast<double>(part) * 1e4) / 1e4;
}

Json jsonFromJoints(const Entity& entity) {
  Json joints = Json::object();
  for (std::size_t k = 0; k < entity.joints.size(); ++k) {
    joints[entity.robot->joints[static_cast<std::size_t>(entity.robot->moving[k])].name] = entity.joints[k];
  }
  return joints;
}

Json jsonFromSource(const SourceFile& source, const fs::path& folder) {
  Json json;
  json["file"] = isBuiltIn(source.path) ? source.path : relativeName(source.path, folder);
  json["scale"] = source.scale;
  if (!source.part.empty()) json["part"] = source.part;
  if (source.up_axis) json["up_axis"] = axisName(*source.up_axis);
  if (source.tessellation != Tessellation{}) {
    json["chord"] = source.tessellation.chord;
    json["angle"] = source.tessellation.angle;
  }
  return json;
}

Json jsonFromColor(const std::array<float, 3>& color) {
  return {rounded(color[0]), rounded(color[1]), rounded(color[2])};
}

Json jsonFromTools(const Entity& entity) {
  Json tools = Json::array();
  for (const ToolFrame& tool : entity.tools) {
    tools.push_back({{"name", tool.name}, {"tip_link", tool.tip_link}, {"placement", toJson(tool.X_LT)}});
  }
  return tools;
}

Json jsonFromPoses(const Entity& entity) {
  Json poses = Json::array();
  for (const kinematics::NamedPose& pose : entity.named_poses) {
    Json joints = Json::object();
    for (std::size_t i = 0; i < pose.q.size(); ++i) {
      joints[entity.robot->joints[static_cast<std::size_t>(entity.robot->moving[i])].name] = pose.q[i];
    }
    poses.push_back({{"name", pose.name}, {"joints", joints}});
  }
  return poses;
}

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

/// As it stood in its document, but for what may have been changed since. (Its own file names stay as they were.)
Json jsonFromUnloaded(const Entity& entity) {
  Json json = Json::parse(*entity.unloaded);
  json["name"] = entity.name;
  json["placement"] = toJson(entity.X_WE);
  json["parent"] = entity.parent;
  return json;
}

Json jsonFromEntity(const Entity& entity, const fs::path& folder) {
  if (entity.unloaded) return jsonFromUnloaded(entity);
  Json json;
  json["name"] = entity.name;
  json["kind"] = kKindWords[static_cast<std::size_t>(entity.kind)];
  if (!entity.source.path.empty()) json["source"] = jsonFromSource(entity.source, folder);
  json["placement"] = toJson(entity.X_WE);
  json["parent"] = entity.parent;
  json["color"] = jsonFromColor(entity.color);
  json["visible"] = entity.visible;
  json["locked"] = entity.locked;
  json["checked"] = entity.checked;
  json["on_contact"] = wordOf(entity.on_contact);
  json["force_class"] = wordOf(entity.force_class);
  json["material"] = entity.material;
  json["mass"] = entity.mass;
  json["frames"] = Json::array();
  for (const Frame& frame : entity.frames) {
    json["frames"].push_back({{"name", frame.name}, {"placement", toJson(frame.X_EF)}});
  }
  if (entity.robot) {
    json["joints"] = jsonFromJoints(entity);
    json["tip_link"] = entity.tip_link;
    json["tool"] = toJson(entity.X_LT);
  }
  if (!entity.tools.empty()) json["tools"] = jsonFromTools(entity);
  if (!entity.tool.empty()) json["chosen_tool"] = entity.tool;
  if (!entity.named_poses.empty()) json["poses"] = jsonFromPoses(entity);
  if (!entity.attachment.to.empty()) {
    json["attached"] = {
        {"to", entity.attachment.to}, {"link", entity.attachment.link}, {"placement", toJson(entity.attachment.X_LE)}};
  }
  if (entity.mechanism) json["mechanism"] = jsonFromMechanism(*entity.mechanism, folder);
  return json;
}

Json jsonFromPairSet(const PairSet& set) {
  Json json;
  json["name"] = set.name;
  json["enabled"] = set.enabled;
  json["first"] = set.first;
  json["second"] = set.second;
  json["safety_distance"] = set.safety_distance;
  json["near_miss"] = set.near_miss;
  if (set.on_contact) json["on_contact"] = wordOf(*set.on_contact);
  return json;
}

class StateReader {
 public:
  StateReader(const fs::path& folder, Diagnostics& diagnostics, const LoadOptions& options)
      : folder_(folder), loader_(folder, true, options.monitor), diagnostics_(diagnostics), options_(options) {}

  Expected<DocumentState> read(const Json& json) {
    FieldReader fields(json, "the document", error_);
    readHead(fields);
    const Json* entities = fields.array("entities");
    const Json* sets = fields.array("pair_sets");
    const Json* guides = fields.array("guides");
    readView(fields);
    readTrajectories(fields);
    if (!error_) fields.warnAboutOthers(diagnostics_);
    for (std::size_t k = 0; entities && k < entities->size() && !error_; ++k) {
      reportEntity(k, entities->size());
      if (!error_) readEntity((*entities)[k], k);
    }
    if (!error_) refuseCancelled();
    if (!error_) hangUp();
    for (std::size_t k = 0; sets && k < sets->size() && !error_; ++k) readPairSet((*sets)[k], k);
    for (std::size_t k = 0; guides && k < guides->size() && !error_; ++k) readGuide((*guides)[k], k);
    if (error_) return makeError(*error_);
    return std::move(state_);
  }

 private:
  void readHead(FieldReader& fields) {
    std::string format;
    double version = 0.0;
    fields.read("format", format);
    fields.read("version", version);
    if (error_) return;
    if (format != kFormat) {
      error_ = Error{"", "", format.empty() ? "no \"format\"" : "the format \"" + format.substr(0, 60) + "\"",
                     "\"" + std::string(kFormat) + "\"", ""};
    } else if (version != std::floor(version) || version < 1.0) {
      fields.fail("version", "no version number", "1");
    } else if (version > kVersion) {
      char number[32];
      std::snprintf(number, sizeof number, "%.0f", version);
      fields.fail("version", number, "at most 1, the newest that this program knows");
      error_->fix = "Open the document with a newer HaptiCell.";
    }
  }

  void refuseCancelled() {
    if (options_.monitor && options_.monitor->isCancelled()) {
      error_ = Error{"", "", "the opening was cancelled", "", ""};
    }
  }

  void reportEntity(std::size_t index, std::size_t count) {
    refuseCancelled();
    if (!options_.monitor) return;
    const double n = static_cast<double>(count), k = static_cast<double>(index);
    options_.monitor->setRange(k / n, (k + 1.0) / n);
    options_.monitor->report("reading part " + std::to_string(index + 1) + " of " + std::to_string(count), 0.0);
  }

  void readEntity(const Json& json, std::size_t index) {
    Entity head;
    int kind = -1;
    FieldReader naming(json, "entity " + std::to_string(index + 1), error_);
    naming.require("name");
    naming.read("name", head.name);
    const std::string place = "entity '" + head.name + "'";
    FieldReader fields(json, place, error_);
    fields.read("name", head.name);
    fields.readWord("kind", kKindWords, kind);
    const Json* mechanism = fields.object("mechanism");
    const bool assembly = kind == static_cast<int>(EntityKind::kAssembly);
    if (!mechanism && !assembly) fields.require("source");
    if (const Json* source = fields.object("source")) readSource(*source, place, head.source);
    if (error_) return;
    if (assembly) {
      head.kind = EntityKind::kAssembly;
      if (!head.source.path.empty()) head.source.path = (folder_ / head.source.path).lexically_normal().string();
      if (head.source.scale == 0.0) head.source.scale = 1.0;
      return addEntity(fields, place, std::move(head));
    }
    Expected<Entity> loaded =
        mechanism ? readMechanism(*mechanism, head.name, place) : loader_.loadSource(head.source, diagnostics_);
    if (!loaded && options_.keep_unloaded) return keepUnloaded(json, fields, place, head, loaded.error());
    if (!loaded) return failIn(place, loaded.error());
    loaded->name = head.name;
    if (kind >= 0 && kind != static_cast<int>(loaded->kind)) {
      const std::string& is = kKindWords[static_cast<std::size_t>(loaded->kind)];
      return fields.fail("kind", kKindWords[static_cast<std::size_t>(kind)], is + ", as its file is");
    }
    addEntity(fields, place, std::move(*loaded));
  }

  /// The entity stays in the document as it is written there; what can be known without its file is read.
  void keepUnloaded(const Json& json, FieldReader& fields, const std::string& place, Entity entity,
                    const Error& cause) {
    error_.reset();
    diagnostics_.warn(place + " is kept without its shape: " + cause.message());
    entity.unloaded = std::make_shared<const std::string>(json.dump());
    readEntityFields(fields, place, entity);
    if (error_) return;
    const auto added = apply(AddEntity{std::move(entity)}, state_, state_.entities.size() + 1);
    if (!added) failIn(place, added.error());
  }

  /// Where a file is that may have been moved since the document was saved.
  void locate(std::string& path) {
    if (!options_.locate || isBuiltIn(path)) return;
    const fs::path file = (folder_ / path).lexically_normal();
    std::error_code ignored;
    if (fs::exists(file, ignored)) return;
    if (const auto moved = moved_folders_.find(file.parent_path()); moved != moved_folders_.end()) {
      const fs::path there = moved->second / file.filename();
      if (fs::exists(there, ignored)) {
        path = there.string();
        return;
      }
    }
    const auto [asked, is_new] = located_.try_emplace(file);
    if (is_new) asked->second = options_.locate(file);
    if (!asked->second) return;
    path = fs::absolute(*asked->second).string();
    moved_folders_.try_emplace(file.parent_path(), fs::path(path).parent_path());
  }

  void readSource(const Json& json, const std::string& place, SourceFile& source) {
    FieldReader fields(json, place + ", \"source\"", error_);
    int axis = -1;
    source.scale = 0.0;
    fields.require("file");
    fields.read("file", source.path);
    fields.read("scale", source.scale);
    fields.read("part", source.part);
    fields.readWord("up_axis", kAxisWords, axis);
    fields.read("chord", source.tessellation.chord);
    fields.read("angle", source.tessellation.angle);
    if (error_) return;
    locate(source.path);
    if (axis >= 0) source.up_axis = static_cast<UpAxis>(axis);
    if (json.contains("scale") && !(source.scale >= 1e-9 && source.scale <= 1e9)) {
      fields.fail("scale", "out of range", "metres per unit, 1e-9 to 1e9");
    } else if (!(source.tessellation.chord >= 1e-9 && source.tessellation.chord <= 1e3)) {
      fields.fail("chord", "out of range", "metres, 1e-9 to 1000");
    } else if (!(source.tessellation.angle >= 1e-3 && source.tessellation.angle <= 3.0)) {
      fields.fail("angle", "out of range", "radians, 0.001 to 3");
    } else {
      fields.warnAboutOthers(diagnostics_);
    }
  }

  void addEntity(FieldReader& fields, const std::string& place, Entity entity) {
    readEntityFields(fields, place, entity);
    if (error_) return;
    fields.warnAboutOthers(diagnostics_);
    // What it hangs on may stand further down in the file.
    Attachment attachment;
    std::swap(attachment, entity.attachment);
    const auto added = apply(AddEntity{std::move(entity)}, state_, state_.entities.size() + 1);
    if (!added) return failIn(place, added.error());
    if (!attachment.to.empty()) attachments_.emplace_back(state_.entities.size() - 1, std::move(attachment));
  }

  /// All entities are there: what hangs on which.
  void hangUp() {
    for (auto& [index, attachment] : attachments_) {
      auto entity = std::make_shared<Entity>(*state_.entities[index]);
      const std::string place = "entity '" + entity->name + "'";
      const Entity* carrier = state_.findByName(attachment.to);
      for (const Entity* at = carrier; at; at = state_.findByName(at->attachment.to)) {
        if (at->name == entity->name) {
          error_ = Error{"", place, "it is attached to itself by way of '" + attachment.to + "'", "another entity", ""};
          return;
        }
      }
      const bool link_there = carrier && (carrier->unloaded || attachment.link.empty() ||
                                          (carrier->robot && carrier->robot->findLink(attachment.link) >= 0));
      if (!link_there) {
        error_ = Error{"", place,
                       "it is attached to '" + attachment.to + (carrier ? "', link '" + attachment.link : "") +
                           "', which is not there",
                       "an entity and a link of it", ""};
        return;
      }
      entity->attachment = std::move(attachment);
      state_.entities[index] = std::move(entity);
    }
  }

  Expected<Entity> readMechanism(const Json& json, const std::string& name, const std::string& place) {
    auto definition = std::make_shared<MechanismDefinition>();
    FieldReader fields(json, place + ", \"mechanism\"", error_);
    const Json* parts = fields.array("parts");
    const Json* joints = fields.array("joints");
    if (!error_) fields.warnAboutOthers(diagnostics_);
    for (std::size_t k = 0; parts && k < parts->size() && !error_; ++k)
      readPart((*parts)[k], place + ", part " + std::to_string(k + 1), *definition);
    for (std::size_t k = 0; joints && k < joints->size() && !error_; ++k)
      readMechanismJoint((*joints)[k], place + ", joint " + std::to_string(k + 1), *definition);
    if (error_) return makeError(*error_);
    auto model = buildMechanism(name, *definition);
    if (!model) return makeError(model.error());
    Entity entity;
    entity.kind = EntityKind::kMechanism;
    entity.robot = std::make_shared<const kinematics::RobotModel>(std::move(*model));
    entity.mechanism = std::move(definition);
    return entity;
  }

  void readPart(const Json& json, const std::string& place, MechanismDefinition& definition) {
    MechanismPart part;
    std::vector<double> color;
    FieldReader fields(json, place, error_);
    fields.require("name");
    fields.require("source");
    fields.read("name", part.name);
    if (const Json* source = fields.object("source")) readSource(*source, place, part.source);
    fields.read("placement", part.X_MP);
    if (fields.readNumbers("color", 3, color)) {
      for (std::size_t k = 0; k < 3; ++k) part.color[k] = static_cast<float>(color[k]);
    }
    fields.read("material", part.material);
    if (error_) return;
    fields.warnAboutOthers(diagnostics_);
    Expected<Entity> loaded = loader_.loadSource(part.source, diagnostics_);
    if (!loaded) return failIn(place, loaded.error());
    if (!loaded->mesh) return fields.fail("source", "a robot", "a solid");
    part.mesh = loaded->mesh;
    part.source = loaded->source;
    definition.parts.push_back(std::move(part));
  }

  void readMechanismJoint(const Json& json, const std::string& place, MechanismDefinition& definition) {
    MechanismJoint joint;
    int type = static_cast<int>(joint.type);
    std::vector<double> point, axis;
    FieldReader fields(json, place, error_);
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
      FieldReader coupling_fields(*coupling, place + ", \"coupling\"", error_);
      coupling_fields.require("joint");
      coupling_fields.read("joint", read.joint);
      coupling_fields.read("ratio", read.ratio);
      coupling_fields.read("offset", read.offset);
      if (!error_) coupling_fields.warnAboutOthers(diagnostics_);
      joint.coupling = std::move(read);
    }
    joint.type = static_cast<MechanismJointType>(type);
    if (!error_) fields.warnAboutOthers(diagnostics_);
    definition.joints.push_back(std::move(joint));
  }

  void readEntityFields(FieldReader& fields, const std::string& place, Entity& entity) {
    int on_contact = static_cast<int>(entity.on_contact), force_class = static_cast<int>(entity.force_class);
    std::vector<double> color;
    fields.read("placement", entity.X_WE);
    fields.read("parent", entity.parent);
    if (fields.readNumbers("color", 3, color)) {
      for (std::size_t k = 0; k < 3; ++k) entity.color[k] = static_cast<float>(color[k]);
    }
    fields.read("visible", entity.visible);
    fields.read("locked", entity.locked);
    fields.read("checked", entity.checked);
    fields.readWord("on_contact", kOnContactWords, on_contact);
    fields.readWord("force_class", kForceClassWords, force_class);
    fields.read("material", entity.material);
    fields.read("mass", entity.mass);
    entity.on_contact = static_cast<OnContact>(on_contact);
    entity.force_class = static_cast<ForceClass>(force_class);
    if (const Json* frames = fields.array("frames")) readFrames(*frames, place, entity);
    if (const Json* attached = fields.object("attached")) {
      FieldReader attached_fields(*attached, place + ", \"attached\"", error_);
      attached_fields.require("to");
      attached_fields.read("to", entity.attachment.to);
      attached_fields.read("link", entity.attachment.link);
      attached_fields.read("placement", entity.attachment.X_LE);
      if (!error_) attached_fields.warnAboutOthers(diagnostics_);
    }
    if (!entity.robot) return;
    if (const Json* tools = fields.array("tools")) readTools(*tools, place, entity);
    if (const Json* poses = fields.array("poses")) readPoses(*poses, place, entity);
    fields.read("chosen_tool", entity.tool);
    fields.read("tip_link", entity.tip_link);
    fields.read("tool", entity.X_LT);
    if (const Json* joints = fields.object("joints")) {
      entity.joints = readJoints(*joints, place, *entity.robot, std::exchange(entity.joints, {}));
    }
  }

  void readFrames(const Json& frames, const std::string& place, Entity& entity) {
    for (const Json& json : frames) {
      Frame frame;
      FieldReader fields(json, place + ", frame " + std::to_string(entity.frames.size() + 1), error_);
      fields.require("name");
      fields.read("name", frame.name);
      fields.read("placement", frame.X_EF);
      if (!error_) fields.warnAboutOthers(diagnostics_);
      entity.frames.push_back(std::move(frame));
    }
  }

  void readTools(const Json& tools, const std::string& place, Entity& entity) {
    for (const Json& json : tools) {
      ToolFrame tool;
      FieldReader fields(json, place + ", tool " + std::to_string(entity.tools.size() + 1), error_);
      fields.require("name");
      fields.read("name", tool.name);
      fields.read("tip_link", tool.tip_link);
      fields.read("placement", tool.X_LT);
      if (!error_) fields.warnAboutOthers(diagnostics_);
      entity.tools.push_back(std::move(tool));
    }
  }

  void readPoses(const Json& poses, const std::string& place, Entity& entity) {
    for (const Json& json : poses) {
      kinematics::NamedPose pose;
      const std::string here = place + ", pose " + std::to_string(entity.named_poses.size() + 1);
      FieldReader fields(json, here, error_);
      fields.require("name");
      fields.read("name", pose.name);
      const Json* joints = fields.object("joints");
      pose.q = joints ? readJoints(*joints, here, *entity.robot, {}) : kinematics::restPositions(*entity.robot);
      if (!error_) fields.warnAboutOthers(diagnostics_);
      entity.named_poses.push_back(std::move(pose));
    }
  }

  /// Positions by the joints' names; those that are not there as in `before`, or at rest where that is empty.
  std::vector<double> readJoints(const Json& json, const std::string& place, const kinematics::RobotModel& model,
                                 const std::vector<double>& before) {
    FieldReader fields(json, place + ", \"joints\"", error_);
    std::vector<double> positions = before.size() == model.dof() ? before : kinematics::restPositions(model);
    for (std::size_t i = 0; i < model.moving.size(); ++i) {
      fields.read(model.joints[static_cast<std::size_t>(model.moving[i])].name.c_str(), positions[i]);
    }
    if (!error_) fields.warnAboutOthers(diagnostics_);
    return positions;
  }

  void readPairSet(const Json& json, std::size_t index) {
    PairSet set;
    int on_contact = -1;
    FieldReader fields(json, "pair set " + std::to_string(index + 1), error_);
    fields.require("name");
    fields.read("name", set.name);
    fields.read("enabled", set.enabled);
    fields.read("first", set.first);
    fields.read("second", set.second);
    fields.read("safety_distance", set.safety_distance);
    fields.read("near_miss", set.near_miss);
    fields.readWord("on_contact", kOnContactWords, on_contact);
    if (error_) return;
    if (on_contact >= 0) set.on_contact = static_cast<OnContact>(on_contact);
    fields.warnAboutOthers(diagnostics_);
    for (const auto* side : {&set.first, &set.second}) {
      for (const std::string& name : *side) {
        if (!state_.findByName(name))
          diagnostics_.warn("pair set '" + set.name + "' names '" + name + "', which is not there");
      }
    }
    const std::string place = "pair set '" + set.name + "'";
    const auto added = apply(AddPairSet{std::move(set)}, state_, 0);
    if (!added) failIn(place, added.error());
  }

  void readGuide(const Json& json, std::size_t index) {
    Guide guide = guideFromJson(json, index, error_, diagnostics_);
    if (error_) return;
    const std::string place = "guide '" + guide.name + "'";
    const auto added = apply(AddGuide{std::move(guide)}, state_, 0);
    if (!added) failIn(place, added.error());
  }

  void readView(FieldReader& fields) {
    const Json* json = fields.object("view");
    if (!json) return;
    FieldReader view(*json, "\"view\"", error_);
    std::vector<double> eye, target;
    if (!view.readNumbers("eye", 3, eye) || !view.readNumbers("target", 3, target)) return;
    view.warnAboutOthers(diagnostics_);
    state_.view = SavedView{{eye[0], eye[1], eye[2]}, {target[0], target[1], target[2]}};
  }

  void readTrajectories(FieldReader& fields) {
    const Json* list = fields.array("trajectories");
    for (std::size_t k = 0; list && k < list->size() && !error_; ++k) {
      TrajectoryReference reference;
      FieldReader trajectory((*list)[k], "trajectory " + std::to_string(k + 1), error_);
      trajectory.require("file");
      trajectory.read("name", reference.name);
      trajectory.read("file", reference.path);
      reference.path = (folder_ / reference.path).lexically_normal().string();
      state_.trajectories.push_back(std::move(reference));
    }
  }

  /// What went wrong with a part, as said of the entity that needs it.
  void failIn(const std::string& place, const Error& cause) {
    Error plain = cause;
    plain.fix.clear();
    error_ = Error{"", place, plain.message(), "", cause.fix};
  }

  const fs::path& folder_;
  EntityLoader loader_;
  Diagnostics& diagnostics_;
  const LoadOptions& options_;
  std::map<fs::path, std::optional<fs::path>> located_;
  std::map<fs::path, fs::path> moved_folders_;
  DocumentState state_;
  std::vector<std::pair<std::size_t, Attachment>> attachments_;  // By place in the state.
  std::optional<Error> error_;
};

}  // namespace

Json jsonFromState(const DocumentState& state, const fs::path& folder) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["entities"] = Json::array();
  for (const auto& entity : state.entities) json["entities"].push_back(jsonFromEntity(*entity, folder));
  json["pair_sets"] = Json::array();
  for (const PairSet& set : state.pair_sets) json["pair_sets"].push_back(jsonFromPairSet(set));
  if (!state.guides.empty()) json["guides"] = Json::array();
  for (const Guide& guide : state.guides) json["guides"].push_back(jsonFromGuide(guide));
  if (state.view) {
    const dvec3 eye = state.view->p_WEye, target = state.view->p_WTarget;
    json["view"] = {{"eye", {eye.x, eye.y, eye.z}}, {"target", {target.x, target.y, target.z}}};
  }
  json["trajectories"] = Json::array();
  for (const TrajectoryReference& reference : state.trajectories) {
    json["trajectories"].push_back({{"name", reference.name}, {"file", relativeName(reference.path, folder)}});
  }
  return json;
}

Expected<DocumentState> stateFromJson(const Json& json, const fs::path& folder, Diagnostics& diagnostics,
                                      const LoadOptions& options) {
  return StateReader(folder, diagnostics, options).read(json);
}

}  // namespace hapticell::workcell
