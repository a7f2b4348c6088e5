// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/guide_format.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hapticell::workcell {

const std::vector<std::string>& guideWords() {
  static const std::vector<std::string> words{"point",  "line",  "plane", "circle",  "hinge",
                                              "slider", "screw", "tube",  "surface", "lock"};
  return words;
}

Json jsonFromGuide(const Guide& guide) {
  Json json;
  json["name"] = guide.name;
  json["kind"] = guideWords()[static_cast<std::size_t>(guide.kind)];
  json["entity"] = guide.entity;
  json["enabled"] = guide.enabled;
  json["placement"] = toJson(guide.X_WG);
  json["radius"] = guide.radius;
  json["pitch"] = guide.pitch;
  json["offset"] = guide.offset;
  if (!guide.surface.empty()) json["surface"] = guide.surface;
  if (guide.lower) json["lower"] = *guide.lower;
  if (guide.upper) json["upper"] = *guide.upper;
  json["friction"] = guide.friction;
  json["detents"] = guide.detents;
  json["detent_width"] = guide.detent_width;
  json["detent_stiffness"] = guide.detent_stiffness;
  if (!guide.path.empty()) {
    json["path"] = Json::array();
    for (const dvec3& p : guide.path) json["path"].push_back({p.x, p.y, p.z});
  }
  json["help"] = guide.help;
  if (guide.lead > 0.0) json["lead"] = guide.lead;
  json["locked"] = guide.locked;
  return json;
}

Guide guideFromJson(const Json& json, std::size_t index, std::optional<Error>& error, Diagnostics& diagnostics) {
  Guide guide;
  FieldReader fields(json, Text("guide %1", index + 1), error);
  fields.require("name");
  fields.require("kind");
  fields.require("entity");
  fields.read("name", guide.name);
  int kind = static_cast<int>(guide.kind);
  fields.readWord("kind", guideWords(), kind);
  guide.kind = static_cast<GuideKind>(std::max(0, kind));
  fields.read("entity", guide.entity);
  fields.read("enabled", guide.enabled);
  fields.read("placement", guide.X_WG);
  fields.read("radius", guide.radius);
  fields.read("pitch", guide.pitch);
  fields.read("offset", guide.offset);
  fields.read("surface", guide.surface);
  for (const auto& [key, stop] : {std::pair{"lower", &guide.lower}, std::pair{"upper", &guide.upper}}) {
    double value = std::nan("");
    fields.read(key, value);
    if (std::isfinite(value)) *stop = value;
  }
  fields.read("friction", guide.friction);
  fields.read("detent_width", guide.detent_width);
  fields.read("detent_stiffness", guide.detent_stiffness);
  fields.read("help", guide.help);
  fields.read("lead", guide.lead);
  if (const Json* detents = fields.array("detents")) {
    fields.readNumbers("detents", detents->size(), guide.detents);
  }
  if (const Json* locked = fields.array("locked")) {
    for (std::size_t i = 0; i < std::min<std::size_t>(6, locked->size()); ++i) {
      if (!(*locked)[i].is_boolean()) {
        if (!error)
          fields.fail("locked", Text("an element that is not true or false"), Text("six values, each true or false"));
        break;
      }
      guide.locked[i] = (*locked)[i].get<bool>();
    }
  }
  if (const Json* path = fields.array("path")) {
    for (const Json& point : *path) {
      const bool triple =
          point.is_array() && point.size() == 3 && point[0].is_number() && point[1].is_number() && point[2].is_number();
      if (!triple) {
        if (!error) fields.fail("path", Text("a point that is not three numbers"), Text("[x, y, z] in metres"));
        break;
      }
      guide.path.push_back({point[0].get<double>(), point[1].get<double>(), point[2].get<double>()});
    }
  }
  if (!error) fields.warnAboutOthers(diagnostics);
  return guide;
}

}  // namespace hapticell::workcell
