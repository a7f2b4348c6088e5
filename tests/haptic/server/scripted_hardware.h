// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "haptic/devices/device.h"
#include "haptic/server/clock.h"
#include "haptic/server/force_loop.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {

/// A piece of hardware that says what the test wants it to say.
class ScriptedDevice final : public Device {
 public:
  ScriptedDevice() {
    capabilities_.peak_force = 6.4;
    capabilities_.continuous_force = 1.4;
    capabilities_.stiffness = 1000.0;
    capabilities_.damping = 2.0;
  }
  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  Expected<void> open() override { return {}; }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    reading.X_DS = X_DS;
    return status;
  }
  DeviceStatus write(const dvec3& force_D, const dvec3&) noexcept override {
    force = force_D;
    return DeviceStatus::kOk;
  }
  void setMotors(bool on) noexcept override { motors = on; }
  void close() noexcept override {}

  Pose X_DS = Pose::translation({0, 0, 0.005});
  DeviceStatus status = DeviceStatus::kOk;
  dvec3 force{0.0};
  bool motors = true;

 private:
  DeviceCapabilities capabilities_;
};

struct Hardware {
  Hardware() : loop(device, clock, patientOptionsFor(device)) {
    loop.openLink();
    loop.tick();
    loop.submit(floorSet(1));
    enable(true);
    run(1500);
  }
  void enable(bool on) { loop.submit(HapticControl{.forces_enabled = on}); }
  void run(int ticks, TickTiming timing = {}) {
    for (int i = 0; i < ticks; ++i) {
      clock.advance(1'000'000);
      loop.heard();
      const dvec3 before = device.force;
      loop.tick(timing);
      worst_step = std::max(worst_step, glm::distance(device.force, before));
      worst = std::max(worst, glm::length(device.force));
    }
  }
  /// Two millimetres into the floor, slowly.
  void press() {
    for (int i = 0; i < 700; ++i) {
      device.X_DS.p.z -= 1e-5;
      run(1);
    }
  }

  ScriptedDevice device;
  VirtualClock clock;
  ForceLoop loop;
  double worst_step = 0.0, worst = 0.0;
};

}  // namespace hapticell::haptic
