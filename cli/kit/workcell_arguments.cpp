// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/workcell_arguments.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <vector>

#include "cli/kit/xacro_arguments.h"
#include "geometry/system/listed.h"
#include "trajectory/motion/csv_table.h"
#include "workcell/meshes/length_unit.h"

namespace hapticell::cli {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts{""};
  for (char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// The parts of "HEAD,key=value,more of the value,key=value": each known key begins a new one.
struct Arguments {
  std::string head;
  std::vector<std::pair<std::string, std::string>> options;
};

Arguments splitOptions(const std::string& text, const std::vector<std::string>& keys) {
  Arguments result;
  bool first = true;
  for (const std::string& part : split(text, ',')) {
    const std::string key = part.substr(0, part.find('='));
    if (!first && part.find(":=") != std::string::npos) {
      result.head += "," + part;  // A xacro's argument.
    } else if (!first && part.size() > key.size() && std::find(keys.begin(), keys.end(), key) != keys.end()) {
      result.options.emplace_back(key, part.substr(key.size() + 1));
    } else if (!result.options.empty()) {
      result.options.back().second += "," + part;
    } else {
      result.head += (first ? "" : ",") + part;
    }
    first = false;
  }
  return result;
}

/// A word in front of '=' behind a comma of WHAT, which is not a key; empty if there is no such word, or a file is
/// named so.
std::string unknownKey(const std::string& what) {
  const std::size_t comma = what.find(','), equals = what.find('=', comma);
  std::error_code ignored;
  if (equals == std::string::npos || std::filesystem::exists(what, ignored)) return {};
  const std::string word = what.substr(comma + 1, equals - comma - 1);
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalpha(c) || c == '_'; });
  return plain ? word : std::string();
}

/// The first key that is there twice; empty when there is none.
std::string saidTwice(const Arguments& arguments) {
  std::set<std::string> seen;
  for (const auto& [key, value] : arguments.options) {
    if (!seen.insert(key).second) return key;
  }
  return {};
}

Error wrong(const std::string& option, const std::string& text, const Text& expected) {
  return {.place = option, .found = "'" + text + "'", .expected = expected};
}

Expected<Pose> parsePose(const std::string& option, const std::string& text) {
  const Error error =
      wrong(option + ", pose", text, Text("seven numbers x,y,z,qw,qx,qy,qz with a quaternion of length 1"));
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    const auto number = trajectory::parseNumber(part);
    if (!number || !std::isfinite(*number)) return makeError(error);
    numbers.push_back(*number);
  }
  if (numbers.size() != 7) return makeError(error);
  const dquat q(numbers[3], numbers[4], numbers[5], numbers[6]);
  // Of the length, as kNearlyUnit of workcell/text/field_reader.cpp.
  constexpr double kRounding = 0.01;
  if (!(std::abs(glm::length(q) - 1.0) < kRounding)) return makeError(error);
  Pose pose{{numbers[0], numbers[1], numbers[2]}, q};
  if (!pose.isValid()) pose.q = glm::normalize(q);
  return pose;
}

std::vector<std::string> namesOf(const std::string& side) {
  return side.empty() ? std::vector<std::string>{} : split(side, '+');
}

/// One option behind WHAT; an error names it.
Expected<void> readOption(const std::string& key, const std::string& value, Addition& addition) {
  if (key == "name") {
    if (value.empty()) return makeError(wrong("--add, name", value, Text("a name")));
    addition.name = value;
  } else if (key == "unit") {
    const auto unit = workcell::parseLengthUnit(value);
    if (!unit) return makeError(wrong("--add, unit", value, Text("m, mm or in")));
    addition.options.metres_per_unit = workcell::metresPer(*unit);
  } else if (key == "up") {
    const auto axis = workcell::parseAxis(value);
    if (!axis) return makeError(wrong("--add, up", value, Text("x, y or z")));
    addition.options.up_axis = *axis;
  } else if (key == "tree") {
    if (value != "keep" && value != "merge") return makeError(wrong("--add, tree", value, Text("keep or merge")));
    addition.options.merge = value == "merge";
  } else if (key == "on") {
    if (value.empty()) return makeError(wrong("--add, on", value, Text("NAME or NAME:LINK")));
    addition.on = value;
  } else if (key == "pose") {
    const auto pose = parsePose("--add", value);
    HAPTICELL_TRY(pose);
    addition.X_WE = *pose;
  } else {
    const bool chord = key == "chord";
    const auto number = trajectory::parseNumber(value);
    if (!number || !(*number >= (chord ? 1e-9 : 1e-3)) || !(*number <= (chord ? 1e3 : 3.0))) {
      return makeError(
          wrong("--add, " + key, value, chord ? Text("metres, 1e-9 to 1000") : Text("radians, 0.001 to 3")));
    }
    (chord ? addition.options.tessellation.chord : addition.options.tessellation.angle) = *number;
  }
  return {};
}

}  // namespace

