// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "haptic/devices/command_steps.h"
#include "haptic/devices/device_care.h"

namespace hapticell::haptic {

/// Options of a DriverSession.
struct DriverSessionOptions {
  std::uint32_t reopen_turns = 500;  ///< Turns between two attempts to find a lost device again.
  std::uint32_t garbled_turns = 20;  ///< After this many consecutive garbled answers the device counts as lost.
  std::function<void(const std::string&)> report{};  ///< Gets sentences about events, in the thread of turn().
  std::shared_ptr<DeviceCare> care{};   ///< Gets the device's condition and gives the user's calibration steps.
  std::function<std::int64_t()> now{};  ///< A steady clock, ns; empty: the machine's. In virtual time, the test's
                                        ///< clock.
};

/// The result of a turn.
struct DriverAnswer {
  driver::Status status = driver::Status::kVanished;  ///< kOk also if nothing was new.
  driver::State state;                                ///< The last measurement.
  std::uint64_t measurements = 0;                     ///< Number of measurements so far.
  bool takes_force = false;  ///< True if the command reaches the device; else the device got zero.
};

/// Manages one device of a driver: opens it, reads and commands it turn by turn, closes it when it fails or vanishes,
/// looks for it and opens it again. Calls the driver in the caller's thread, so each call may block.
class DriverSession {
 public:
  /// `id` as returned by the driver's find(); empty: the first that can be used.
  DriverSession(driver::Driver& driver, std::string id, DriverSessionOptions options = {});
  ~DriverSession();  ///< Closes.
  DriverSession(const DriverSession&) = delete;
  DriverSession& operator=(const DriverSession&) = delete;

  /// Opens the device now; returns the problem if that fails.
  driver::Problem open();
  bool isOpen() const { return device_ != nullptr; }
  driver::Device* device() { return device_; }
  /// Capabilities of the device that was opened last.
  const driver::Capabilities& capabilities() const { return capabilities_; }

  /// Reads, then commands, whether or not anything was read. The force is zero if the command has no motors, or if the
  /// device is not calibrated, reports that it exerts no force, or has not measured or been commanded for kFreshFor.
  /// Once a force was suppressed in this way, it stays zero until a command without motors arrives. That shows that the
  /// sender knows and starts again from zero. Two commands to the device never differ by more than a step of
  /// CommandSteps.
  const DriverAnswer& turn(const driver::Command& command);
  /// Call it when commands stop: the force is zero from the next turn until a command without motors arrives.
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
  void sendCondition();
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
  bool held_ = false;              // A force was suppressed, and the sender does not know yet.
  std::uint32_t garbled_ = 0;
  std::uint32_t turns_without_ = 0;
  bool asked_for_calibration_ = false;
  DeviceCondition condition_, told_;
};

}  // namespace hapticell::haptic
