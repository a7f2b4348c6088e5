// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::haptic {

/// Address of a haptic server.
struct ServerAddress {
  std::string host;
  std::uint16_t port = 0;
};

/// Reads HOST:PORT, with the port after the last colon; only HOST is allowed if `usual_port` is not 0. Errors name
/// `option`. Any thread.
Expected<ServerAddress> parseServerAddress(const std::string& text, std::string_view option,
                                           std::uint16_t usual_port = 0);

}  // namespace hapticell::haptic
