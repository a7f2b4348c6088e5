// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::cli {

/// Where a haptic server listens.
struct ServerAddress {
  std::string host;
  std::uint16_t port = 0;
};

/// HOST:PORT, the port behind the last colon; HOST alone where `usual_port` is not 0. Errors name `option` as the
/// place.
Expected<ServerAddress> parseServerAddress(const std::string& text, std::string_view option,
                                           std::uint16_t usual_port = 0);

}  // namespace hapticell::cli
