// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "haptic/transport/haptic_link.h"

namespace hapticell::manipulation::test {

/// A link whose stylus stands where the test, or the bench, puts it; the proxy is the stylus.
class HandLink final : public haptic::HapticLink {
 public:
  haptic::LinkState linkState() const override {
    return connected ? haptic::LinkState::kConnected : haptic::LinkState::kDisconnected;
  }
  haptic::LinkProblem problem() const override { return {}; }
  std::optional<haptic::DeviceDescription> device() const override {
    haptic::DeviceDescription description;
    description.workspace_min = dvec3(-0.08);
    description.workspace_max = dvec3(0.08);
    return description;
  }
  std::optional<haptic::HapticState> latestState() override { return connected ? std::optional(state) : std::nullopt; }
  std::optional<haptic::ServerStatistics> latestStatistics() override { return statistics; }
  void sendSet(const haptic::ConstraintSet& sent) override {
    set = sent;
    ++sets;
  }
  void sendControl(const haptic::HapticControl& sent) override { control = sent; }
  void sendHandTarget(const haptic::HandTarget&) override {}

  bool connected = true;
  haptic::HapticState state;
  std::optional<haptic::ServerStatistics> statistics;
  haptic::ConstraintSet set;
  haptic::HapticControl control;
  int sets = 0;  ///< Sent so far.
};

}  // namespace hapticell::manipulation::test
