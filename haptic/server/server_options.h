// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "config/log_level.h"
#include "geometry/system/error.h"

namespace hapticell::haptic {

/// Command-line options of hapticell-haptic-server.
struct ServerOptions {
  std::optional<std::string> device;  ///< A profile in config/devices/, or DRIVER[:ID]; else the configuration's.
  std::string listen = "127.0.0.1";
  std::optional<std::uint16_t> port;  ///< 0: any; else the configuration's.
  std::string config;                 ///< A hapticell.toml to read in addition to the usual ones.
  double seconds = 0.0;               ///< Ends after this time; 0: runs until it is stopped.
  double state_rate_hz = 1000.0;
  std::string record;     ///< A *.hdev file for recording the device's session; empty: no recording.
  std::string fault_log;  ///< Folder for the ticks around a fault; empty: the default one.
  config::LogLevel log_level = config::LogLevel::kInfo;  ///< Of standard error and of the log file.
  std::string key;  ///< Key file that clients need, wherever it listens; empty: the user's own key beyond this machine.
  bool pair = false;      ///< Make and save a key, show its code and exit.
  bool real_time = true;  ///< Request real-time priority and locked memory.
  bool help = false, version = false;
};

/// Parses the command line. An unknown word and a missing or invalid value are Errors that name it.
Expected<ServerOptions> parseServerOptions(std::span<const std::string_view> words);

/// The text of --help.
std::string_view serverUsage();

}  // namespace hapticell::haptic
