// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/command_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace hapticell::workcell {

namespace {

/// What a name may be: shown in one line of the tree.
bool isName(const std::string& name) {
  // Bytes: shown in one line of the tree. A limit for files, half or twice would do.
  constexpr std::size_t kLongest = 200;
  const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  return !name.empty() && name.size() <= kLongest && printable && name.front() != ' ' && name.back() != ' ';
}

double farthest(const dvec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

Error tooFar(const std::string& name, double metres) {
  char reach[64];
  std::snprintf(reach, sizeof reach, metres < 1e4 ? "%.0f m" : "%.0f km", metres < 1e4 ? metres : 1e-3 * metres);
  return refusal(quotedName(name), std::string("it reaches ") + reach + " from the origin",
                 "parts within 2 km of it, where a tenth of a millimetre can still be drawn",
                 "Is its unit right? Otherwise move it to the origin in the program that made it.");
}

}  // namespace

Error refusal(std::string place, std::string found, std::string expected, std::string fix) {
  return {.place = std::move(place), .found = std::move(found), .expected = std::move(expected), .fix = std::move(fix)};
}

std::string quotedName(const std::string& name) {
  return "'" + name + "'";
}

Expected<void> checkName(const std::string& what, const std::string& name) {
  if (isName(name)) return {};
  return makeError(refusal(what, quotedName(name), "a printable name of 1 to 200 letters"));
}

Expected<void> checkPose(const std::string& what, const Pose& pose) {
  if (pose.isValid()) return {};
  return makeError(refusal(what, "a pose that is not one", "finite numbers and a quaternion of length 1"));
}

Expected<void> checkReach(const std::string& name, const dvec3& p_WE) {
  if (farthest(p_WE) <= kFarthest) return {};
  return makeError(tooFar(name, farthest(p_WE)));
}

Expected<void> checkReach(const Entity& entity) {
  double reach = farthest(entity.X_WE.p);
  const geometry::Bounds own = entity.mesh ? entity.mesh->bounds() : geometry::Bounds();
  if (!own.isEmpty()) {
    const geometry::Bounds there = geometry::transformed(entity.X_WE, own);
    for (const dvec3& corner : {own.min, own.max, there.min, there.max}) reach = std::max(reach, farthest(corner));
  }
  if (reach <= kFarthest) return {};
  return makeError(tooFar(entity.name, reach));
}

Error taken(const std::string& name) {
  return refusal("", "the name " + quotedName(name) + " is taken", "a name of its own");
}

Expected<void> checkJoints(const Entity& entity, const std::vector<double>& joints) {
  const std::size_t wanted = entity.robot ? entity.robot->dof() : 0;
  if (joints.size() != wanted) {
    return makeError(refusal(quotedName(entity.name), std::to_string(joints.size()) + " joint values",
                             std::to_string(wanted) + ", one a moving joint"));
  }
  for (double value : joints) {
    if (!std::isfinite(value)) {
      return makeError(refusal(quotedName(entity.name), "a joint value that is not finite", "a number"));
    }
  }
  return {};
}

Expected<void> checkTool(const Entity& entity) {
  if (entity.robot && !entity.tip_link.empty() && entity.robot->findLink(entity.tip_link) < 0) {
    return makeError(refusal(quotedName(entity.name), "no link " + quotedName(entity.tip_link),
                             "a link of robot " + quotedName(entity.robot->name)));
  }
  return checkPose("the tool of " + quotedName(entity.name), entity.X_LT);
}

Expected<void> checkTools(const Entity& entity) {
  std::vector<std::string> names;
  for (const ToolFrame& tool : entity.tools) {
    const std::string place = quotedName(entity.name) + ", tool " + quotedName(tool.name);
    if (auto checked = checkName("a tool of " + quotedName(entity.name), tool.name); !checked) return checked;
    if (auto checked = checkPose(place, tool.X_LT); !checked) return checked;
    if (!entity.robot || entity.robot->findLink(tool.tip_link) < 0) {
      return makeError(refusal(place, "no link " + quotedName(tool.tip_link), "a link of the robot"));
    }
    if (std::find(names.begin(), names.end(), tool.name) != names.end()) return makeError(taken(tool.name));
    names.push_back(tool.name);
  }
  return checkTool(entity);
}

Expected<void> checkNamedPoses(const Entity& entity) {
  if (entity.named_poses.empty()) return {};
  if (!entity.robot)
    return makeError(refusal(quotedName(entity.name), "a solid", "a robot, which can have named poses"));
  std::set<std::string> names;
  for (const kinematics::NamedPose& pose : entity.named_poses) {
    if (auto checked = checkName("a pose of " + quotedName(entity.name), pose.name); !checked) return checked;
    if (!names.insert(pose.name).second) return makeError(taken(pose.name));
    if (auto checked = checkJoints(entity, pose.q); !checked) return checked;
  }
  return {};
}

Expected<void> checkFrames(const Entity& entity) {
  std::vector<std::string> names;
  for (const Frame& frame : entity.frames) {
    const std::string place = quotedName(entity.name) + ", frame " + quotedName(frame.name);
    if (auto checked = checkName("a frame of " + quotedName(entity.name), frame.name); !checked) return checked;
    if (auto checked = checkPose(place, frame.X_EF); !checked) return checked;
    if (std::find(names.begin(), names.end(), frame.name) != names.end()) return makeError(taken(frame.name));
    names.push_back(frame.name);
  }
  return {};
}

Expected<void> checkProperties(const Entity& entity) {
  const bool color =
      std::all_of(entity.color.begin(), entity.color.end(), [](float part) { return part >= 0.0f && part <= 1.0f; });
  if (!color) return makeError(refusal(quotedName(entity.name), "a colour out of range", "parts from 0 to 1"));
  if (!(entity.mass > 0.0) || !std::isfinite(entity.mass)) {
    return makeError(refusal(quotedName(entity.name), "a mass that is none", "kilograms above 0"));
  }
  return {};
}

Expected<void> checkPairSet(const PairSet& set) {
  if (auto checked = checkName("the pair set's name", set.name); !checked) return checked;
  // m: more than any machine keeps from another. Half, twice: other typing errors are refused; nearer pairs take more
  // time.
  constexpr double kLargest = 1.0;
  for (double distance : {set.safety_distance, set.near_miss}) {
    if (!(distance >= 0.0 && distance <= kLargest)) {
      return makeError(refusal("pair set " + quotedName(set.name), "a distance out of range", "0 to 1 m"));
    }
  }
  for (const auto& color : {set.contact_color, set.near_miss_color}) {
    const bool good = !color || std::all_of(color->begin(), color->end(), [](float c) { return c >= 0 && c <= 1; });
    if (!good)
      return makeError(refusal("pair set " + quotedName(set.name), "a colour out of range", "parts from 0 to 1"));
  }
  return {};
}

Expected<void> checkPairRule(const PairRule& rule, const DocumentState& state) {
  for (const auto& [name, part] :
       {std::pair{&rule.first, &rule.first_part}, std::pair{&rule.second, &rule.second_part}}) {
    const Entity* entity = state.findByName(*name);
    if (!entity) return makeError(refusal("a pair's rule", "no entity " + quotedName(*name), "the name of one"));
    if (part->empty() || (entity->robot && entity->robot->findLink(*part) >= 0)) continue;
    return makeError(refusal("a pair's rule", "no link " + quotedName(*part), "a link of " + quotedName(*name)));
  }
  if (rule.first == rule.second)
    return makeError(refusal("a pair's rule", quotedName(rule.first) + " twice", "two entities"));
  return {};
}

}  // namespace hapticell::workcell
