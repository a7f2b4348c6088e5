// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// A device that this driver made and ends.
class OwnedMouse : public Device {
 public:
  virtual ~OwnedMouse() = default;
};

/// What spacenavd tells: a motion or a key.
struct SpacenavEvent {
  bool motion = false;
  int axes[6] = {};  ///< Counts, about 500 at full deflection: right, up, away; turning about the same.
  int button = 0;
  bool pressed = false;
};

/// A connection to spacenavd.
class SpacenavPort {
 public:
  virtual ~SpacenavPort() = default;
  /// Waits `wait_ms` at most. 1: `event` is filled; 0: nothing; -1: the daemon is gone.
  virtual int next(SpacenavEvent& event, int wait_ms) = 0;
  virtual std::string deviceName() = 0;  ///< Empty where it has none, or does not tell.
  virtual std::uint32_t buttons() = 0;
};

/// The daemon on this machine; libspnav's, or a test's.
class SpacenavBackend {
 public:
  virtual ~SpacenavBackend() = default;
  virtual bool isRunning() = 0;     ///< It answers. To ask is to be its client for a moment.
  virtual std::string trace() = 0;  ///< Of its socket's file: another one when the daemon came, went or came anew.
  virtual std::string place() = 0;  ///< Its socket.
  virtual std::string deviceName() = 0;
  virtual std::unique_ptr<SpacenavPort> open(Problem& problem) = 0;
};

/// By libspnav, whose own rule says where the socket is: SPNAV_SOCKET, /etc/spnavrc, /var/run/spnav.sock. Null where
/// the program was built without it.
std::unique_ptr<SpacenavBackend> makeSpacenav();

/// A 3-D mouse that spacenavd reads. Its dead zone, sensitivity and axis settings have been applied. It says each
/// change once, so a deflection stands until the next event.
class SpacenavDevice final : public OwnedMouse {
 public:
  explicit SpacenavDevice(std::unique_ptr<SpacenavPort> port);
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command&) noexcept override { return Status::kOk; }  ///< Its light is the daemon's.
  const Problem& problem() const noexcept override { return problem_; }

 private:
  void take(const SpacenavEvent& event);

  std::unique_ptr<SpacenavPort> port_;
  Capabilities capabilities_;
  State state_;
  Problem problem_;
};

}  // namespace hapticell::driver
