// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <vector>

#include "haptic/devices/drivers/falcon/falcon_arm.h"
#include "haptic/devices/drivers/falcon/falcon_packets.h"
#include "haptic/devices/drivers/falcon/ftdi_port.h"

namespace hapticell::driver {

/// A Falcon in the hands of a test: its boot loader, its firmware and its linkage.
struct FakeFalcon {
  std::vector<std::uint8_t> wanted_firmware;  ///< It runs once it has got this.
  bool running = false;                       ///< The firmware runs.
  bool homed = false;
  dvec3 p_F = FalconArm::middle();
  std::uint8_t buttons = 0;
  int echo_errors = 0;      ///< So many blocks are echoed wrongly.
  bool drops_echo = false;  ///< Echoes come short.
  bool gone = false;
  int garbage = 0;        ///< So many answers are garbage.
  int short_packets = 0;  ///< So many answers lack two bytes.
  bool silent = false;

  FalconPacket last_out;  ///< What the host sent.
  int packets = 0, uploads = 0;
  std::vector<std::uint8_t> received;
  std::vector<std::pair<int, int>> controls;
  std::deque<std::uint8_t> out;
  int baud = 0;
};

class FakeFalconPort final : public FtdiPort {
 public:
  explicit FakeFalconPort(FakeFalcon& falcon) : falcon_(falcon) {}

  bool control(std::uint8_t request, std::uint16_t value) override {
    falcon_.controls.emplace_back(request, value);
    if (request == 3) falcon_.baud = value;
    if (request == 0) falcon_.out.clear();
    return !falcon_.gone;
  }
  int read(std::span<std::uint8_t> to, int) override {
    if (falcon_.gone) return -1;
    std::size_t count = 0;
    for (; count < to.size() && !falcon_.out.empty(); ++count) {
      to[count] = falcon_.out.front();
      falcon_.out.pop_front();
    }
    return static_cast<int>(count);
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    if (falcon_.gone) return false;
    if (falcon_.running)
      answer(bytes);
    else
      boot(bytes);
    return true;
  }

 private:
  void say(std::initializer_list<std::uint8_t> bytes) { falcon_.out.insert(falcon_.out.end(), bytes); }

  void boot(std::span<const std::uint8_t> bytes) {
    if (falcon_.baud == 0x4138 && bytes.size() == 3 && bytes[0] == 0x0A) {
      say({0x0A, 0x44, 0x2C, 0x0D});
    } else if (falcon_.baud == 0x15 && bytes.size() == 1 && bytes[0] == 0x41) {
      ++falcon_.uploads;
      falcon_.received.clear();
      say({0x41});
    } else if (falcon_.baud == 0x15) {
      falcon_.received.insert(falcon_.received.end(), bytes.begin(), bytes.end());
      std::vector<std::uint8_t> echo(bytes.begin(), bytes.end());
      if (falcon_.echo_errors > 0) --falcon_.echo_errors, echo[echo.size() / 2] ^= 1;
      if (falcon_.drops_echo) echo.pop_back();
      falcon_.out.insert(falcon_.out.end(), echo.begin(), echo.end());
      if (falcon_.received == falcon_.wanted_firmware) falcon_.running = true;
    }
  }

  void answer(std::span<const std::uint8_t> bytes) {
    FalconReader reader;
    const auto packet = reader.take(bytes);
    if (!packet) return;
    ++falcon_.packets;
    falcon_.last_out = *packet;
    if (falcon_.silent) return;
    FalconPacket in;
    if (const auto angles = FalconArm::angles(falcon_.p_F)) {
      for (int i = 0; i < 3; ++i) {
        in.values[static_cast<std::size_t>(i)] =
            static_cast<std::int16_t>(std::lround(FalconArm::countOf((*angles)[i])));
      }
    }
    in.bits = static_cast<std::uint8_t>(falcon_.buttons | (falcon_.homed ? kFalconHomed : 0));
    auto reply = encodeFalcon(in);
    if (falcon_.garbage > 0) --falcon_.garbage, reply[5] = 0xFF;
    std::size_t length = reply.size();
    if (falcon_.short_packets > 0) {
      --falcon_.short_packets;
      length -= 2;
      reply[length - 1] = '>';
    }
    falcon_.out.insert(falcon_.out.end(), reply.begin(), reply.begin() + static_cast<std::ptrdiff_t>(length));
  }

  FakeFalcon& falcon_;
};

}  // namespace hapticell::driver
