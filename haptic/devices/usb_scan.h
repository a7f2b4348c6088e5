// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptic/devices/device_node.h"

namespace hapticell::driver {

/// A device on the USB as the kernel tells it, without opening anything.
struct UsbDevice {
  std::uint16_t vendor = 0, product = 0;
  std::string name, serial;
  std::string place;               ///< "usb 1-4".
  std::string bus_node;            ///< "/dev/bus/usb/001/011".
  std::vector<std::string> nodes;  ///< Its serial ports and hidraw files: "/dev/ttyACM0".
};

/// All that /sys/bus/usb/devices shows; empty where there is none.
std::vector<UsbDevice> usbDevices();

}  // namespace hapticell::driver
