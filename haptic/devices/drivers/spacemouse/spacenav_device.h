// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// A device that this driver creates and deletes.
class OwnedMouse : public Device {
 public:
  virtual ~OwnedMouse() = default;
};

/// An event of spacenavd: a motion or a key.
struct SpacenavEvent {
  bool motion = false;
  int axes[6] = {};  ///< Counts, about 500 at full deflection: right, up, away; rotation about the same axes.
  int button = 0;
  bool pressed = false;
};

/// A connection to spacenavd.
class SpacenavPort {
 public:
  virtual ~SpacenavPort() = default;
  /// Waits at most `wait_ms`. 1: `event` is filled; 0: no event; -1: the daemon is gone.
  virtual int next(SpacenavEvent& event, int wait_ms) = 0;
  virtual std::string deviceName() = 0;  ///< Empty if unknown.
  virtual std::uint32_t buttons() = 0;
};

/// The daemon on this machine; libspnav's, or a test's.
class SpacenavBackend {
 public:
  virtual ~SpacenavBackend() = default;
  virtual bool isRunning() = 0;     ///< Whether it answers. The check connects as a client for a moment.
  virtual std::string trace() = 0;  ///< Identifies its socket's file; changes when the daemon starts, ends or restarts.
  virtual std::string place() = 0;  ///< Its socket.
  virtual std::string deviceName() = 0;
  virtual std::unique_ptr<SpacenavPort> open(Problem& problem) = 0;
};

/// Access through libspnav, which looks for the socket in SPNAV_SOCKET, /etc/spnavrc, /var/run/spnav.sock. Null if the
/// program was built without libspnav.
std::unique_ptr<SpacenavBackend> makeSpacenav();

/// A 3D mouse that spacenavd reads. Its dead zone, sensitivity and axis settings have been applied. It sends each
/// change once, so a deflection is valid until the next event.
class SpacenavDevice final : public OwnedMouse {
 public:
  explicit SpacenavDevice(std::unique_ptr<SpacenavPort> port);
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command&) noexcept override { return Status::kOk; }  ///< The daemon controls the light.
  const Problem& problem() const noexcept override { return problem_; }

 private:
  void take(const SpacenavEvent& event);

  std::unique_ptr<SpacenavPort> port_;
  Capabilities capabilities_;
  State state_;
  Problem problem_;
};

}  // namespace hapticell::driver
