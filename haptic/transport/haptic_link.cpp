// SPDX-License-Identifier: Apache-2.0
#include "haptic/transport/haptic_link.h"

namespace hapticell::haptic {

std::string_view toString(LinkState state) {
  switch (state) {
    case LinkState::kDisconnected:
      return "disconnected";
    case LinkState::kConnecting:
      return "connecting";
    case LinkState::kConnected:
      return "connected";
    case LinkState::kRefused:
      return "refused";
  }
  return "unknown";
}

}  // namespace hapticell::haptic
