// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>

#include "cli/device/device_commands.h"
#include "cli/device/typed_code.h"
#include "geometry/system/plain_text.h"
#include "haptic/client/server_address.h"
#include "haptic/client/server_watch.h"
#include "haptic/transport/pairing_key.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct PairWords {
  std::string server, code;
  bool unchecked = false;
};

/// Connects as a watcher, which takes the stylus from nobody. The device's name.
Expected<std::string> tryKey(const haptic::ServerAddress& server, const haptic::PairingKey& key) {
  haptic::TcpLinkOptions options;
  options.host = server.host;
  options.port = server.port;
  options.key = key;
  options.kind = haptic::ClientKind::kWatcher;
  options.program = "hapticell-cli pair";
  haptic::TcpLink link(options);
  haptic::waitUntilConnected(link);
  if (const auto device = link.device()) return device->name;
  return makeError({.file = server.host + ":" + std::to_string(server.port),
                    .found = english(link.problem()),
                    .fix = "Nothing was saved. Use --unchecked to save the code without a connection."});
}

ExitStatus pairingFailed(const Error& error) {
  report(error);
  return ExitStatus::kBadInput;
}

ExitStatus run(const PairWords& words, const ResultWriter& writer) {
  const auto server = haptic::parseServerAddress(words.server, "HOST:PORT", haptic::TcpLinkOptions{}.port);
  if (!server) return pairingFailed(server.error());
  if (!words.code.empty() && words.code != "-")
    warn(
        "Every user of this machine can see a code on the command line while the command runs. Leave it out to type "
        "it.");
  const auto code = words.code.empty() || words.code == "-"
                        ? readTypedCode("Pairing code of " + plainText(words.server) + " (not shown as you type): ")
                        : Expected<std::string>(words.code);
  if (!code) return pairingFailed(code.error());
  const auto key = haptic::PairingKey::parse(*code);
  if (!key) return pairingFailed(key.error());
  ordered_json result{{"host", server->host}, {"port", server->port}, {"checked", !words.unchecked}};
  if (!words.unchecked) {
    const auto device = tryKey(*server, *key);
    if (!device) return pairingFailed(device.error());
    result["device"] = *device;
  }
  const auto file = haptic::knownServerKeyFile(server->host, server->port);
  if (const auto saved = haptic::saveKey(*key, file); !saved) return pairingFailed(saved.error());
  result["file"] = file.string();
  const auto written = writer.write(result);
  return written ? ExitStatus::kDone : pairingFailed(written.error());
}

}  // namespace

void addPairCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("pair", "Save the pairing key of a haptic server on another station");
  const auto words = std::make_shared<PairWords>();
  command.option("server", words->server, "HOST or HOST:PORT of the haptic server").required();
  command.option("code", words->code,
                 "Code shown by hapticell-haptic-server --pair there. If left out or '-', it is typed or read from "
                 "standard input");
  command.flag("--unchecked", words->unchecked, "Save it without connecting");
  command.onChosen([&chosen, words] { chosen = [words](ResultWriter& writer) { return run(*words, writer); }; });
}

}  // namespace hapticell::cli
