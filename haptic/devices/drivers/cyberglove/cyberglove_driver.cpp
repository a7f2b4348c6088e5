// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/cyberglove/cyberglove_driver.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

#include "haptic/devices/device_node.h"
#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

/// ms that a question waits for its answer. Some bytes take 1 ms; the rest is the box. Our choice, on no real glove.
/// Half: a slow box is not found; twice: a search of ports takes twice as long.
constexpr int kAnswerPatience = 200;
/// Tries of a question: a stream that is just ending garbles the first. Our choice. Half: such a glove is not found;
/// twice: other ports are searched twice as long.
constexpr int kAttempts = 3;
/// Ticks between two commands of vibration: 50 Hz, 8 bytes each, 400 of the 11,520 bytes a second. Half: twice that
/// beside the samples; twice: it begins up to 40 ms late.
constexpr int kWritesPerVibration = 20;
constexpr std::string_view kStreamPeriod = "t 1152 1\r";  // 115200 ticks a second: 100 Hz.

bool sendText(SerialPort& port, std::string_view text) {
  return port.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// Throws away what is on its way (a stream that still runs).
void drain(SerialPort& port) {
  std::array<std::uint8_t, 256> bytes{};
  for (int i = 0; i < 50 && port.read(bytes, 2) > 0; ++i) {
  }
}

/// The bytes behind "?X" up to the closing 0x00, at least `least` of them.
std::optional<std::vector<std::uint8_t>> question(SerialPort& port, char what, std::size_t least) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    drain(port);
    if (!sendText(port, std::string{'?', what})) return std::nullopt;
    std::vector<std::uint8_t> answer;
    std::array<std::uint8_t, 64> bytes{};
    for (int waited = 0; waited < kAnswerPatience; waited += 10) {
      const int count = port.read(bytes, 10);
      if (count < 0) return std::nullopt;
      answer.insert(answer.end(), bytes.begin(), bytes.begin() + count);
      const std::array<std::uint8_t, 2> head{'?', static_cast<std::uint8_t>(what)};
      const auto start = std::search(answer.begin(), answer.end(), head.begin(), head.end());
      const auto left = static_cast<std::size_t>(answer.end() - start);
      if (left < 2 + least + 1) continue;
      return std::vector<std::uint8_t>(start + 2, answer.end());
    }
  }
  return std::nullopt;
}

}  // namespace

bool askGlove(SerialPort& port, GloveSetup& setup, Problem& problem) {
  if (setup.format.wide) return true;  // CyberGlove III has no such questions in its wide mode.
  sendText(port, "\x03");              // Ends a stream that an earlier program left running.
  const auto present = question(port, 'G', 1);
  if (!present) {
    refuse(problem, Status::kNotFound, "no glove answers on this port",
           "Switch the glove's box on and check its cable.");
    return false;
  }
  if ((*present)[0] != 3) {
    refuse(problem, Status::kNotFound, "the box answers, but no glove is connected to it",
           "Plug the glove into its box.");
    return false;
  }
  const auto sensors = question(port, 'S', 1);
  if (!sensors || ((*sensors)[0] != 18 && (*sensors)[0] != 22)) {
    refuse(problem, Status::kGarbled, "the glove does not tell 18 or 22 sensors", "Switch its box off and on.");
    return false;
  }
  setup.format.sensors = (*sensors)[0];
  if (const auto hand = question(port, 'R', 1)) setup.right_hand = (*hand)[0] != 0;
  if (const auto options = question(port, 'P', 3)) setup.touch = ((*options)[2] & 2) != 0;
  setup.format.status = sendText(port, "u 1\r");
  drain(port);
  return true;
}

CyberGloveDevice::CyberGloveDevice(std::unique_ptr<SerialPort> port, const GloveSetup& setup)
    : port_(std::move(port)), setup_(setup), frames_(setup.format) {
  capabilities_.kind = Kind::kGlove;
  copyText(capabilities_.name, std::string("CyberGlove, ") + std::to_string(setup.format.sensors) + " sensors, " +
                                   (setup.right_hand ? "right hand" : "left hand"));
  capabilities_.buttons = 1;
  capabilities_.sensors = static_cast<std::uint32_t>(setup.format.sensors);
  capabilities_.vibrators = setup.touch ? 6 : 0;
  capabilities_.rate_hz = 100.0;
  if (setup_.mode == GloveMode::kStream && !setup_.format.wide) sendText(*port_, kStreamPeriod);
  if (setup_.format.wide) sendText(*port_, "1eu\r");
  ask();
}

CyberGloveDevice::~CyberGloveDevice() {
  if (setup_.touch) send({'A', 255, 0, 0, 0, 0, 0, 0});
  if (setup_.mode == GloveMode::kStream) sendText(*port_, "\x03");
}

