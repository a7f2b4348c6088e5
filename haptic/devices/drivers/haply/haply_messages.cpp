// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/haply/haply_messages.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace hapticell::driver {

namespace {

using nlohmann::json;

const json* member(const json* node, const char* name) {
  if (node == nullptr || !node->is_object()) return nullptr;
  const auto found = node->find(name);
  return found != node->end() ? &*found : nullptr;
}

std::optional<double> number(const json* node, const char* name) {
  const json* const value = member(node, name);
  if (value == nullptr || !value->is_number()) return std::nullopt;
  const double result = value->get<double>();
  return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

std::optional<dvec3> vector(const json* node) {
  const auto x = number(node, "x"), y = number(node, "y"), z = number(node, "z");
  if (!x || !y || !z) return std::nullopt;
  return dvec3(*x, *y, *z);
}

bool pressed(const json* buttons, const char* name) {
  const json* const value = member(buttons, name);
  return value != nullptr &&
         ((value->is_boolean() && value->get<bool>()) || (value->is_number() && value->get<double>() != 0.0));
}

/// The grip's orientation and buttons; false where there is a grip that tells nonsense.
bool readGrip(const json& document, HaplyReport& report) {
  for (const char* name : {"wireless_verse_grip", "wired_verse_grip"}) {
    const json* const grips = member(&document, name);
    if (grips == nullptr || !grips->is_array() || grips->empty()) continue;
    const json* const state = member(&(*grips)[0], "state");
    const json* const turned = member(state, "orientation");
    if (turned != nullptr) {
      const auto v = vector(turned);
      const auto w = number(turned, "w");
      if (!v || !w) return false;
      const dquat q(*w, v->x, v->y, v->z);
      if (std::abs(glm::length(q) - 1.0) > 0.05) return false;
      report.orientation = glm::normalize(q);
    }
    const json* const buttons = member(state, "buttons");
    report.buttons =
        (pressed(buttons, "a") ? 1u : 0u) | (pressed(buttons, "b") ? 2u : 0u) | (pressed(buttons, "c") ? 4u : 0u);
    return true;
  }
  return true;
}

}  // namespace

std::optional<std::vector<HaplyReport>> readHaplyMessage(const std::string& text) {
  const json document = json::parse(text, nullptr, false);
  if (!document.is_object()) return std::nullopt;
  std::vector<HaplyReport> reports;
  const json* const devices = member(&document, "inverse3");
  if (devices == nullptr) return reports;
  if (!devices->is_array()) return std::nullopt;
  for (const json& device : *devices) {
    HaplyReport report;
    const json* const id = member(&device, "device_id");
    const auto cursor = vector(member(member(&device, "state"), "cursor_position"));
    if (id == nullptr || !id->is_string() || !cursor || !readGrip(document, report)) return std::nullopt;
    report.device_id = id->get<std::string>();
    report.cursor = *cursor;
    reports.push_back(std::move(report));
  }
  return reports;
}

std::string haplyForceCommand(const std::string& device_id, const dvec3& force) {
  const json values{{"x", force.x}, {"y", force.y}, {"z", force.z}};
  const json command{
      {"inverse3", {{{"device_id", device_id}, {"commands", {{"set_cursor_force", {{"values", values}}}}}}}}};
  return command.dump();
}

}  // namespace hapticell::driver