Expected<Mounting> parseMounting(const std::string& option, const std::string& text) {
  const Arguments arguments = splitOptions(text, {"link", "pose"});
  Mounting mounting;
  mounting.what = arguments.head;
  if (mounting.what.empty()) return makeError(wrong(option, text, Text("a file, or library:NAME, first")));
  if (const std::string twice = saidTwice(arguments); !twice.empty()) {
    return makeError(wrong(option + ", " + twice, text, Text("each option at most once")));
  }
  for (const auto& [key, value] : arguments.options) {
    if (key == "link") {
      mounting.link = value;
      continue;
    }
    const auto pose = parsePose(option, value);
    HAPTICELL_TRY(pose);
    mounting.X_LE = *pose;
  }
  return mounting;
}

Expected<Addition> parseAddition(const std::string& text) {
  static const std::vector<std::string> kKeys{"name", "unit", "up", "tree", "chord", "angle", "on", "pose"};
  const Arguments arguments = splitOptions(text, kKeys);
  Addition addition;
  FileWithArguments source = splitXacroArguments(arguments.head);
  addition.what = std::move(source.file);
  addition.options.arguments = std::move(source.arguments);
  if (addition.what.empty()) return makeError(wrong("--add", text, Text("a file, or library:NAME, first")));
  if (const std::string unknown = unknownKey(addition.what); !unknown.empty()) {
    return makeError({.place = Text("--add %1", text),
                      .found = Text("no option is named '%1'", unknown),
                      .expected = Text("one of %1", listed(kKeys))});
  }
  if (const std::string twice = saidTwice(arguments); !twice.empty()) {
    return makeError(wrong("--add, " + twice, text, Text("each option at most once")));
  }
  for (const auto& [key, value] : arguments.options) {
    HAPTICELL_TRY(readOption(key, value, addition));
  }
  return addition;
}

Expected<workcell::PairSet> parseCheck(const std::string& text) {
  const Arguments arguments = splitOptions(text, {"near_miss", "safety"});
  const std::size_t colon = arguments.head.find(':');
  if (colon == std::string::npos || arguments.head.find(':', colon + 1) != std::string::npos) {
    return makeError(
        wrong("--check", arguments.head, Text("A+B:C+D: names of entities, one colon between the two sides")));
  }
  workcell::PairSet set;
  set.first = namesOf(arguments.head.substr(0, colon));
  set.second = namesOf(arguments.head.substr(colon + 1));
  if (set.first.empty() && set.second.empty()) {
    return makeError(
        wrong("--check", arguments.head, Text("A+B:C+D: names of entities, one colon between the two sides")));
  }
  std::set<std::string> seen;
  for (const auto* side : {&set.first, &set.second}) {
    for (const std::string& name : *side) {
      if (seen.insert(name).second) continue;
      return makeError(wrong("--check", arguments.head,
                             Text("each entity on one side only: an entity is not checked against itself")));
    }
  }
  if (const std::string twice = saidTwice(arguments); !twice.empty()) {
    return makeError(wrong("--check, " + twice, text, Text("each option at most once")));
  }
  for (const auto& [key, value] : arguments.options) {
    const auto number = trajectory::parseNumber(value);
    if (!number || !(*number >= 0.0 && *number <= 1.0)) {
      return makeError(wrong("--check, " + key, value, Text("metres, 0 to 1")));
    }
    (key == "safety" ? set.safety_distance : set.near_miss) = *number;
  }
  return set;
}

}  // namespace hapticell::cli
