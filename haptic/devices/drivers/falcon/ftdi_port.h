// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "haptic/devices/driver_interface.h"
#include "haptic/devices/usb_scan.h"

namespace hapticell::driver {

/// The serial chip in a Falcon: bytes in and out, and control requests.
class FtdiPort {
 public:
  virtual ~FtdiPort() = default;
  /// A vendor request without data; false if it was not accepted.
  virtual bool control(std::uint8_t request, std::uint16_t value) = 0;
  /// Reads the bytes that have arrived (without modem status), waiting at most `wait_ms`; 0 if none, -1 if the device
  /// is gone.
  virtual int read(std::span<std::uint8_t> to, int wait_ms) = 0;
  virtual bool write(std::span<const std::uint8_t> bytes) = 0;
};

/// Opens the Falcon that the system shows as `device`, through libusb.
std::unique_ptr<FtdiPort> openFalconPort(const UsbDevice& device, Problem& problem);

/// The version of libusb in use.
const char* libusbVersion();

}  // namespace hapticell::driver
