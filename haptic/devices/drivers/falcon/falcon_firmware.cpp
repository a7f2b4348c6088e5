// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/falcon/falcon_firmware.h"

#include <algorithm>
#include <array>
#include <vector>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/falcon/falcon_packets.h"

namespace hapticell::driver {

namespace {

// FTDI's vendor requests.
constexpr std::uint8_t kReset = 0, kModem = 1, kFlow = 2, kBaud = 3, kData = 4, kLatency = 9;
constexpr std::uint16_t kPurgeIn = 1, kPurgeOut = 2;
constexpr std::uint16_t kDtrLow = 0x0100, kDtrHigh = 0x0101, kRtsLow = 0x0200;
constexpr std::uint16_t kSlow = 0x4138, kUpload = 0x15, kFast = 0x2;  // Divisors: 9600, 143 k, 1.5 M baud.
constexpr std::uint16_t kEightBits = 8;
constexpr std::size_t kBlock = 62;
/// Attempts of the whole upload, and greetings of each until the loader answers. Our choice, on no real Falcon. Half:
/// gives up sooner; twice: takes twice as long to say that it failed.
constexpr int kAttempts = 10, kKnocks = 100;
/// ms for an echo: 62 bytes take 4 ms at 143 kbaud. Half: a slow hub fails; twice: failing takes twice as long.
constexpr int kEchoPatience = 50;

struct Request {
  std::uint8_t request;
  std::uint16_t value;
};

bool controlAll(FtdiPort& port, std::initializer_list<Request> requests) {
  return std::all_of(requests.begin(), requests.end(),
                     [&](const Request& r) { return port.control(r.request, r.value); });
}

/// Exactly `count` bytes, or what came until nothing more did.
std::vector<std::uint8_t> receive(FtdiPort& port, std::size_t count) {
  std::vector<std::uint8_t> all;
  std::array<std::uint8_t, 64> bytes{};
  while (all.size() < count) {
    const int got = port.read(bytes, kEchoPatience);
    if (got <= 0) break;
    all.insert(all.end(), bytes.begin(), bytes.begin() + got);
  }
  return all;
}

bool knock(FtdiPort& port) {
  constexpr std::array<std::uint8_t, 3> kHello{0x0A, 0x43, 0x0D};
  constexpr std::array<std::uint8_t, 4> kAnswer{0x0A, 0x44, 0x2C, 0x0D};
  for (int i = 0; i < kKnocks; ++i) {
    if (!port.write(kHello)) return false;
    const std::vector<std::uint8_t> answer = receive(port, kAnswer.size());
    if (std::search(answer.begin(), answer.end(), kAnswer.begin(), kAnswer.end()) != answer.end()) return true;
  }
  return false;
}

bool enterUpload(FtdiPort& port) {
  if (!controlAll(port, {{kLatency, 16},
                         {kBaud, kSlow},
                         {kData, kEightBits},
                         {kFlow, 0},
                         {kReset, kPurgeIn},
                         {kReset, kPurgeOut},
                         {kModem, kRtsLow},
                         {kModem, kDtrLow},
                         {kModem, kDtrHigh}})) {
    return false;
  }
  if (!knock(port)) return false;
  if (!controlAll(port, {{kModem, kDtrLow}, {kBaud, kUpload}, {kReset, kPurgeIn}})) return false;
  constexpr std::array<std::uint8_t, 1> kStart{0x41};
  if (!port.write(kStart)) return false;
  const std::vector<std::uint8_t> answer = receive(port, 1);
  return !answer.empty() && answer.front() == 0x41;
}

bool sendBlocks(FtdiPort& port, std::span<const std::uint8_t> firmware) {
  for (std::size_t at = 0; at < firmware.size(); at += kBlock) {
    const auto block = firmware.subspan(at, std::min(kBlock, firmware.size() - at));
    if (!port.write(block)) return false;
    const std::vector<std::uint8_t> echo = receive(port, block.size());
    if (!std::equal(block.begin(), block.end(), echo.begin(), echo.end())) return false;
  }
  return true;
}

}  // namespace

bool setFalconRunning(FtdiPort& port) {
  return controlAll(port, {{kLatency, 1}, {kBaud, kFast}, {kReset, kPurgeIn}, {kReset, kPurgeOut}});
}

bool falconAnswers(FtdiPort& port) {
  FalconReader reader;
  for (int i = 0; i < 3; ++i) {
    if (!port.write(encodeFalcon({}))) return false;
    if (reader.take(receive(port, kFalconPacketSize))) return true;
  }
  return false;
}

Problem uploadFalconFirmware(FtdiPort& port, std::span<const std::uint8_t> firmware) {
  Problem problem;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (enterUpload(port) && sendBlocks(port, firmware) && setFalconRunning(port) && falconAnswers(port))
      return problem;
  }
  refuse(problem, Status::kGarbled, "the firmware could not be uploaded in ten attempts: its echo was wrong",
         "Switch the Falcon's power off and on, use another USB port, and try again.");
  return problem;
}

}  // namespace hapticell::driver
