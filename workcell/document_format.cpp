// SPDX-License-Identifier: Apache-2.0
#include "workcell/document_format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "workcell/command.h"
#include "workcell/document_io.h"
#include "workcell/entity_source.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFormat = "hapticell-workcell";
constexpr int kVersion = 1;
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

Json jsonFromEntity(const Entity& entity, const fs::path& folder) {
  const std::string& path = entity.source.path;
  Json json;
  json["name"] = entity.name;
  json["kind"] = entity.kind == EntityKind::kRobot ? "robot" : "solid";
  json["source"] = {{"file", isBuiltIn(path) ? path : relativeName(path, folder)}, {"scale", entity.source.scale}};
  json["placement"] = toJson(entity.X_WE);
  json["parent"] = entity.parent;
  json["color"] = {rounded(entity.color[0]), rounded(entity.color[1]), rounded(entity.color[2])};
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
  StateReader(const fs::path& folder, Diagnostics& diagnostics)
      : folder_(folder), loader_(folder, true), diagnostics_(diagnostics) {}

  Expected<DocumentState> read(const Json& json) {
    FieldReader fields(json, "the document", error_);
    readHead(fields);
    const Json* entities = fields.array("entities");
    const Json* sets = fields.array("pair_sets");
    readView(fields);
    readTrajectories(fields);
    if (!error_) fields.warnAboutOthers(diagnostics_);
    for (std::size_t k = 0; entities && k < entities->size() && !error_; ++k) readEntity((*entities)[k], k);
    for (std::size_t k = 0; sets && k < sets->size() && !error_; ++k) readPairSet((*sets)[k], k);
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

  void readEntity(const Json& json, std::size_t index) {
    Entity head;
    int kind = -1;
    double scale = 1.0;
    std::string file;
    FieldReader naming(json, "entity " + std::to_string(index + 1), error_);
    naming.require("name");
    naming.read("name", head.name);
    const std::string place = "entity '" + head.name + "'";
    FieldReader fields(json, place, error_);
    fields.read("name", head.name);
    fields.readWord("kind", {"solid", "robot"}, kind);
    fields.require("source");
    if (const Json* source = fields.object("source")) {
      FieldReader source_fields(*source, place + ", \"source\"", error_);
      source_fields.require("file");
      source_fields.read("file", file);
      source_fields.read("scale", scale);
      if (!error_ && !(scale >= 1e-9 && scale <= 1e9))
        source_fields.fail("scale", "out of range", "metres per unit, 1e-9 to 1e9");
      if (!error_) source_fields.warnAboutOthers(diagnostics_);
    }
    if (error_) return;
    Expected<Entity> loaded = loader_.load(file, scale, diagnostics_);
    if (!loaded) return failIn(place, loaded.error());
    loaded->name = head.name;
    if (kind >= 0 && (kind == 1) != (loaded->kind == EntityKind::kRobot)) {
      return fields.fail("kind", kind == 1 ? "robot" : "solid",
                         kind == 1 ? "solid, as its file is" : "robot, as its file is");
    }
    readEntityFields(fields, place, *loaded);
    if (error_) return;
    fields.warnAboutOthers(diagnostics_);
    const auto added = apply(AddEntity{std::move(*loaded)}, state_, state_.entities.size() + 1);
    if (!added) failIn(place, added.error());
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
    if (!entity.robot) return;
    fields.read("tip_link", entity.tip_link);
    fields.read("tool", entity.X_LT);
    if (const Json* joints = fields.object("joints")) readJoints(*joints, place, entity);
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

  void readJoints(const Json& json, const std::string& place, Entity& entity) {
    FieldReader fields(json, place + ", \"joints\"", error_);
    for (int index : entity.robot->moving) {
      const kinematics::Joint& joint = entity.robot->joints[static_cast<std::size_t>(index)];
      double value = std::min(std::max(0.0, joint.lower), joint.upper);
      fields.read(joint.name.c_str(), value);
      entity.joints.push_back(value);
    }
    if (!error_) fields.warnAboutOthers(diagnostics_);
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
  DocumentState state_;
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

Expected<DocumentState> stateFromJson(const Json& json, const fs::path& folder, Diagnostics& diagnostics) {
  return StateReader(folder, diagnostics).read(json);
}

}  // namespace hapticell::workcell
