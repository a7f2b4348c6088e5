// SPDX-License-Identifier: Apache-2.0
// A force loop with a device of one's own: a weight on a stylus sinks onto a floor that only the force loop knows.
// In virtual time; in real time a haptic::RealTimeRunner calls tick() a thousand times a second.
#include <haptic/devices/device.h>
#include <haptic/rendering/constraint_set.h>
#include <haptic/server/clock.h>
#include <haptic/server/force_loop.h>

#include <cstdio>

using hapticell::dvec3;
using hapticell::Pose;
namespace haptic = hapticell::haptic;

namespace {

constexpr double kTick = 0.001;  // s

/// 150 g that hang on the stylus, with some friction. A real device would ask its hardware in read() and write().
class Weight final : public haptic::Device {
 public:
  Weight() {
    capabilities_.name = "a weight";
    capabilities_.peak_force = 8.0;
    capabilities_.continuous_force = 4.0;
    capabilities_.stiffness = 800.0;
    capabilities_.damping = 2.0;
    capabilities_.simulated = true;
  }
  const haptic::DeviceCapabilities& capabilities() const override { return capabilities_; }
  hapticell::Expected<void> open() override { return {}; }
  haptic::DeviceStatus read(haptic::DeviceReading& reading) noexcept override {
    const double acceleration = force_z_ / kMass - 9.81 - 8.0 * velocity_;
    velocity_ = held ? 0.0 : velocity_ + acceleration * kTick;
    z_ += velocity_ * kTick;
    reading.X_DS = Pose::translation({0.0, 0.0, z_});
    return haptic::DeviceStatus::kOk;
  }
  haptic::DeviceStatus write(const dvec3& force_D, const dvec3&) noexcept override {
    force_z_ = force_D.z;
    return haptic::DeviceStatus::kOk;
  }
  void close() noexcept override { force_z_ = 0.0; }

  bool held = true;  ///< By a hand, which lets it fall later.

 private:
  static constexpr double kMass = 0.15;  // kg
  haptic::DeviceCapabilities capabilities_;
  double z_ = 0.03, velocity_ = 0.0, force_z_ = 0.0;
};

}  // namespace

int main() {
  Weight device;
  haptic::VirtualClock clock;
  haptic::ForceLoop loop(device, clock, haptic::optionsFor(device));
  loop.openLink();
  loop.submit(haptic::HapticControl{.forces_enabled = true});

  // Free is what is above z = 0: gap + gradient . xi >= 0 with xi from the reference pose at the origin.
  haptic::ConstraintSet floor;
  floor.zone_radius = 0.1;
  floor.count = 1;
  floor.constraints[0].gradient = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  for (int millisecond = 0; millisecond < 1500; ++millisecond) {
    if (millisecond % 20 == 0) {  // What a client does: it says that it is there, and sends what can be felt.
      loop.heard();
      ++floor.sequence;
      loop.submit(floor);
    }
    device.held = millisecond < 500;  // Until then the forces have been switched on, smoothly.
    clock.advance(haptic::toNanoseconds(kTick));
    loop.tick();
    if (millisecond % 250 == 249) {
      const haptic::HapticState& state = loop.current();
      std::printf("%4d ms: height %6.2f mm, force %5.2f N\n", millisecond + 1, 1e3 * state.X_DS.p.z, state.force_D.z);
    }
  }
  loop.shutDown();
  return 0;
}
