// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "haptic/protocol/link_problem.h"
#include "haptic/protocol/messages.h"

namespace hapticell::haptic {

enum class LinkState { kDisconnected, kConnecting, kConnected, kRefused };

/// "disconnected", "connecting", "connected", "refused".
std::string_view toString(LinkState state);

/// The client's end of the connection to a haptic server. No call ever waits; called by the manipulation thread only
/// (linkState() and problem() by any thread). Implementations: over TCP, and in memory under virtual time.
class HapticLink {
 public:
  virtual ~HapticLink() = default;
  virtual LinkState linkState() const = 0;
  virtual LinkProblem problem() const = 0;                      ///< Empty if connected.
  virtual std::optional<DeviceDescription> device() const = 0;  ///< Set once connected.
  /// The newest state since the last call, if any. Its buttons include those that were pressed between the calls,
  /// however briefly.
  virtual std::optional<HapticState> latestState() = 0;
  virtual std::optional<ServerStatistics> latestStatistics() = 0;
  virtual void sendSet(const ConstraintSet& set) = 0;  ///< The newest set wins; older unsent ones are dropped.
  virtual void sendControl(const HapticControl& control) = 0;
  virtual void sendHandTarget(const HandTarget& target) = 0;
};

}  // namespace hapticell::haptic
