// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/usb_scan.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "geometry/system/plain_text.h"

namespace hapticell::driver {

namespace {

namespace fs = std::filesystem;

std::string line(const fs::path& file) {
  std::ifstream stream(file);
  std::string text;
  std::getline(stream, text);
  return plainText(text);  // A device may call itself anything.
}

int number(const std::string& text, int base) {
  int value = -1;
  std::from_chars(text.data(), text.data() + text.size(), value, base);
  return value;
}

/// Names of the entries of any folder called `kind` below a device's interfaces: tty/ttyACM0, hidraw/hidraw3.
void addNodes(const fs::path& device, std::vector<std::string>& nodes) {
  std::error_code stop;
  auto walk = fs::recursive_directory_iterator(device, fs::directory_options::skip_permission_denied, stop);
  for (; !stop && walk != fs::recursive_directory_iterator(); walk.increment(stop)) {
    if (walk.depth() > 4) walk.disable_recursion_pending();
    const std::string parent = walk->path().parent_path().filename().string();
    const std::string name = walk->path().filename().string();
    const bool port =
        (parent == "tty" && name.starts_with("tty")) || (parent == "hidraw" && name.starts_with("hidraw"));
    if (port) nodes.push_back("/dev/" + name);
  }
  std::sort(nodes.begin(), nodes.end());
}

}  // namespace

std::vector<UsbDevice> usbDevices() {
  std::vector<UsbDevice> devices;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator("/sys/bus/usb/devices", missing)) {
    const int vendor = number(line(entry.path() / "idVendor"), 16);
    const int product = number(line(entry.path() / "idProduct"), 16);
    if (vendor < 0 || product < 0) continue;
    UsbDevice device;
    device.vendor = static_cast<std::uint16_t>(vendor);
    device.product = static_cast<std::uint16_t>(product);
    device.name = line(entry.path() / "product");
    device.serial = line(entry.path() / "serial");
    device.place = "usb " + entry.path().filename().string();
    const int bus = number(line(entry.path() / "busnum"), 10), address = number(line(entry.path() / "devnum"), 10);
    if (bus > 0 && address > 0) {
      char node[40];
      std::snprintf(node, sizeof node, "/dev/bus/usb/%03d/%03d", bus, address);
      device.bus_node = node;
    }
    addNodes(entry.path(), device.nodes);
    devices.push_back(std::move(device));
  }
  std::sort(devices.begin(), devices.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
  return devices;
}

}  // namespace hapticell::driver