bool CyberGloveDevice::send(std::initializer_list<std::uint8_t> bytes) {
  return port_->write({bytes.begin(), bytes.size()});
}

bool CyberGloveDevice::ask() {
  if (setup_.format.wide) return sendText(*port_, "1S\r");
  return sendText(*port_, setup_.mode == GloveMode::kStream ? "S" : "G");
}

Status CyberGloveDevice::quiet() noexcept {
  if (++quiet_reads_ < kPatience) return Status::kNothingNew;
  quiet_reads_ = 0;
  if (++asked_ <= kMostAsked) {
    ask();
    return Status::kNothingNew;
  }
  return refuse(problem_, Status::kVanished, "the glove does not answer any more", "Check its cable and its box.");
}

Status CyberGloveDevice::read(State& state) noexcept {
  std::array<std::uint8_t, 512> bytes{};
  const int count = port_->read(bytes, 1);
  if (count < 0) return refuse(problem_, Status::kVanished, "its serial port has gone", "Plug the cable in again.");
  GloveSample sample;
  const bool found = count > 0 && frames_.take(std::span(bytes).first(static_cast<std::size_t>(count)), sample);
  const bool garbled = frames_.garbled() > garbled_;
  garbled_ = frames_.garbled();
  if (!found && garbled)
    return refuse(problem_, Status::kGarbled, "it sends what is no sample", "Switch its box off and on.");
  if (!found) return quiet();
  quiet_reads_ = asked_ = 0;
  if (setup_.mode == GloveMode::kPoll) ask();
  std::copy_n(sample.readings.begin(), sample.count, state.sensors);
  state.buttons = sample.switch_on ? 1 : 0;
  state.flags = kCalibrated;
  return Status::kOk;
}

Status CyberGloveDevice::write(const Command& command) noexcept {
  if (!setup_.touch || ++writes_ < kWritesPerVibration) return Status::kOk;
  std::array<std::uint8_t, 6> wanted{};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(command.vibration[i], 0.0, 1.0)));
  }
  if (wanted == vibration_) return Status::kOk;
  writes_ = 0;
  vibration_ = wanted;
  if (send({'A', 255, wanted[0], wanted[1], wanted[2], wanted[3], wanted[4], wanted[5]})) return Status::kOk;
  return refuse(problem_, Status::kVanished, "its serial port has gone", "Plug the cable in again.");
}

void CyberGloveDriver::configure(const char* key, const char* value) noexcept {
  const std::string_view name(key), text(value);
  if (name == "port") port_ = text;
  if (name == "mode") mode_ = text == "poll" ? GloveMode::kPoll : GloveMode::kStream;
  if (name == "format") wide_ = text == "16";
  if (name == "sensors") sensors_ = text == "18" ? 18 : 22;
}

std::vector<std::string> CyberGloveDriver::ports() const {
  if (!port_.empty()) return {port_};
  std::vector<std::string> found;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", missing)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("ttyUSB")) found.push_back(entry.path().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::uint32_t CyberGloveDriver::find(Found* found, std::uint32_t room, Problem&) noexcept {
  std::uint32_t count = 0;
  for (const std::string& path : ports()) {
    if (count < room) {
      Found& entry = found[count];
      entry.kind = Kind::kGlove;
      copyText(entry.id, path);
      copyText(entry.name, "CyberGlove? at " + (path.starts_with("/dev/") ? path.substr(5) : path));
      copyText(entry.place, path);
      // A look that sends nothing: whether it may be opened and nobody has it.
      if (const auto port = SerialPort::open(path, entry.problem); port != nullptr) entry.problem = {};
    }
    ++count;
  }
  return count;
}

std::uint64_t CyberGloveDriver::presence() noexcept {
  PresenceNumber number;
  for (const std::string& path : ports()) {
    number.add(path);
    number.add(static_cast<std::uint32_t>(nodeProblem(path).status));
  }
  return number.value();
}

Device* CyberGloveDriver::openPort(const std::string& path, Problem& problem) {
  auto port = SerialPort::open(path, problem);
  if (port == nullptr) return nullptr;
  GloveSetup setup;
  setup.mode = mode_;
  setup.format.wide = wide_;
  setup.format.sensors = sensors_;
  if (!askGlove(*port, setup, problem)) return nullptr;
  problem = {};
  return new CyberGloveDevice(std::move(port), setup);
}

Device* CyberGloveDriver::open(const char* id, Problem& problem) noexcept {
  if (*id != '\0') return openPort(id, problem);
  refuse(problem, Status::kNotFound, "there is no serial port",
         "Plug the adapter in, or set port in [driver.cyberglove].");
  for (const std::string& path : ports()) {
    if (Device* const device = openPort(path, problem)) return device;
  }
  return nullptr;
}

void CyberGloveDriver::close(Device* device) noexcept {
  delete static_cast<CyberGloveDevice*>(device);
}

}  // namespace hapticell::driver
