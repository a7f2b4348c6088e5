// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/server_options.h"

#include <charconv>
#include <cmath>

namespace hapticell::haptic {

namespace {

tl::unexpected<Error> refuse(std::string_view option, Text found, Text expected) {
  return makeError({.file = "command line",
                    .place = std::string(option),
                    .found = std::move(found),
                    .expected = std::move(expected),
                    .fix = "hapticell-haptic-server --help lists the options."});
}

/// A number written as in C, whatever the locale; nothing when `text` is not one, or out of range.
template <typename T>
std::optional<T> number(std::string_view text, T least, T most) {
  T value{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size() || !(value >= least && value <= most)) return {};
  return value;
}

bool setSwitch(ServerOptions& options, std::string_view option) {
  if (option == "--help" || option == "-h") return options.help = true;
  if (option == "--version") return options.version = true;
  if (option == "--pair") return options.pair = true;
  if (option == "--no-real-time") {
    options.real_time = false;
    return true;
  }
  return false;
}

Expected<void> setValue(ServerOptions& options, std::string_view option, std::string_view value) {
  const std::string found = std::string("\"").append(value).append("\"");
  if (option == "--device") options.device = value;
  if (option == "--listen") options.listen = value;
  if (option == "--config") options.config = value;
  if (option == "--key") options.key = value;
  if (option == "--record") options.record = value;
  if (option == "--fault-log") options.fault_log = value;
  if (option == "--log-level") {
    const auto level = config::logLevelFrom(value);
    HAPTICELL_TRY(level);
    options.log_level = *level;
  }
  if (option == "--port") {
    options.port = number<std::uint16_t>(value, 0, 65535);
    if (!options.port) return refuse(option, found, Text("a port from 0 (any) to 65535"));
  }
  if (option == "--seconds") {
    const auto seconds = number(value, 0.0, 1e9);
    if (!seconds) return refuse(option, found, Text("seconds, 0 or more (0: no limit)"));
    options.seconds = *seconds;
  }
  if (option == "--state-rate") {
    const auto rate = number(value, 1.0, 10000.0);
    if (!rate) return refuse(option, found, Text("1 to 10000 per second"));
    options.state_rate_hz = *rate;
  }
  return {};
}

bool takesValue(std::string_view option) {
  for (const std::string_view known : {"--device", "--listen", "--config", "--key", "--record", "--fault-log",
                                       "--log-level", "--port", "--seconds", "--state-rate"}) {
    if (option == known) return true;
  }
  return false;
}

}  // namespace

Expected<ServerOptions> parseServerOptions(std::span<const std::string_view> words) {
  ServerOptions options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    const std::string_view option = words[i].substr(0, equals);
    if (setSwitch(options, words[i])) continue;
    if (!takesValue(option)) return refuse(words[i], Text("not an option"), Text("an option that --help lists"));
    const bool joined = equals != std::string_view::npos;
    if (!joined && i + 1 == words.size()) return refuse(option, Text("nothing"), Text("a value after the option"));
    const std::string_view value = joined ? words[i].substr(equals + 1) : words[++i];
    HAPTICELL_TRY(setValue(options, option, value));
  }
  return options;
}

std::string_view serverUsage() {
  return R"(usage: hapticell-haptic-server [OPTION]...

Drives a force-feedback stylus, or a simulated one, and serves it to HaptiCell (docs/library/protocol.md).

Options:
  --device NAME      a simulated stylus of config/devices/, or a driver's device, DRIVER or DRIVER:ID, as
                     hapticell-cli devices lists them (default: as configured)
  --listen ADDRESS   where to listen (default: 127.0.0.1, this machine only); another address needs a key
  --port N           TCP port (default: as configured, 4747; 0: any that is free)
  --pair             make a key for this user's haptic server, show its code and end: on the other station,
                     hapticell-cli pair HOST. The key before it is worth nothing any more
  --key FILE         protect the connection with the key of this file, on this machine too (default beyond this
                     machine: the one that --pair made)
  --config FILE      a hapticell.toml to read besides the usual ones
  --record FILE      record the device's session, for --device replay:FILE
  --fault-log DIR    where the two seconds around a fault are written (default: ~/.local/state/hapticell)
  --log-level LEVEL  error, warning, info or debug: how much goes to standard error and to the log file (default: info)
  --state-rate HZ    how often the stylus's state is sent at most (default: 1000)
  --seconds N        end by itself after so long
  --no-real-time     do not ask for real-time priority and locked memory
  --help             show this text and end
  --version          show version, commit, compiler and libraries and end

Prints one line when it listens. SIGUSR1 prints the force loop's figures; SIGINT and SIGTERM end it, force zero first.
)";
}

}  // namespace hapticell::haptic
