// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/motion_format.h"

#include <algorithm>
#include <vector>

namespace hapticell::workcell {

namespace {

const std::vector<std::string>& repeatWords() {
  static const std::vector<std::string> words{"once", "loop", "back"};
  return words;
}

}  // namespace

Json jsonFromMotion(const ScriptedMotion& motion) {
  Json json;
  json["path"] = Json::array();
  for (const ScriptedMotion::Point& p : motion.points) json["path"].push_back({p.t, p.p_W.x, p.p_W.y, p.p_W.z});
  json["repeat"] = repeatWords()[static_cast<std::size_t>(motion.repeat)];
  return json;
}

ScriptedMotion motionFromJson(const Json& json, const Text& place, std::optional<Error>& error,
                              Diagnostics& diagnostics) {
  ScriptedMotion motion;
  FieldReader fields(json, Text("%1, \"%2\"", place, "motion"), error);
  fields.require("path");
  int repeat = 0;
  fields.readWord("repeat", repeatWords(), repeat);
  motion.repeat = static_cast<MotionRepeat>(std::max(0, repeat));
  if (const Json* path = fields.array("path")) {
    for (const Json& point : *path) {
      const bool good = point.is_array() && point.size() == 4 &&
                        std::all_of(point.begin(), point.end(), [](const Json& n) { return n.is_number(); });
      if (!good) {
        if (!error)
          fields.fail("path", Text("a point that is not four numbers"), Text("[t, x, y, z] in seconds and metres"));
        return motion;
      }
      motion.points.push_back(
          {point[0].get<double>(), {point[1].get<double>(), point[2].get<double>(), point[3].get<double>()}});
    }
  }
  if (error) return motion;
  fields.warnAboutOthers(diagnostics);
  if (const auto checked = checkMotion(motion); !checked) {
    fields.fail("path", Text("%1: %2", checked.error().place, checked.error().found), checked.error().expected);
  }
  return motion;
}

}  // namespace hapticell::workcell
