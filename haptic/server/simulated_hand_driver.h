// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptic/devices/device.h"
#include "haptic/devices/simulated_device.h"
#include "haptic/server/client_inbox.h"

namespace hapticell::haptic {

/// Advances a simulated device and moves its hand as the client requests; does nothing for other devices.
///
/// Force thread; never allocates, locks or throws.
class SimulatedHandDriver {
 public:
  /// `device` must outlive this.
  explicit SimulatedHandDriver(Device& device) : simulated_(device.simulated()) {}

  void advance(double dt) noexcept {
    if (simulated_ != nullptr) simulated_->advance(dt);
  }

  /// Takes the client's newest target; releases the stylus when the client is gone.
  void follow(ClientInbox& inbox) noexcept {
    if (simulated_ == nullptr) return;
    const bool open = inbox.isOpen();
    if (const HandTarget* target = open ? inbox.takeHandTarget() : nullptr) {
      if (target->holding) {
        simulated_->hand().hold(target->X_DH, target->buttons);
      } else {
        simulated_->hand().release();
      }
      from_client_ = true;
    } else if (from_client_ && !open) {
      simulated_->hand().release();
      from_client_ = false;
    }
  }

 private:
  SimulatedDevice* simulated_;
  bool from_client_ = false;
};

}  // namespace hapticell::haptic
