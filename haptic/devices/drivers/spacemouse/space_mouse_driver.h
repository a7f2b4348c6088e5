// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/spacemouse/hid_port.h"
#include "haptic/devices/drivers/spacemouse/space_mouse_reports.h"
#include "haptic/devices/drivers/spacemouse/spacenav_device.h"

namespace hapticell::driver {

/// A 3D mouse. Its light is on while it is open. If a deflection is not repeated within 0.25 s, it counts as zero: a
/// held mouse repeats its reports, but the last report of a wireless one may be lost.
class SpaceMouseDevice final : public OwnedMouse {
 public:
  /// `model` may be null; `layout` comes from its report descriptor and may be empty.
  SpaceMouseDevice(std::unique_ptr<HidPort> port, const char* name, const SpaceMouseModel* model, HidLayout layout);
  ~SpaceMouseDevice() override;
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }

  /// Empty reads of a millisecond each before a deflection counts as zero: a mouse reports some times a second while
  /// pushed. Half: motion may stutter; twice: a lost report of release drifts for 0.5 s.
  static constexpr int kPatience = 250;

 private:
  bool setLight(bool on);

  std::unique_ptr<HidPort> port_;
  const SpaceMouseModel* model_;
  HidLayout layout_;
  Capabilities capabilities_;
  SpaceMouseState state_;
  Problem problem_;
  int empty_reads_ = 0;
  bool light_ = false;
};

/// 3Dconnexion's 3D mice. If spacenavd runs, the driver uses it, so that other programs can use the mouse at the same
/// time (and spacenavd's settings apply); else it uses hidraw.
class SpaceMouseDriver final : public Driver {
 public:
  /// `daemon` may be null: spacenavd is not used.
  explicit SpaceMouseDriver(std::unique_ptr<HidBackend> hid, std::unique_ptr<SpacenavBackend> daemon = nullptr)
      : hid_(std::move(hid)), daemon_(std::move(daemon)) {}
  const Information& information() const noexcept override { return information_; }
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  /// `id` is the serial number, or the device file if there is no number; kSpacenavId for the mouse of spacenavd.
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  /// Does not connect to the daemon, because each connection makes the mouse's light blink.
  std::uint64_t presence() noexcept override;

  static constexpr const char* kSpacenavId = "spacenavd";

 private:
  std::vector<HidInfo> mice();
  Device* openDirect(std::string_view wanted, Problem& problem);

  Information information_{"spacemouse", "3Dconnexion SpaceMouse", "1.1", "spacenavd, else hidapi (hidraw)",
                           "Tested with recorded layouts, not on a real device."};
  std::unique_ptr<HidBackend> hid_;
  std::unique_ptr<SpacenavBackend> daemon_;
};

}  // namespace hapticell::driver
