// SPDX-License-Identifier: Apache-2.0
// A complete driver of a device that does not exist: a stylus that goes round in a circle and feels no force. Copy it
// and put your own device in the place of Orbit. docs/library/drivers.md explains each step.
#include <chrono>
#include <cmath>
#include <cstring>

#include "haptic/devices/driver_interface.h"
#include "haptic/devices/driver_support.h"

namespace {

using namespace hapticell::driver;

class Orbit final : public Device {
 public:
  Orbit() {
    copyText(capabilities_.name, "Orbit");
    capabilities_.measured_axes = 6;
    capabilities_.buttons = 1;
    capabilities_.rate_hz = 1000.0;
    for (int i = 0; i < 3; ++i) {
      capabilities_.workspace_min[i] = -0.08;
      capabilities_.workspace_max[i] = 0.08;
    }
  }

  const Capabilities& capabilities() const noexcept override { return capabilities_; }

  Status read(State& state) noexcept override {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
    state.position[0] = 0.03 * std::cos(time.count());
    state.position[1] = 0.03 * std::sin(time.count());
    state.position[2] = 0.0;
    state.flags = kCalibrated;
    return Status::kOk;
  }

  // A real driver sends the force here. Motors that shall be off carry none.
  Status write(const Command&) noexcept override { return Status::kOk; }

  const Problem& problem() const noexcept override { return problem_; }

 private:
  Capabilities capabilities_;
  Problem problem_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class OrbitDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }

  std::uint32_t find(Found* found, std::uint32_t room, Problem&) noexcept override {
    if (room == 0) return 1;
    copyText(found[0].id, "first");
    copyText(found[0].name, "Orbit");
    copyText(found[0].place, "imagined");
    if (open_) refuse(found[0].problem, Status::kInUse, "it is open already", "Close the other program.");
    return 1;
  }

  Device* open(const char* id, Problem& problem) noexcept override {
    if (*id != '\0' && std::strcmp(id, "first") != 0) {
      refuse(problem, Status::kNotFound, "there is no such device", "Its only device is called first.");
      return nullptr;
    }
    if (open_) {
      refuse(problem, Status::kInUse, "it is open already", "Close the other program.");
      return nullptr;
    }
    open_ = true;
    return &device_;
  }

  void close(Device*) noexcept override { open_ = false; }

 private:
  Information information_{"orbit", "Example of a driver", "1.0", "", "It goes round in a circle and feels no force."};
  Orbit device_;
  bool open_ = false;
};

}  // namespace

HAPTICELL_DRIVER(new OrbitDriver)
