// SPDX-License-Identifier: Apache-2.0
#include "config/device_profile.h"

#include <toml++/toml.h>

#include <charconv>
#include <cmath>
#include <set>

#include "config/toml_place.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"

namespace hapticell::config {

namespace {

std::string textOf(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

struct Range {
  double min;
  double max;
};

/// Walks through one table key by key; keeps the first error and the keys that were known.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string file, std::string section)
      : table_(table), file_(std::move(file)), section_(std::move(section)) {}

  void read(const char* key, double& value, const Range& range) {
    if (const toml::node* node = find(key)) takeNumber(*node, key, value, range);
  }
  void read(const char* key, int& value, const Range& range) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    double number = value;
    if (!node->is_integer())
      fail(*node, key, Text("not a whole number"), rangeText(range));
    else
      takeNumber(*node, key, number, range);
    value = static_cast<int>(number);
  }
  void read(const char* key, std::string& value) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const auto text = node->value<std::string>();
    if (!node->is_string() || text->empty())
      fail(*node, key, Text("the name is missing"), Text("a non-empty text"));
    else
      value = *text;
  }
  void read(const char* key, dvec3& value, const Range& range) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::array* numbers = node->as_array();
    if (numbers == nullptr || numbers->size() != 3) {
      fail(*node, key, Text("not a list of three numbers"), Text("[width, depth, height], each %1", rangeText(range)));
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      takeNumber(*numbers->get(i), key, value[static_cast<glm::length_t>(i)], range);
    }
  }

  /// The first error, a key that nobody asked for included.
  std::optional<Error> finish() {
    for (const auto& [key, node] : table_) {
      if (!error_ && !known_.contains(key.str()))
        fail(node, std::string(key.str()), Text("this key does not exist"), {});
    }
    return error_;
  }

 private:
  static std::string rangeText(const Range& range) { return textOf(range.min) + " .. " + textOf(range.max); }

  const toml::node* find(const char* key) {
    known_.insert(key);
    return error_ ? nullptr : table_.get(key);
  }
  void takeNumber(const toml::node& node, const std::string& key, double& value, const Range& range) {
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    if (!number)
      fail(node, key, Text("not a number"), rangeText(range));
    else if (!(*number >= range.min && *number <= range.max))
      fail(node, key, textOf(*number), rangeText(range));
    else
      value = *number;
  }
  void fail(const toml::node& node, const std::string& key, const Text& found, const Text& expected) {
    if (!error_)
      error_ = Error{.file = file_,
                     .place = Text("%1, key '%2'", lineOf(node), section_ + '.' + key),
                     .found = found,
                     .expected = expected};
  }

  const toml::table& table_;
  std::string file_;
  std::string section_;
  std::set<std::string, std::less<>> known_;
  std::optional<Error> error_;
};

void readCapabilities(TableReader& table, DeviceProfile& profile) {
  table.read("name", profile.name);
  table.read("workspace", profile.workspace, {0.01, 2.0});
  table.read("resolution", profile.resolution, {1e-7, 0.01});
  table.read("rotation_resolution", profile.rotation_resolution, {0.0, 0.1});
  table.read("measured_axes", profile.measured_axes, {3, 6});
  table.read("driven_axes", profile.driven_axes, {3, 6});
  table.read("buttons", profile.buttons, {0, 8});
  table.read("peak_force", profile.peak_force, {0.1, 100.0});
  table.read("continuous_force", profile.continuous_force, {0.1, 100.0});
  table.read("peak_torque", profile.peak_torque, {0.0, 10.0});
  table.read("stiffness", profile.stiffness, {10.0, 20000.0});
  table.read("damping", profile.damping, {0.1, 50.0});
}

