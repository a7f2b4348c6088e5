// SPDX-License-Identifier: Apache-2.0
#include "config/configuration.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "config/setting_visitor.h"
#include "geometry/system/listed.h"

namespace hapticell::config {

namespace {

std::string toText(double value) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::string toText(int value) {
  return std::to_string(value);
}
std::string toText(bool value) {
  return value ? "true" : "false";
}
std::string toText(const std::string& value) {
  return '"' + value + '"';
}

std::string rangeText(const NumberRange& range) {
  return toText(range.min) + " .. " + toText(range.max);
}

std::string rangeText(const Choices& choices) {
  return choices.empty() ? "any text" : listed(choices);
}

bool parse(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

bool parse(std::string_view text, bool& value) {
  value = text == "true" || text == "on" || text == "1";
  return value || text == "false" || text == "off" || text == "0";
}

/// Takes one text into the key that it names.
struct TextSetter {
  std::string_view wanted;
  std::string_view text;
  bool known = false;
  Text problem_range;  ///< Filled when the value does not fit.

  void operator()(const std::string& key, bool& target, const NumberRange&) {
    if (key != wanted) return;
    known = true;
    bool value = false;
    if (parse(text, value))
      target = value;
    else
      problem_range = Text("true or false");
  }
  template <typename Number>
  void operator()(const std::string& key, Number& target, const NumberRange& range) {
    if (key != wanted) return;
    known = true;
    double value = 0.0;
    const bool whole = !std::is_integral_v<Number> || (parse(text, value) && value == std::floor(value));
    if (whole && parse(text, value) && value >= range.min && value <= range.max)
      target = static_cast<Number>(value);
    else
      problem_range = rangeText(range);
  }
  void operator()(const std::string& key, std::string& target, const Choices& choices) {
    if (key != wanted) return;
    known = true;
    if (choices.empty() || std::find(choices.begin(), choices.end(), text) != choices.end())
      target = text;
    else
      problem_range = choices.empty() ? Text("any text") : Text(listed(choices));
  }
};

/// The known key that looks most like an unknown one: the longest common start.
std::string likeliest(const Configuration& configuration, std::string_view key) {
  std::string best;
  std::size_t best_length = 2;
  for (const Setting& setting : settings(configuration)) {
    const auto end = std::mismatch(key.begin(), key.end(), setting.key.begin(), setting.key.end()).first;
    const auto length = static_cast<std::size_t>(end - key.begin());
    if (length > best_length) {
      best_length = length;
      best = setting.key;
    }
  }
  return best;
}

/// driver.NAME.KEY: taken as it stands, since only the driver knows its keys.
bool setDriverValue(Configuration& configuration, std::string_view key, std::string_view text) {
  constexpr std::string_view kPrefix = "driver.";
  if (key.substr(0, kPrefix.size()) != kPrefix) return false;
  key.remove_prefix(kPrefix.size());
  const std::size_t dot = key.find('.');
  if (dot == 0 || dot == std::string_view::npos || dot + 1 == key.size()) return false;
  configuration.drivers[std::string(key.substr(0, dot))][std::string(key.substr(dot + 1))] = text;
  return true;
}

}  // namespace

Expected<void> setValue(Configuration& configuration, std::string_view key, std::string_view text) {
  if (setDriverValue(configuration, key, text)) return {};
  TextSetter setter{key, text, false, {}};
  visitSettings(configuration, setter);
  if (!setter.known) {
    const std::string like = likeliest(configuration, key);
    return makeError({.place = Text("key '%1'", key),
                      .found = "this key does not exist",
                      .expected = like.empty() ? Text() : Text("a key like %1", like),
                      .fix = "The shipped hapticell.toml lists all keys."});
  }
  if (!setter.problem_range.empty()) {
    return makeError(
        {.place = Text("key '%1'", key), .found = "\"" + std::string(text) + "\"", .expected = setter.problem_range});
  }
  return {};
}

std::vector<Setting> settings(const Configuration& configuration) {
  std::vector<Setting> all;
  visitSettings(configuration, [&](const std::string& key, const auto& value, const auto& limits) {
    const bool flag = std::is_same_v<std::decay_t<decltype(value)>, bool>;
    all.push_back({key, toText(value), flag ? "true, false" : rangeText(limits)});
  });
  for (const auto& [driver, values] : configuration.drivers) {
    const std::string before = "driver." + driver + ".";
    for (const auto& [key, value] : values) all.push_back({before + key, value, "any text"});
  }
  return all;
}

}  // namespace hapticell::config
