// SPDX-License-Identifier: Apache-2.0
#include <poll.h>
#include <unistd.h>

#include <array>
#include <memory>

#include "cli/device/device_commands.h"
#include "cli/device/device_list.h"
#include "config/configuration.h"
#include "haptic/devices/presence_watch.h"

namespace hapticell::cli {

namespace {

using haptic::LoadedDriver;
using nlohmann::ordered_json;

// ms: an idle machine stays idle, and a plugged device is seen before one looks again. Half: twice the looks; twice:
// one waits for it.
constexpr int kWatchPeriod = 2000;

struct DeviceWords {
  std::string configuration;
  bool watch = false;
};

enum class Input { kNothing, kAsked, kEnded };

/// Waits for a line of standard input; whatever it says asks for a new look.
Input waitForInput() {
  pollfd waited{STDIN_FILENO, POLLIN, 0};
  if (poll(&waited, 1, kWatchPeriod) <= 0) return Input::kNothing;
  std::array<char, 256> words{};
  return read(STDIN_FILENO, words.data(), words.size()) > 0 ? Input::kAsked : Input::kEnded;
}

/// Writes the listing, and again whenever it has become another one, until standard input ends. A driver is asked for
/// its devices only when it sees other ones, or when the user wants it: looking may take its device for a moment.
ExitStatus watch(const std::vector<LoadedDriver>& drivers, const std::vector<std::filesystem::path>& folders,
                 const ResultWriter& writer) {
  haptic::PresenceWatch presence(drivers);
  std::vector<DriverEntries> entries{simulatedEntries()};
  for (const LoadedDriver& loaded : drivers) entries.push_back(entriesAskedApart(loaded));
  ordered_json told;
  for (Input input = Input::kAsked; input != Input::kEnded; input = waitForInput()) {
    const bool asked = input == Input::kAsked && !told.is_null();
    std::vector<std::size_t> changed = presence.look();
    if (asked) {
      changed.resize(drivers.size());
      for (std::size_t i = 0; i < changed.size(); ++i) changed[i] = i;
    }
    for (const std::size_t i : changed) entries[1 + i] = entriesAskedApart(drivers[i]);
    ordered_json listing = listingOf(entries, folders);
    if (!asked && listing == told) continue;
    if (const auto written = writer.writeLine(listing); !written) {
      report(written.error());
      return ExitStatus::kBadInput;
    }
    told = std::move(listing);
  }
  return ExitStatus::kDone;
}

ExitStatus run(const DeviceWords& words, const ResultWriter& writer) {
  const auto configuration = config::loadConfiguration(words.configuration);
  if (!configuration) {
    report(configuration.error());
    return ExitStatus::kBadInput;
  }
  const auto folders = haptic::driverFolders();
  const auto drivers = haptic::loadDrivers(folders, configuration->drivers);
  if (words.watch) return watch(drivers, folders, writer);
  std::vector<DriverEntries> entries{simulatedEntries()};
  for (const LoadedDriver& loaded : drivers) entries.push_back(entriesAskedApart(loaded));
  if (const auto written = writer.write(listingOf(entries, folders)); !written) {
    report(written.error());
    return ExitStatus::kBadInput;
  }
  return ExitStatus::kDone;
}

}  // namespace

void addDevicesCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add(
      "devices", "List styluses, gloves and 3D mice: drivers, connected devices, permissions, and how to fix problems");
  const auto words = std::make_shared<DeviceWords>();
  command.option("--config", words->configuration, "hapticell.toml whose values override the shipped ones")
      .takes(ValueKind::kToml);
  command.flag("--watch", words->watch, "Keep running; print a line on each change. Enter rescans, Ctrl+D quits");
  command.onChosen([words, &chosen] { chosen = [words](ResultWriter& writer) { return run(*words, writer); }; });
}

}  // namespace hapticell::cli
