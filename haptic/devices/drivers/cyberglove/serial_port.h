// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// A serial port at 115200 baud, 8 bits, no parity, one stop bit, no flow control, locked against other programs. Modem
/// lines are not changed, because a pseudo-terminal has none.
class SerialPort {
 public:
  /// Null and a problem: not there, no permission, in use (by a lock or by TIOCEXCL), not a serial port.
  static std::unique_ptr<SerialPort> open(const std::string& path, Problem& problem);
  ~SerialPort();
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// Reads the bytes that have arrived, waiting at most `wait_ms`. Returns their number, or -1 if the port no longer
  /// exists.
  int read(std::span<std::uint8_t> to, int wait_ms);
  /// False if the port no longer exists or accepts nothing within 50 ms.
  bool write(std::span<const std::uint8_t> bytes);

 private:
  explicit SerialPort(int file) : file_(file) {}
  int file_;
};

}  // namespace hapticell::driver
