// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <deque>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/spacemouse/hid_port.h"

namespace hapticell::driver {

/// HID devices in the hands of a test.
struct ScriptedHid {
  using Report = std::vector<std::uint8_t>;
  std::vector<HidInfo> devices;
  std::deque<Report> reports;  ///< That read() gives out.
  std::vector<Report> written;
  bool gone = false;
  Problem refuses;
  Report descriptor;  ///< Of every device.
};

class ScriptedHidPort final : public HidPort {
 public:
  explicit ScriptedHidPort(ScriptedHid& script) : script_(script) {}
  int read(std::span<std::uint8_t> to, int) override {
    if (script_.gone) return -1;
    if (script_.reports.empty()) return 0;
    const ScriptedHid::Report report = script_.reports.front();
    script_.reports.pop_front();
    const std::size_t length = std::min(report.size(), to.size());
    std::copy_n(report.begin(), length, to.begin());
    return static_cast<int>(length);
  }
  bool write(std::span<const std::uint8_t> report) override {
    script_.written.emplace_back(report.begin(), report.end());
    return !script_.gone;
  }

 private:
  ScriptedHid& script_;
};

class ScriptedHidBackend final : public HidBackend {
 public:
  explicit ScriptedHidBackend(ScriptedHid& script) : script_(script) {}
  std::vector<HidInfo> list() override { return script_.devices; }
  std::unique_ptr<HidPort> open(const std::string&, Problem& problem) override {
    problem = script_.refuses;
    if (problem.status != Status::kOk) return nullptr;
    return std::make_unique<ScriptedHidPort>(script_);
  }
  std::vector<std::uint8_t> descriptor(const std::string&) override { return script_.descriptor; }

 private:
  ScriptedHid& script_;
};

}  // namespace hapticell::driver
