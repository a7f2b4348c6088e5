// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// A HID device that the system shows.
struct HidInfo {
  std::string path, name, serial;
  std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;  ///< Usage 0: not told.
};

/// An open HID device: reports in, reports out.
class HidPort {
 public:
  virtual ~HidPort() = default;
  /// One report (its id first) into `to`; waits `wait_ms` at most. Its length, 0 for none, -1 when the device is gone.
  virtual int read(std::span<std::uint8_t> to, int wait_ms) = 0;
  /// False when it could not be sent.
  virtual bool write(std::span<const std::uint8_t> report) = 0;
};

/// What the system has of HID devices; hidapi's, or a test's.
class HidBackend {
 public:
  virtual ~HidBackend() = default;
  virtual std::vector<HidInfo> list() = 0;
  virtual std::unique_ptr<HidPort> open(const std::string& path, Problem& problem) = 0;
  /// The report descriptor of the device file; empty where the system does not show it.
  virtual std::vector<std::uint8_t> descriptor(const std::string&) { return {}; }
};

/// Through hidapi's hidraw back end.
std::unique_ptr<HidBackend> makeHidapi();

}  // namespace hapticell::driver
