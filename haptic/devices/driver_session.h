// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "haptic/devices/command_steps.h"
#include "haptic/devices/device_care.h"

namespace hapticell::haptic {

/// How a driver's device is looked after.
struct DriverSessionOptions {
  std::uint32_t reopen_turns = 500;  ///< Turns between two attempts to find a device again that has gone.
  std::uint32_t garbled_turns = 20;  ///< So many garbled answers on end count as a device that has gone.
  std::function<void(const std::string&)> report{};  ///< Told what happens, in sentences, by the thread of turn().
  std::shared_ptr<DeviceCare> care{};   ///< Told the device's condition; the user's calibration comes from there.
  std::function<std::int64_t()> now{};  ///< A steady clock, ns; empty: the machine's. In virtual time the test's.
};

/// What a turn brought.
struct DriverAnswer {
  driver::Status status = driver::Status::kVanished;  ///< kOk also where nothing was new.
  driver::State state;                                ///< The last measurement.
  std::uint64_t measurements = 0;                     ///< How many there were so far.
  bool takes_force = false;  ///< What is commanded reaches the device; else what it was told is zero.
};

/// One device of a driver over its whole life: opened, read and commanded turn by turn, closed when it fails or
/// vanishes, looked for again, opened again. Calls the driver in the caller's thread, so each call may block.
class DriverSession {
 public:
  /// `id` as the driver's find() tells it; empty: the first that can be used.
  DriverSession(driver::Driver& driver, std::string id, DriverSessionOptions options = {});
  ~DriverSession();  ///< Closes.
  DriverSession(const DriverSession&) = delete;
  DriverSession& operator=(const DriverSession&) = delete;

  /// Opens it now; the problem where that fails.
  driver::Problem open();
  bool isOpen() const { return device_ != nullptr; }
  driver::Device* device() { return device_; }
  /// Of the device that was open last.
  const driver::Capabilities& capabilities() const { return capabilities_; }

  /// Reads, then commands, whether or not anything was read. A command without motors carries no force; neither does
  /// one to a device that is not calibrated, exerts none by its own word, has not measured for kFreshFor, or was not
  /// commanded for so long. What was once not passed on so *stays* zero until a command without motors has come: then
  /// its giver knows, and begins anew from nothing. Two commands that reach the device are never more than a step of
  /// CommandSteps apart.
  const DriverAnswer& turn(const driver::Command& command);
  /// Nobody commands any more: zero from the next turn on, until a command without motors has come.
  void hold() { held_ = true; }
  void close();

 private:
  bool keep(driver::Status status, bool reading);
  bool mayPush(std::int64_t now) const;
  driver::Command allowed(const driver::Command& command);
  std::int64_t now() const;
  void lose(const driver::Problem& problem);
  void tryAgain();
  void askForCalibration();
  void calibrateIfAsked();
  void tellCondition();
  void report(const std::string& sentence);

  driver::Driver& driver_;
  std::string id_;
  DriverSessionOptions options_;
  driver::Device* device_ = nullptr;
  driver::Capabilities capabilities_;
  DriverAnswer answer_;
  driver::CommandSteps steps_;
  std::int64_t measured_ns_ = 0;   // When it measured last,
  std::int64_t commanded_ns_ = 0;  // and when it was commanded last; 0: not yet.
  bool held_ = false;              // Something was not passed on, and its giver does not know yet.
  std::uint32_t garbled_ = 0;
  std::uint32_t turns_without_ = 0;
  bool asked_for_calibration_ = false;
  DeviceCondition condition_, told_;
};

}  // namespace hapticell::haptic
