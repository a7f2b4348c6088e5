// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/spacemouse/hid_port.h"
#include "haptic/devices/drivers/spacemouse/space_mouse_reports.h"

namespace hapticell::driver {

/// A 3-D mouse. Its light is on while it is open. A deflection that is not repeated for a quarter of a second counts
/// as none: a wireless one's last report may be lost, and a held one repeats itself.
class SpaceMouseDevice final : public Device {
 public:
  SpaceMouseDevice(std::unique_ptr<HidPort> port, const char* name, std::uint32_t buttons);
  ~SpaceMouseDevice();
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }

  /// Empty reads of a millisecond each until a deflection counts as none.
  static constexpr int kPatience = 250;

 private:
  bool setLight(bool on);

  std::unique_ptr<HidPort> port_;
  Capabilities capabilities_;
  SpaceMouseState state_;
  Problem problem_;
  int empty_reads_ = 0;
  bool light_ = false;
};

/// 3Dconnexion's 3-D mice over hidraw.
class SpaceMouseDriver final : public Driver {
 public:
  explicit SpaceMouseDriver(std::unique_ptr<HidBackend> hid) : hid_(std::move(hid)) {}
  const Information& information() const noexcept override { return information_; }
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  /// `id` is the serial number where there is one, else the device file.
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  std::uint64_t presence() noexcept override { return presenceByFind(*this); }

 private:
  std::vector<HidInfo> mice();

  Information information_{"spacemouse", "3Dconnexion SpaceMouse", "1.0", "hidapi (hidraw)",
                           "Tested with recorded layouts, not on a real device."};
  std::unique_ptr<HidBackend> hid_;
};

}  // namespace hapticell::driver
