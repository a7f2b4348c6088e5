// SPDX-License-Identifier: Apache-2.0
#include <hidapi.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "haptic/devices/device_node.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/spacemouse/hid_port.h"

namespace hapticell::driver {

namespace {

std::string narrow(const wchar_t* text) {
  std::string result;
  for (; text != nullptr && *text != L'\0'; ++text) result += *text < 128 ? static_cast<char>(*text) : '?';
  return result;
}

class HidapiPort final : public HidPort {
 public:
  explicit HidapiPort(hid_device* device) : device_(device) {}
  ~HidapiPort() override { hid_close(device_); }
  int read(std::span<std::uint8_t> to, int wait_ms) override {
    return hid_read_timeout(device_, to.data(), to.size(), wait_ms);
  }
  bool write(std::span<const std::uint8_t> report) override {
    return hid_write(device_, report.data(), report.size()) >= 0;
  }

 private:
  hid_device* device_;
};

class Hidapi final : public HidBackend {
 public:
  Hidapi() { hid_init(); }

  std::vector<HidInfo> list() override {
    std::vector<HidInfo> result;
    hid_device_info* const first = hid_enumerate(0, 0);
    for (const hid_device_info* info = first; info != nullptr; info = info->next) {
      if (info->path == nullptr) continue;  // Gone while it was looked at.
      result.push_back({info->path, narrow(info->product_string), narrow(info->serial_number), info->vendor_id,
                        info->product_id, info->usage_page, info->usage});
    }
    hid_free_enumeration(first);
    return result;
  }

  std::unique_ptr<HidPort> open(const std::string& path, Problem& problem) override {
    if (hid_device* const device = hid_open_path(path.c_str())) return std::make_unique<HidapiPort>(device);
    problem = nodeProblem(path);
    if (problem.status == Status::kOk)
      refuse(problem, Status::kFault, path + " cannot be opened: " + narrow(hid_error(nullptr)));
    return nullptr;
  }

  /// As Linux shows it to everybody; hidapi tells it from 0.14 on only.
  std::vector<std::uint8_t> descriptor(const std::string& path) override {
    const std::filesystem::path node(path);
    std::ifstream file("/sys/class/hidraw" / node.filename() / "device" / "report_descriptor", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
};

}  // namespace

std::unique_ptr<HidBackend> makeHidapi() {
  return std::make_unique<Hidapi>();
}

}  // namespace hapticell::driver