void readMechanics(TableReader& table, DeviceProfile& profile) {
  table.read("apparent_mass", profile.mechanics.apparent_mass, {0.005, 5.0});
  table.read("coulomb_friction", profile.mechanics.coulomb_friction, {0.0, 10.0});
  table.read("viscous_friction", profile.mechanics.viscous_friction, {0.0, 10.0});
  table.read("weight", profile.mechanics.weight, {0.0, 50.0});
  table.read("upper_arm", profile.mechanics.upper_arm, {0.02, 2.0});
  table.read("forearm", profile.mechanics.forearm, {0.02, 2.0});
  table.read("stop_stiffness", profile.mechanics.stop_stiffness, {100.0, 50000.0});
  table.read("stop_damping", profile.mechanics.stop_damping, {0.0, 100.0});
}

void readElectronics(TableReader& table, DeviceProfile& profile) {
  table.read("converter_range", profile.electronics.converter_range, {0.1, 100.0});
  table.read("converter_bits", profile.electronics.converter_bits, {6, 24});
  table.read("delay_ticks", profile.electronics.delay_ticks, {0, 15});
  table.read("thermal_time", profile.electronics.thermal_time, {0.1, 3600.0});
}

using SectionReader = void (*)(TableReader&, DeviceProfile&);

struct Section {
  const char* name;
  SectionReader read;
};

constexpr Section kSections[] = {
    {"capabilities", readCapabilities}, {"mechanics", readMechanics}, {"electronics", readElectronics}};

std::optional<Error> readSection(const toml::node& node, const std::string& key, const std::string& file,
                                 DeviceProfile& profile) {
  for (const Section& section : kSections) {
    if (key != section.name) continue;
    const toml::table* table = node.as_table();
    if (table == nullptr)
      return Error{.file = file,
                   .place = Text("%1, key '%2'", lineOf(node), key),
                   .found = "not a table",
                   .expected = "[" + key + "]"};
    TableReader reader(*table, file, key);
    section.read(reader, profile);
    return reader.finish();
  }
  return Error{.file = file,
               .place = Text("%1, key '%2'", lineOf(node), key),
               .found = "this key does not exist",
               .expected = "[capabilities], [mechanics] or [electronics]"};
}

}  // namespace

Expected<DeviceProfile> parseDeviceProfile(std::string_view text, const std::string& name) {
  HAPTICELL_TRY(geometry::checkNesting(text, geometry::NestedText::kToml, name));
  DeviceProfile profile;
  toml::table document;
  try {
    document = toml::parse(text, name);
  } catch (const toml::parse_error& problem) {
    const auto& at = problem.source().begin;
    const Text place("line %1, column %2", at.line, at.column);
    return makeError({.file = name, .place = place, .found = std::string(problem.description()), .expected = "TOML"});
  }
  for (const auto& [key, node] : document) {
    if (auto error = readSection(node, std::string(key.str()), name, profile)) return makeError(std::move(*error));
  }
  if (profile.continuous_force > profile.peak_force) {
    return makeError({.file = name,
                      .place = Text("key '%1'", "capabilities.continuous_force"),
                      .found = textOf(profile.continuous_force),
                      .expected = Text("at most peak_force, %1", textOf(profile.peak_force))});
  }
  if (profile.driven_axes != 3 && profile.driven_axes != 6) {
    return makeError({.file = name,
                      .place = Text("key '%1'", "capabilities.driven_axes"),
                      .found = std::to_string(profile.driven_axes),
                      .expected = "3 (force) or 6 (force and torque)"});
  }
  if ((profile.driven_axes == 6) != (profile.peak_torque > 0.0)) {
    return makeError({.file = name,
                      .place = Text("key '%1'", "capabilities.peak_torque"),
                      .found = textOf(profile.peak_torque),
                      .expected = "above 0 with driven_axes = 6, else 0"});
  }
  return profile;
}

Expected<DeviceProfile> readDeviceProfile(const std::filesystem::path& file) {
  // Bytes: guards memory; a profile is some kB. Half, twice: no effect.
  constexpr std::uintmax_t kMostBytes = 1'000'000;
  const auto text = geometry::readRegularFile(file, kMostBytes);
  if (!text) return makeError({.file = file.string(), .found = text.error().found, .expected = "a device profile"});
  return parseDeviceProfile(*text, file.string());
}

}  // namespace hapticell::config
