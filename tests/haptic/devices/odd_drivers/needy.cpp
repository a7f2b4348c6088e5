// SPDX-License-Identifier: Apache-2.0
// A stylus without motors that wants to be calibrated in two steps before it says that it is.
#include "haptic/devices/driver_support.h"

namespace {

using namespace hapticell::driver;

class Needy final : public Device {
 public:
  Needy() {
    copyText(capabilities_.name, "Needy stylus");
    capabilities_.measured_axes = 6;
    capabilities_.driven_axes = 3;
    capabilities_.peak_force = 3.0;
    capabilities_.continuous_force = 1.0;
    capabilities_.buttons = 2;
    for (int i = 0; i < 3; ++i) capabilities_.workspace_min[i] = -0.08, capabilities_.workspace_max[i] = 0.08;
  }
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override {
    state.position[2] = 0.01;
    state.flags = (steps_ == 2 ? kCalibrated : 0u) | (steps_ == 1 ? kDocked : 0u);
    return Status::kOk;
  }
  Status write(const Command&) noexcept override { return Status::kOk; }
  const Problem& problem() const noexcept override { return problem_; }
  const char* calibrationText(std::uint32_t step) const noexcept override {
    if (step == 0) return "Put the stylus into its inkwell.";
    return step == 1 ? "Pull it out and hold it in the middle." : nullptr;
  }
  Status calibrate(std::uint32_t step) noexcept override {
    if (step != steps_) return refuse(problem_, Status::kFault, "that step was not its turn", "Begin again.");
    ++steps_;
    return Status::kOk;
  }

 private:
  Capabilities capabilities_;
  Problem problem_;
  std::uint32_t steps_ = 0;
};

class NeedyDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }
  std::uint32_t find(Found* found, std::uint32_t room, Problem&) noexcept override {
    if (room == 0) return 1;
    copyText(found[0].id, "first");
    copyText(found[0].name, "Needy stylus");
    copyText(found[0].place, "imagined");
    return 1;
  }
  Device* open(const char*, Problem&) noexcept override { return &device_; }
  void close(Device*) noexcept override {}

 private:
  Information information_{"needy", "Wants calibration", "1.0", "", ""};
  Needy device_;
};

}  // namespace

HAPTICELL_DRIVER(new NeedyDriver)
