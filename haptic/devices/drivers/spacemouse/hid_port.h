// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// A HID device that the system lists.
struct HidInfo {
  std::string path, name, serial;
  std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;  ///< Usage 0: unknown.
};

/// An open HID device: reports in, reports out.
class HidPort {
 public:
  virtual ~HidPort() = default;
  /// Reads one report (its id first) into `to`; waits at most `wait_ms`. Returns its length, 0 if none arrived, -1 if
  /// the device is gone.
  virtual int read(std::span<std::uint8_t> to, int wait_ms) = 0;
  /// False if it could not be sent.
  virtual bool write(std::span<const std::uint8_t> report) = 0;
};

/// Access to the system's HID devices: by hidapi, or a test's.
class HidBackend {
 public:
  virtual ~HidBackend() = default;
  virtual std::vector<HidInfo> list() = 0;
  virtual std::unique_ptr<HidPort> open(const std::string& path, Problem& problem) = 0;
  /// The report descriptor of the device file; empty if the system does not provide it.
  virtual std::vector<std::uint8_t> descriptor(const std::string&) { return {}; }
};

/// Access through hidapi's hidraw back end.
std::unique_ptr<HidBackend> makeHidapi();

}  // namespace hapticell::driver
