// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/entity_format.h"

#include <cmath>
#include <utility>
#include <variant>

#include "workcell/format/mechanism_format.h"
#include "workcell/format/motion_format.h"
#include "workcell/format/robot_format.h"
#include "workcell/format/source_format.h"
#include "workcell/meshes/mesh_care.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kForceClassWords = {"constant", "contact", "dynamics"};
const std::vector<std::string> kProxyWords = {"none", "coarse", "convex"};  // As CollisionProxy::Kind.

Json jsonFromProxy(const CollisionProxy& proxy) {
  Json json{{"kind", kProxyWords[static_cast<std::size_t>(proxy.kind)]}};
  if (proxy.kind == CollisionProxy::Kind::kCoarse) json["tolerance"] = proxy.tolerance;
  return json;
}

/// Makes the collision shape again from the mesh: only how it was made is kept.
void readProxy(const Json& json, const Text& place, const FormatContext& context, Entity& entity) {
  int kind = 0;
  double tolerance = 0.0;
  FieldReader fields(json, Text("%1, \"%2\"", place, "proxy"), context.error);
  fields.readWord("kind", kProxyWords, kind);
  fields.read("tolerance", tolerance);
  if (context.error) return;
  fields.warnAboutOthers(context.diagnostics);
  if (!entity.mesh()) return;
  auto proxy = makeProxy(*entity.mesh(), static_cast<CollisionProxy::Kind>(kind), tolerance);
  if (proxy) {
    entity.editSolid().proxy = std::move(*proxy);
  } else {
    context.failIn(Text("%1, \"%2\"", place, "proxy"), proxy.error());
  }
}

/// As it stood in its document, but for what may have been changed since. (Its own file names stay as they were.)
Json jsonFromUnloaded(const Entity& entity) {
  Json json = Json::parse(*entity.unloaded);
  json["name"] = entity.name;
  json["placement"] = toJson(entity.X_WE);
  json["parent"] = entity.parent;
  return json;
}

void readFrames(const Json& frames, const Text& place, const FormatContext& context, Entity& entity) {
  for (const Json& json : frames) {
    Frame frame;
    FieldReader fields(json, Text("%1, frame %2", place, entity.frames.size() + 1), context.error);
    fields.require("name");
    fields.read("name", frame.name);
    fields.read("placement", frame.X_EF);
    if (!context.error) fields.warnAboutOthers(context.diagnostics);
    entity.frames.push_back(std::move(frame));
  }
}

}  // namespace

const std::vector<std::string>& entityKindWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all;
    for (std::size_t k = 0; k < std::variant_size_v<EntityBody>; ++k)
      all.emplace_back(wordOf(static_cast<EntityKind>(k)));
    return all;
  }();
  return words;
}

Json jsonFromEntity(const Entity& entity, const fs::path& folder) {
  if (entity.unloaded) return jsonFromUnloaded(entity);
  Json json;
  json["name"] = entity.name;
  json["kind"] = wordOf(entity.kind());
  if (!entity.source.path.empty()) json["source"] = jsonFromSource(entity.source, folder);
  json["placement"] = toJson(entity.X_WE);
  json["parent"] = entity.parent;
  json["color"] = jsonFromColor(entity.color);
  json["visible"] = entity.visible;
  json["locked"] = entity.locked;
  json["checked"] = entity.checked;
  json["on_contact"] = wordOf(entity.contact.on_contact);
  json["force_class"] = wordOf(entity.contact.force_class);
  json["material"] = entity.contact.material;
  json["mass"] = entity.contact.mass;
  json["frames"] = Json::array();
  for (const Frame& frame : entity.frames) {
    json["frames"].push_back({{"name", frame.name}, {"placement", toJson(frame.X_EF)}});
  }
  if (entity.motion) json["motion"] = jsonFromMotion(*entity.motion);
  addRobotFields(entity, json);
  if (!entity.attachment.to.empty()) {
    json["attached"] = {
        {"to", entity.attachment.to}, {"link", entity.attachment.link}, {"placement", toJson(entity.attachment.X_LE)}};
  }
  if (entity.proxy().kind != CollisionProxy::Kind::kNone) json["proxy"] = jsonFromProxy(entity.proxy());
  if (entity.mechanism()) json["mechanism"] = jsonFromMechanism(*entity.mechanism(), folder);
  return json;
}

void readEntityFields(FieldReader& fields, const Text& place, const FormatContext& context, Entity& entity) {
  int on_contact = static_cast<int>(entity.contact.on_contact),
      force_class = static_cast<int>(entity.contact.force_class);
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
  fields.read("material", entity.contact.material);
  fields.read("mass", entity.contact.mass);
  entity.contact.on_contact = static_cast<OnContact>(on_contact);
  entity.contact.force_class = static_cast<ForceClass>(force_class);
  if (const Json* frames = fields.array("frames")) readFrames(*frames, place, context, entity);
  if (const Json* motion = fields.object("motion")) {
    entity.motion = motionFromJson(*motion, place, context.error, context.diagnostics);
  }
  if (const Json* attached = fields.object("attached")) {
    FieldReader attached_fields(*attached, Text("%1, \"%2\"", place, "attached"), context.error);
    attached_fields.require("to");
    attached_fields.read("to", entity.attachment.to);
    attached_fields.read("link", entity.attachment.link);
    attached_fields.read("placement", entity.attachment.X_LE);
    if (!context.error) attached_fields.warnAboutOthers(context.diagnostics);
  }
  if (const Json* proxy = fields.object("proxy")) readProxy(*proxy, place, context, entity);
  readRobotFields(fields, place, context, entity);
}

}  // namespace hapticell::workcell
