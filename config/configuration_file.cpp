// SPDX-License-Identifier: Apache-2.0
#include <toml++/toml.h>

#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "config/configuration.h"
#include "config/program_folders.h"
#include "config/toml_place.h"
#include "config/user_folders.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"

namespace hapticell::config {

namespace {

namespace fs = std::filesystem;

// Bytes: guards memory; settings are some kB. Half, twice: no effect.
constexpr std::uintmax_t kLargestSettings = 1'000'000;

/// A value of the file as the text that setValue takes; empty optional for arrays, tables and dates.
std::optional<std::string> textOf(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* number = node.as_floating_point()) {
    char buffer[64];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, number->get()).ptr);
  }
  return std::nullopt;
}

Expected<void> applyPreset(Configuration& configuration, const toml::node& node) {
  const std::string preset = node.value_or(std::string());
  if (preset == "shipped") return {};
  if (preset != "classic")
    return makeError({.place = Text("%1, key '%2'", lineOf(node), "preset"),
                      .found = "\"" + preset + "\"",
                      .expected = "shipped or classic"});
  configuration.manipulation.rate_hz = 10.0;
  configuration.gui.rate_hz = 10.0;
  return {};
}

/// A material that the file adds starts from the shipped defaults of the struct.
void makeRoomForMaterials(Configuration& configuration, const toml::table& root) {
  const toml::table* materials = root["materials"].as_table();
  if (materials == nullptr) return;
  for (const auto& [name, node] : *materials) {
    if (node.is_table()) configuration.materials.try_emplace(std::string(name.str()));
  }
}

Expected<void> applyTable(Configuration& configuration, const toml::table& table, const std::string& prefix) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
    if (key == "preset") continue;
    if (const toml::table* below = node.as_table()) {
      if (auto done = applyTable(configuration, *below, key); !done) return done;
      continue;
    }
    const std::optional<std::string> text = textOf(node);
    auto done = text ? setValue(configuration, key, *text)
                     : Expected<void>(makeError(
                           {.place = Text("key '%1'", key), .found = "a list or a date", .expected = "one value"}));
    if (!done) {
      Error error = done.error();
      error.place = Text("%1, %2", lineOf(node), error.place);
      return makeError(error);
    }
  }
  return {};
}

}  // namespace

Expected<Configuration> readConfiguration(const std::string& path, const Configuration& base) {
  const auto text = geometry::readRegularFile(path, kLargestSettings);
  HAPTICELL_TRY(text);
  HAPTICELL_TRY(geometry::checkNesting(*text, geometry::NestedText::kToml, path));
  toml::table root;
  try {
    root = toml::parse(*text, path);
  } catch (const toml::parse_error& problem) {
    const auto line = problem.source().begin.line;
    return makeError({.file = path,
                      .place = line > 0 ? Text("line %1", line) : Text(),
                      .found = std::string(problem.description())});
  }
  Configuration configuration = base;
  Expected<void> done;
  if (const toml::node* preset = root.get("preset")) done = applyPreset(configuration, *preset);
  makeRoomForMaterials(configuration, root);
  if (done) done = applyTable(configuration, root, "");
  if (!done) {
    Error error = done.error();
    error.file = path;
    return makeError(error);
  }
  return configuration;
}

Expected<std::string> findShippedFile(const std::string& relative) {
  std::vector<fs::path> folders;
  if (const char* named = std::getenv("HAPTICELL_CONFIG_DIR")) {
    if (!fs::path(named).is_absolute())
      return makeError(
          {.place = "HAPTICELL_CONFIG_DIR", .found = "'" + std::string(named) + "'", .expected = "an absolute path"});
    folders.emplace_back(named);
  }
  std::error_code ignored;
  for (const fs::path& programs : programFolders()) folders.push_back(programs.parent_path() / "share" / "hapticell");
  folders.emplace_back(HAPTICELL_CONFIG_SOURCE_DIR);
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / relative, ignored)) return (folder / relative).string();
  }
  return makeError({.file = relative,
                    .found = "not found in the folders of shipped files",
                    .fix = "Set HAPTICELL_CONFIG_DIR to the folder that holds hapticell.toml."});
}

Expected<Configuration> loadConfiguration(const std::string& extra) {
  const auto shipped = findShippedFile("hapticell.toml");
  HAPTICELL_TRY(shipped);
  auto configuration = readConfiguration(*shipped);
  const auto folder = userSettingsFolder();
  HAPTICELL_TRY(folder);
  const fs::path own = *folder / "hapticell.toml";
  std::error_code ignored;
  if (fs::exists(own, ignored)) {
    HAPTICELL_TRY(checkUserFile(own));
    if (configuration) configuration = readConfiguration(own.string(), *configuration);
  }
  if (configuration && !extra.empty()) configuration = readConfiguration(extra, *configuration);
  return configuration;
}

}  // namespace hapticell::config
