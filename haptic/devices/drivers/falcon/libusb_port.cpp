// SPDX-License-Identifier: Apache-2.0
#include <libusb.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <vector>

#include "haptic/devices/device_node.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/falcon/ftdi_port.h"

namespace hapticell::driver {

namespace {

constexpr unsigned char kOut = 0x02, kIn = 0x81;
// ms of a control request or a write: a packet takes a millisecond. Half: a busy bus fails; twice: an unplugged Falcon
// holds its thread longer.
constexpr unsigned kPatience = 100;
constexpr int kModemBytes = 2;  // In front of each packet of 64.

class LibusbPort final : public FtdiPort {
 public:
  LibusbPort(libusb_context* context, libusb_device_handle* handle) : context_(context), handle_(handle) {}
  ~LibusbPort() override {
    libusb_release_interface(handle_, 0);
    libusb_close(handle_);
    libusb_exit(context_);
  }

  bool control(std::uint8_t request, std::uint16_t value) override {
    return libusb_control_transfer(handle_, 0x40, request, value, 0, nullptr, 0, kPatience) >= 0;
  }

  int read(std::span<std::uint8_t> to, int wait_ms) override {
    std::array<unsigned char, 64> packet{};
    int length = 0;
    const int result = libusb_bulk_transfer(handle_, kIn, packet.data(), packet.size(), &length,
                                            static_cast<unsigned>(std::max(1, wait_ms)));
    if (result == LIBUSB_ERROR_TIMEOUT && length == 0) return 0;
    if (result != LIBUSB_SUCCESS && result != LIBUSB_ERROR_TIMEOUT) return -1;
    const int count = std::clamp(length - kModemBytes, 0, static_cast<int>(to.size()));
    std::copy_n(packet.begin() + kModemBytes, count, to.begin());
    return count;
  }

  bool write(std::span<const std::uint8_t> bytes) override {
    std::vector<unsigned char> copy(bytes.begin(), bytes.end());
    int sent = 0;
    const int result =
        libusb_bulk_transfer(handle_, kOut, copy.data(), static_cast<int>(copy.size()), &sent, kPatience);
    return result == LIBUSB_SUCCESS && sent == static_cast<int>(copy.size());
  }

 private:
  libusb_context* context_;
  libusb_device_handle* handle_;
};

void tell(Problem& problem, int error, const UsbDevice& device) {
  if (error == LIBUSB_ERROR_ACCESS) {
    problem = nodeProblem(device.bus_node, EACCES);
  } else if (error == LIBUSB_ERROR_BUSY) {
    refuse(problem, Status::kInUse, "another program, or the kernel's ftdi_sio, has it",
           "Close the program that uses it.");
  } else if (error == LIBUSB_ERROR_NO_DEVICE) {
    refuse(problem, Status::kNotFound, "it is not plugged in any more", "Plug it in.");
  } else {
    refuse(problem, Status::kFault, std::string("libusb: ") + libusb_error_name(error));
  }
}

libusb_device_handle* openAt(libusb_context* context, const UsbDevice& wanted, int& error) {
  libusb_device** list = nullptr;
  const auto count = libusb_get_device_list(context, &list);
  libusb_device_handle* handle = nullptr;
  error = LIBUSB_ERROR_NO_DEVICE;
  for (ssize_t i = 0; i < count && handle == nullptr; ++i) {
    char node[40];
    std::snprintf(node, sizeof node, "/dev/bus/usb/%03d/%03d", libusb_get_bus_number(list[i]),
                  libusb_get_device_address(list[i]));
    if (wanted.bus_node == node) error = libusb_open(list[i], &handle);
  }
  if (count >= 0) libusb_free_device_list(list, 1);
  return handle;
}

}  // namespace

std::unique_ptr<FtdiPort> openFalconPort(const UsbDevice& device, Problem& problem) {
  libusb_context* context = nullptr;
  int error = libusb_init(&context);
  if (error != LIBUSB_SUCCESS) {
    tell(problem, error, device);
    return nullptr;
  }
  libusb_device_handle* const handle = openAt(context, device, error);
  if (handle != nullptr) {
    libusb_set_auto_detach_kernel_driver(handle, 1);
    error = libusb_claim_interface(handle, 0);
    if (error == LIBUSB_SUCCESS) return std::make_unique<LibusbPort>(context, handle);
    libusb_close(handle);
  }
  tell(problem, error, device);
  libusb_exit(context);
  return nullptr;
}

const char* libusbVersion() {
  static const std::string text = [] {
    const libusb_version* const version = libusb_get_version();
    return "libusb " + std::to_string(version->major) + "." + std::to_string(version->minor) + "." +
           std::to_string(version->micro);
  }();
  return text.c_str();
}

}  // namespace hapticell::driver
