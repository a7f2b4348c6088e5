// SPDX-License-Identifier: Apache-2.0
#include "cli/session/session_settings.h"

#include <charconv>
#include <cmath>

namespace hapticell::cli {

namespace {

using manipulation::SessionOptions;

/// Takes over a parsed value, or hands the error on.
template <typename Parsed, typename Target>
Expected<void> take(Parsed&& parsed, Target& target) {
  HAPTICELL_TRY(parsed);
  target = *parsed;
  return {};
}

Expected<void> setForces(const std::string& value, SessionOptions& options) {
  if (value != "on" && value != "off")
    return makeError({.place = "--set forces", .found = "'" + value + "'", .expected = "on or off"});
  options.forces = value == "on";
  return {};
}

Expected<void> setSafetyDistance(const std::string& value, SessionOptions& options) {
  double metres = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), metres);
  const bool number = error == std::errc() && end == value.data() + value.size();
  if (!number || !std::isfinite(metres) || metres < 0.0 || metres > 1.0) {
    return makeError({.place = "--set safety_distance", .found = "'" + value + "'", .expected = "metres from 0 to 1"});
  }
  options.configuration.manipulation.safety_distance = metres;
  for (workcell::PairSet& set : options.pairs.sets) set.safety_distance = metres;
  return {};
}

std::string knownKeys(const SessionOptions& options) {
  std::string keys = "moved_by, lock, axes, scale, force_class, on_contact, filter, forces, safety_distance, plan_goal, plan_hints, "
                     "plan_authority, plan_clearance";
  for (const config::Setting& setting : config::settings(options.configuration)) keys += ", " + setting.key;
  return keys;
}

bool isConfigurationKey(const std::string& key, const SessionOptions& options) {
  for (const config::Setting& setting : config::settings(options.configuration)) {
    if (setting.key == key) return true;
  }
  return false;
}

}  // namespace

Expected<void> applySessionSetting(const std::string& setting, SessionOptions& options, SessionPlanWords& plan) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || equals == 0) {
    return makeError({.place = "--set", .found = "'" + setting + "'", .expected = "KEY=VALUE"});
  }
  const std::string key = setting.substr(0, equals), value = setting.substr(equals + 1);
  if (key == "moved_by") {
    const manipulation::BodyLocks* locked = manipulation::locksOf(options.moved_by);
    const manipulation::BodyLocks locks = locked ? *locked : manipulation::BodyLocks();
    auto moved_by = manipulation::parseMovedBy(value);
    HAPTICELL_TRY(moved_by);
    HAPTICELL_TRY(manipulation::setLocks(*moved_by, locks));
    options.moved_by = std::move(*moved_by);
    return {};
  }
  if (key == "axes") return take(manipulation::parseAxes(value), options.axes);
  if (key == "scale") return take(manipulation::parseScale(value), options.scale);
  if (key == "filter") return take(manipulation::parseFilter(value), options.filter);
  if (key == "forces") return setForces(value, options);
  if (key == "safety_distance" || key == "manipulation.safety_distance") return setSafetyDistance(value, options);
  if (key == "on_contact" || key == "manipulation.on_contact") {
    return take(manipulation::parseOnContact(value), options.on_contact);
  }
  if (key == "force_class" || key == "manipulation.force_class") {
    return take(manipulation::parseForceClass(value), options.force_class);
  }
  if (key == "plan_goal" || key == "plan_hints") {
    (key == "plan_goal" ? plan.goal : plan.hints) = value;
    return {};
  }
  if (key == "plan_authority" || key == "plan_clearance")
    return config::setValue(options.configuration, "manipulation." + key, value);
  if (key == "lock") {
    const auto locks = manipulation::parseLock(value);
    HAPTICELL_TRY(locks);
    return manipulation::setLocks(options.moved_by, *locks);
  }
  if (!isConfigurationKey(key, options)) {
    return makeError({.place = "--set",
                      .found = Text("no key is named '%1'", key),
                      .expected = Text("one of %1", knownKeys(options))});
  }
  return config::setValue(options.configuration, key, value);
}

Expected<config::DeviceProfile> simulatedDevice(const std::string& name) {
  const auto file = config::findShippedFile("devices/" + name + ".toml");
  if (file) return config::readDeviceProfile(*file);
  return makeError({.place = "--device",
                    .found = Text("no simulated device is named '%1'", name),
                    .expected = "phantom_desktop, touch, touch_x, premium or premium_6dof"});
}

}  // namespace hapticell::cli
