// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/posture_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"

namespace hapticell::mannequin {

namespace {

using nlohmann::ordered_json;
constexpr int kVersion = 1;
// A little over one turn, against files in degrees. Half: some angles of a full turn are refused; twice: 10 deg are
// read as 10 rad.
constexpr double kMostAngle = 7.0;

/// `count` finite numbers, or nothing.
std::optional<std::vector<double>> numbers(const ordered_json& json, std::size_t count) {
  if (!json.is_array() || json.size() != count) return std::nullopt;
  std::vector<double> result;
  for (const auto& value : json) {
    if (!value.is_number() || !std::isfinite(value.get<double>()) || std::abs(value.get<double>()) > 1e6)
      return std::nullopt;
    result.push_back(value.get<double>());
  }
  return result;
}

Expected<void> readRoot(const ordered_json& json, const std::string& name, Posture& posture) {
  if (!json.is_object())
    return makeError({.file = name,
                      .place = Text::plain("\"root\""),
                      .found = "not a JSON object",
                      .expected = Text::plain("{\"position\":[..],\"orientation\":[..]}")});
  if (json.contains("position")) {
    const auto p = numbers(json["position"], 3);
    if (!p)
      return makeError({.file = name,
                        .place = Text::plain("\"root\".\"position\""),
                        .found = "the position is missing or invalid",
                        .expected = "three numbers in metres"});
    posture.X_WR.p = {(*p)[0], (*p)[1], (*p)[2]};
  }
  if (json.contains("orientation")) {
    const auto q = numbers(json["orientation"], 4);
    const dquat raw = q ? dquat((*q)[0], (*q)[1], (*q)[2], (*q)[3]) : dquat(0.0, 0.0, 0.0, 0.0);
    if (!(std::abs(glm::length(raw) - 1.0) < 0.01)) {
      return makeError({.file = name,
                        .place = Text::plain("\"root\".\"orientation\""),
                        .found = "not a unit quaternion",
                        .expected = "w, x, y, z with length 1"});
    }
    posture.X_WR.q = glm::normalize(raw);
  }
  return {};
}

Expected<void> readJoints(const ordered_json& json, double unit, const std::string& name, Posture& posture) {
  if (!json.is_object())
    return makeError({.file = name,
                      .place = Text::plain("\"joints\""),
                      .found = "not a JSON object",
                      .expected = "joint names with angles"});
  for (const auto& [key, value] : json.items()) {
    const std::optional<Dof> dof = findDof(key);
    const Text place("joint '%1'", key.substr(0, 60));
    if (!dof) {
      return makeError({.file = name,
                        .place = place,
                        .found = "the mannequin has no such joint",
                        .expected = "a name such as l_elbow_flexion",
                        .fix = "To list all 56 joints, run hapticell-cli mannequin."});
    }
    const double angle = value.is_number() ? value.get<double>() * unit : NAN;
    if (!(std::abs(angle) <= kMostAngle))
      return makeError({.file = name, .place = place, .found = "not an angle", .expected = "a number within +-7 rad"});
    posture[*dof] = angle;
  }
  return {};
}

Expected<void> checkHead(const ordered_json& json, const std::string& name) {
  if (!json.is_object()) return makeError({.file = name, .found = "not a JSON object", .expected = "a posture"});
  const std::string format =
      json.contains("format") && json["format"].is_string() ? json["format"].get<std::string>() : "";
  if (format != "hapticell-posture") {
    return makeError({.file = name,
                      .place = Text::plain("\"format\""),
                      .found = format.empty() ? Text("nothing") : Text("\"%1\"", format.substr(0, 60)),
                      .expected = Text::plain("\"hapticell-posture\"")});
  }
  const bool known = !json.contains("version") || (json["version"].is_number_integer() && json["version"] == kVersion);
  if (!known)
    return makeError({.file = name,
                      .place = Text::plain("\"version\""),
                      .found = json["version"].dump().substr(0, 40),
                      .expected = "1",
                      .fix = "Use a newer HaptiCell."});
  return {};
}

}  // namespace

std::string postureText(const Posture& posture) {
  ordered_json json;
  json["format"] = "hapticell-posture";
  json["version"] = kVersion;
  const dvec3 p = posture.X_WR.p;
  const dquat q = posture.X_WR.q;
  json["root"] = {{"position", {p.x, p.y, p.z}}, {"orientation", {q.w, q.x, q.y, q.z}}};
  json["unit"] = "rad";
  ordered_json joints = ordered_json::object();
  for (std::size_t i = 0; i < kDofCount; ++i) joints[dofInfo(static_cast<Dof>(i)).name] = posture.angles[i];
  json["joints"] = std::move(joints);
  json["gaze"] = {posture.gaze.yaw, posture.gaze.pitch};
  return json.dump(2) + "\n";
}

Expected<Posture> parsePosture(std::string_view text, const std::string& name, bool* has_root) {
  auto flat = geometry::checkNesting(text, geometry::NestedText::kOrderedJson, name);
  HAPTICELL_TRY(flat);
  const ordered_json json = ordered_json::parse(text.begin(), text.end(), nullptr, false);
  if (json.is_discarded()) return makeError({.file = name, .found = "text that is not JSON", .expected = "a posture"});
  HAPTICELL_TRY(checkHead(json, name));
  double unit = 1.0;
  if (json.contains("unit")) {
    if (json["unit"] != "deg" && json["unit"] != "rad")
      return makeError({.file = name,
                        .place = Text::plain("\"unit\""),
                        .found = json["unit"].dump().substr(0, 40),
                        .expected = "rad or deg"});
    if (json["unit"] == "deg") unit = std::numbers::pi / 180.0;
  }
  Posture posture;
  if (has_root) *has_root = json.contains("root");
  if (json.contains("root")) {
    HAPTICELL_TRY(readRoot(json["root"], name, posture));
  }
  if (json.contains("joints")) {
    HAPTICELL_TRY(readJoints(json["joints"], unit, name, posture));
  }
  if (json.contains("gaze")) {
    const auto gaze = numbers(json["gaze"], 2);
    if (!gaze)
      return makeError({.file = name,
                        .place = Text::plain("\"gaze\""),
                        .found = "not two numbers",
                        .expected = Text::plain("[yaw, pitch]")});
    posture.gaze = {(*gaze)[0] * unit, (*gaze)[1] * unit};
  }
  return posture;
}

Expected<Posture> readPosture(const std::filesystem::path& file, bool* has_root) {
  // Guards memory: a posture is some kB. Half, twice: no effect.
  constexpr std::uintmax_t kMostPostureBytes = 1'000'000;
  const auto text = geometry::readRegularFile(file, kMostPostureBytes);
  HAPTICELL_TRY(text);
  return parsePosture(*text, file.string(), has_root);
}

}  // namespace hapticell::mannequin
