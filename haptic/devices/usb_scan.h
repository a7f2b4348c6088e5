// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptic/devices/device_node.h"

namespace hapticell::driver {

/// A USB device as listed by the kernel; nothing is opened.
struct UsbDevice {
  std::uint16_t vendor = 0, product = 0;
  std::string name, serial;
  std::string place;               ///< "usb 1-4".
  std::string bus_node;            ///< "/dev/bus/usb/001/011".
  std::vector<std::string> nodes;  ///< Its serial ports and hidraw files: "/dev/ttyACM0".
};

/// All devices in /sys/bus/usb/devices; empty if that does not exist.
std::vector<UsbDevice> usbDevices();

}  // namespace hapticell::driver
