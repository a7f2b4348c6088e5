// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

/// A stylus that does as the test says: where it is, what it answers, whether it answers at all. Its members may be set
/// while nobody calls it, or under `mutex`.
class ScriptedDevice final : public Device {
 public:
  ScriptedDevice() {
    copyText(about.name, "Scripted stylus");
    about.measured_axes = 6;
    about.driven_axes = 3;
    about.buttons = 2;
    about.peak_force = 6.0;
    about.continuous_force = 1.5;
    about.stiffness = 800.0;
    about.damping = 2.0;
    about.rate_hz = 1000.0;
    for (int i = 0; i < 3; ++i) about.workspace_min[i] = -0.08, about.workspace_max[i] = 0.08;
    state.flags = kCalibrated;
  }

  const Capabilities& capabilities() const noexcept override { return about; }
  Status read(State& to) noexcept override {
    std::unique_lock lock(mutex);
    ++reads;
    changed.notify_all();
    changed.wait(lock, [this] { return !blocked; });
    if (answer == Status::kOk) to = state;
    return answer;
  }
  Status write(const Command& command) noexcept override {
    const std::scoped_lock lock(mutex);
    commands.push_back(command);
    return Status::kOk;
  }
  const Problem& problem() const noexcept override { return last_problem; }
  const char* calibrationText(std::uint32_t step) const noexcept override {
    return step < steps.size() ? steps[step].c_str() : nullptr;
  }
  Status calibrate(std::uint32_t step) noexcept override {
    const std::scoped_lock lock(mutex);
    calibrated_steps.push_back(step);
    if (refuses_step == static_cast<int>(step))
      return refuse(last_problem, Status::kFault, "it stood in the wrong place", "Try again.");
    if (step + 1 == steps.size()) state.flags |= kCalibrated;
    return Status::kOk;
  }

  void fail(Status status, const char* found) {
    const std::scoped_lock lock(mutex);
    answer = status;
    refuse(last_problem, status, found, "Plug it in again.");
  }

  Capabilities about;
  State state;
  Status answer = Status::kOk;
  Problem last_problem;
  std::vector<Command> commands;
  std::vector<std::string> steps;  ///< Of its calibration.
  std::vector<std::uint32_t> calibrated_steps;
  int refuses_step = -1;
  std::mutex mutex;
  std::condition_variable changed;
  bool blocked = false;
  int reads = 0;
};

class ScriptedDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return about; }
  std::uint32_t find(Found*, std::uint32_t, Problem&) noexcept override { return 0; }
  Device* open(const char*, Problem& problem) noexcept override {
    ++opened;
    if (refuses.status != Status::kOk) {
      problem = refuses;
      return nullptr;
    }
    device.answer = Status::kOk;
    return &device;
  }
  void close(Device*) noexcept override { ++closed; }
  std::uint64_t presence() noexcept override { return seen; }

  Information about{"scripted", "Scripted", "1", "", ""};
  ScriptedDevice device;
  Problem refuses;
  int opened = 0, closed = 0;
  std::uint64_t seen = 0;  ///< Told as its presence.
};

}  // namespace hapticell::driver
