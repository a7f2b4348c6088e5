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
  const bool near = metres < 1e4;
  char number[64];
  std::snprintf(number, sizeof number, "%.0f", near ? metres : 1e-3 * metres);
  const std::string reach = number;
  return {
      .place = quotedName(name),
      .found = near ? Text("it reaches %1 m from the origin", reach) : Text("it reaches %1 km from the origin", reach),
      .expected = "parts within 2 km of the origin, where 0.1 mm can still be drawn",
      .fix = "Check the unit. If it is right, move the part to the origin in the CAD program."};
}

}  // namespace

std::string quotedName(const std::string& name) {
  return "'" + name + "'";
}

Expected<void> checkName(const Text& what, const std::string& name) {
  if (isName(name)) return {};
  return makeError({.place = what, .found = quotedName(name), .expected = "a printable name of 1 to 200 characters"});
}

Expected<void> checkPose(const Text& what, const Pose& pose) {
  if (pose.isValid()) return {};
  return makeError(
      {.place = what, .found = "an invalid pose", .expected = "finite numbers and a quaternion of length 1"});
}

Expected<void> checkReach(const std::string& name, const dvec3& p_WE) {
  if (farthest(p_WE) <= kFarthest) return {};
  return makeError(tooFar(name, farthest(p_WE)));
}

Expected<void> checkReach(const Entity& entity) {
  double reach = farthest(entity.X_WE.p);
  const geometry::Bounds own = entity.mesh() ? entity.mesh()->bounds() : geometry::Bounds();
  if (!own.isEmpty()) {
    const geometry::Bounds there = geometry::transformed(entity.X_WE, own);
    for (const dvec3& corner : {own.min, own.max, there.min, there.max}) reach = std::max(reach, farthest(corner));
  }
  if (reach <= kFarthest) return {};
  return makeError(tooFar(entity.name, reach));
}

Error taken(const std::string& name) {
  return {.found = Text("the name '%1' is already in use", name), .expected = "a unique name"};
}

Expected<void> checkJoints(const Entity& entity, const std::vector<double>& joints) {
  const std::size_t wanted = entity.robot() ? entity.robot()->dof() : 0;
  if (joints.size() != wanted) {
    return makeError({.place = quotedName(entity.name),
                      .found = Text("%1 joint values", joints.size()),
                      .expected = Text("%1, one per moving joint", wanted)});
  }
  for (double value : joints) {
    if (!std::isfinite(value)) {
      return makeError(
          {.place = quotedName(entity.name), .found = "a joint value that is not finite", .expected = "a number"});
    }
  }
  return {};
}

Expected<void> checkTool(const Entity& entity) {
  if (entity.robot() && !entity.jointed().tip_link.empty() && entity.robot()->findLink(entity.jointed().tip_link) < 0) {
    return makeError({.place = quotedName(entity.name),
                      .found = Text("no link is named '%1'", entity.jointed().tip_link),
                      .expected = Text("a link of robot '%1'", entity.robot()->name)});
  }
  return checkPose(Text("the tool of '%1'", entity.name), entity.jointed().X_LT);
}

Expected<void> checkTools(const Entity& entity) {
  std::vector<std::string> names;
  for (const ToolFrame& tool : entity.jointed().tools) {
    const Text place("'%1', tool '%2'", entity.name, tool.name);
    if (auto checked = checkName(Text("a tool of '%1'", entity.name), tool.name); !checked) return checked;
    if (auto checked = checkPose(place, tool.X_LT); !checked) return checked;
    if (!entity.robot() || entity.robot()->findLink(tool.tip_link) < 0) {
      return makeError(
          {.place = place, .found = Text("no link is named '%1'", tool.tip_link), .expected = "a link of the robot"});
    }
    if (std::find(names.begin(), names.end(), tool.name) != names.end()) return makeError(taken(tool.name));
    names.push_back(tool.name);
  }
  return checkTool(entity);
}

Expected<void> checkNamedPoses(const Entity& entity) {
  std::set<std::string> names;
  for (const kinematics::NamedPose& pose : entity.jointed().named_poses) {
    if (auto checked = checkName(Text("a pose of '%1'", entity.name), pose.name); !checked) return checked;
    if (!names.insert(pose.name).second) return makeError(taken(pose.name));
    if (auto checked = checkJoints(entity, pose.q); !checked) return checked;
  }
  return {};
}

Expected<void> checkFrames(const Entity& entity) {
  std::vector<std::string> names;
  for (const Frame& frame : entity.frames) {
    const Text place("'%1', frame '%2'", entity.name, frame.name);
    if (auto checked = checkName(Text("a frame of '%1'", entity.name), frame.name); !checked) return checked;
    if (auto checked = checkPose(place, frame.X_EF); !checked) return checked;
    if (std::find(names.begin(), names.end(), frame.name) != names.end()) return makeError(taken(frame.name));
    names.push_back(frame.name);
  }
  return {};
}

Expected<void> checkProperties(const Entity& entity) {
  const bool color =
      std::all_of(entity.color.begin(), entity.color.end(), [](float part) { return part >= 0.0f && part <= 1.0f; });
  if (!color)
    return makeError({.place = quotedName(entity.name),
                      .found = "a colour out of range",
                      .expected = "red, green and blue from 0 to 1"});
  if (!(entity.contact.mass > 0.0) || !std::isfinite(entity.contact.mass)) {
    return makeError({.place = quotedName(entity.name), .found = "an invalid mass", .expected = "kilograms above 0"});
  }
  return {};
}

Expected<void> checkPairSet(const PairSet& set) {
  if (auto checked = checkName(Text("the pair set's name"), set.name); !checked) return checked;
  // m: more than any machine keeps from another. Half, twice: other typing errors are refused; nearer pairs take more
  // time.
  constexpr double kLargest = 1.0;
  for (double distance : {set.safety_distance, set.near_miss}) {
    if (!(distance >= 0.0 && distance <= kLargest)) {
      return makeError(
          {.place = Text("pair set '%1'", set.name), .found = "a distance out of range", .expected = "0 to 1 m"});
    }
  }
  for (const auto& color : {set.contact_color, set.near_miss_color}) {
    const bool good = !color || std::all_of(color->begin(), color->end(), [](float c) { return c >= 0 && c <= 1; });
    if (!good)
      return makeError({.place = Text("pair set '%1'", set.name),
                        .found = "a colour out of range",
                        .expected = "red, green and blue from 0 to 1"});
  }
  return {};
}

Expected<void> checkPairRule(const PairRule& rule, const DocumentState& state) {
  for (const auto& [name, part] :
       {std::pair{&rule.first, &rule.first_part}, std::pair{&rule.second, &rule.second_part}}) {
    const Entity* entity = state.findByName(*name);
    if (!entity)
      return makeError(
          {.place = "pair rule", .found = Text("no entity is named '%1'", *name), .expected = "an existing name"});
    if (part->empty() || (entity->robot() && entity->robot()->findLink(*part) >= 0)) continue;
    return makeError({.place = "pair rule",
                      .found = Text("no link is named '%1'", *part),
                      .expected = Text("a link of '%1'", *name)});
  }
  if (rule.first == rule.second)
    return makeError({.place = "pair rule", .found = Text("'%1' twice", rule.first), .expected = "two entities"});
  return {};
}

}  // namespace hapticell::workcell
