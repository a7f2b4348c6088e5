// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptic/devices/drivers/cyberglove/glove_frames.h"
#include "haptic/devices/drivers/cyberglove/serial_port.h"

namespace hapticell::driver {

/// How a glove is asked for samples.
enum class GloveMode { kPoll, kStream };

/// What was found out about a glove, and how it is spoken to.
struct GloveSetup {
  GloveFormat format;
  GloveMode mode = GloveMode::kStream;
  bool right_hand = true;
  bool touch = false;  ///< CyberTouch: six vibrators.
};

/// A CyberGlove on an open port that has been asked what it is.
class CyberGloveDevice final : public Device {
 public:
  CyberGloveDevice(std::unique_ptr<SerialPort> port, const GloveSetup& setup);
  ~CyberGloveDevice();
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  /// Raw readings; button 0 is the switch on the wrist.
  Status read(State& state) noexcept override;
  /// Vibration, at most 50 times a second.
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }

  /// Reads of a millisecond each without a sample until it is asked again, and so often in vain until it counts as
  /// gone.
  static constexpr int kPatience = 100, kMostAsked = 10;

 private:
  Status quiet() noexcept;
  bool ask();
  bool send(std::initializer_list<std::uint8_t> bytes);

  std::unique_ptr<SerialPort> port_;
  GloveSetup setup_;
  Capabilities capabilities_;
  GloveFrames frames_;
  Problem problem_;
  std::array<std::uint8_t, 6> vibration_{};
  int quiet_reads_ = 0, asked_ = 0, writes_ = 0;
  std::size_t garbled_ = 0;
};

/// CyberGlove I, II and III on a serial port. Settings: `port` (else all /dev/ttyUSB* and /dev/ttyACM* are shown and
/// the first that answers is opened), `mode` (stream or poll), `format` (8 or 16 bits), `sensors` (for 16 bits; 22).
class CyberGloveDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override;
  /// Ports, not gloves: what hangs on a serial port is known only once it is asked, and others do not like that.
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  /// `id` is the port.
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  /// By the ports alone: none is opened, which would reset what hangs on it.
  std::uint64_t presence() noexcept override;

 private:
  std::vector<std::string> ports() const;
  Device* openPort(const std::string& path, Problem& problem);

  Information information_{"cyberglove", "CyberGlove I, II, III", "1.0", "a serial port",
                           "Tested with recorded layouts, not on a real glove."};
  std::string port_;
  GloveMode mode_ = GloveMode::kStream;
  bool wide_ = false;
  std::size_t sensors_ = 22;
};

/// Asks the glove what it is: connected, sensors, hand, options. Null and a problem where it does not answer. The setup
/// holds what was asked for and is completed.
bool askGlove(SerialPort& port, GloveSetup& setup, Problem& problem);

}  // namespace hapticell::driver
