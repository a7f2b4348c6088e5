// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptic/devices/drivers/cyberglove/glove_frames.h"
#include "haptic/devices/drivers/cyberglove/serial_port.h"

namespace hapticell::driver {

/// Whether samples are requested one by one or streamed.
enum class GloveMode { kPoll, kStream };

/// Properties of a glove, and how to communicate with it.
struct GloveSetup {
  GloveFormat format;
  GloveMode mode = GloveMode::kStream;
  bool right_hand = true;
  bool touch = false;  ///< CyberTouch: six vibrators.
};

/// A CyberGlove on an open port whose setup is known.
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

  /// Reads of a millisecond without a sample before a new request (ten samples are missing), and failed requests before
  /// the glove counts as lost: after 1.1 s. Half: a hiccup costs a request; twice: it is missed after 2 s.
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
  /// Lists ports, not gloves: only a request shows what is connected to a serial port, and requests can disturb other
  /// devices.
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  /// `id` is the port.
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  /// Uses only the list of ports. Opening a port would reset the connected device.
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

/// Asks the glove for its properties: connected, sensors, hand, options. False and a problem if it does not answer. The
/// setup contains the user's settings and is completed.
bool askGlove(SerialPort& port, GloveSetup& setup, Problem& problem);

}  // namespace hapticell::driver
