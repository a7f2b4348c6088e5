// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::haptic {

/// What hapticell-haptic-server is asked to do on its command line.
struct ServerOptions {
  std::optional<std::string> device;  ///< A profile in config/devices/, or DRIVER[:ID]; else the configuration's.
  std::string listen = "127.0.0.1";
  std::optional<std::uint16_t> port;  ///< 0: any; else the configuration's.
  std::string config;                 ///< A hapticell.toml to read besides the usual ones.
  double seconds = 0.0;               ///< Ends by itself after so long; 0: runs until it is told to stop.
  double state_rate_hz = 1000.0;
  std::string record;     ///< A *.hdev that the device's session is recorded in; empty: none.
  std::string fault_log;  ///< Folder that the ticks around a fault are written to; empty: the default one.
  std::string
      key;  ///< A key file that clients must have, wherever it listens; empty: beyond this machine the user's own.
  bool pair = false;      ///< Make a key, keep it, show its code and end.
  bool real_time = true;  ///< Ask for real-time priority and locked memory.
  bool help = false, version = false;
};

/// What the command line's words mean. A word that is not known, a missing or a bad value is an Error that names it.
Expected<ServerOptions> parseServerOptions(std::span<const std::string_view> words);

/// The text of --help.
std::string_view serverUsage();

}  // namespace hapticell::haptic
