// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/server_address.h"

#include <charconv>

namespace hapticell::haptic {

Expected<ServerAddress> parseServerAddress(const std::string& text, std::string_view option, std::uint16_t usual_port) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos && usual_port != 0 && !text.empty()) return ServerAddress{text, usual_port};
  std::uint16_t port = 0;
  if (colon != std::string::npos) {
    const char* const end = text.data() + text.size();
    const auto [rest, failed] = std::from_chars(text.data() + colon + 1, end, port);
    if (failed != std::errc() || rest != end) port = 0;
  }
  if (colon == 0 || port == 0) {
    return makeError(
        {.place = std::string(option), .found = "'" + text + "'", .expected = "HOST:PORT with a port from 1 to 65535"});
  }
  return ServerAddress{text.substr(0, colon), port};
}

}  // namespace hapticell::haptic
