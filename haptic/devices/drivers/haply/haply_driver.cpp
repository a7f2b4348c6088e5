// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/haply/haply_driver.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/usb_scan.h"

namespace hapticell::driver {

namespace {

/// ms to connect when opened; to connect and to answer when searched for; for the first state; for one that serves
/// already. Our choice: a second station is a network away. Half: slow ones are missed; twice: slow to say no.
constexpr int kConnectPatience = 5000, kLookPatience = 500, kFirstPatience = 2000,
              kServedPatience = 200;  // ms.
constexpr double kPeakForce = 2.0;    // N: what Haply's own examples allow.
/// m from the middle: our choice, on no real device. Half: more clutching; twice: its stops may come first.
constexpr double kHalfWorkspace = 0.09;
constexpr const char* kStart = "Start Haply's service (the Haply Hub), or set address in [driver.haply].";

/// The first message that tells of a device, or nothing within the time.
std::optional<std::vector<HaplyReport>> firstReports(WebSocket& socket, int wait_ms) {
  for (int waited = 0; waited < wait_ms && socket.isOpen(); waited += 20) {
    const auto text = socket.read(20);
    const auto reports = text ? readHaplyMessage(*text) : std::nullopt;
    if (reports && !reports->empty()) return reports;
  }
  return std::nullopt;
}

std::optional<dvec3> parseVector(std::string_view text) {
  dvec3 result(0.0);
  for (int i = 0; i < 3; ++i) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result[i]);
    if (error != std::errc() || !std::isfinite(result[i])) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (i < 2 && (text.empty() || text.front() != ',')) return std::nullopt;
    if (i < 2) text.remove_prefix(1);
  }
  return result;
}

}  // namespace

HaplyDevice::HaplyDevice(std::unique_ptr<WebSocket> socket, const HaplyReport& first,
                         const std::optional<dvec3>& middle)
    : socket_(std::move(socket)), device_id_(first.device_id), middle_(middle.value_or(first.cursor)) {
  copyText(capabilities_.name, "Haply Inverse3");
  for (int i = 0; i < 3; ++i) {
    capabilities_.workspace_min[i] = -kHalfWorkspace;
    capabilities_.workspace_max[i] = kHalfWorkspace;
  }
  capabilities_.measured_axes = first.orientation ? 6 : 3;
  capabilities_.driven_axes = 3;
  capabilities_.buttons = 3;
  capabilities_.peak_force = capabilities_.continuous_force = kPeakForce;
  capabilities_.stiffness = 300.0;
  capabilities_.damping = 2.0;
  capabilities_.resolution = 0.05e-3;
  capabilities_.rate_hz = 1000.0;
}

HaplyDevice::~HaplyDevice() {
  socket_->send(haplyForceCommand(device_id_, dvec3(0.0)));
}

Status HaplyDevice::read(State& state) noexcept {
  const auto text = socket_->read(1);
  if (!text) {
    if (socket_->isOpen() && ++empty_reads_ < kPatience) return Status::kNothingNew;
    return refuse(problem_, Status::kVanished, "Haply's service does not answer any more", kStart);
  }
  const auto reports = readHaplyMessage(*text);
  if (!reports)
    return refuse(problem_, Status::kGarbled, "Haply's service sends what is no state", "Update Haply's service.");
  const auto own =
      std::find_if(reports->begin(), reports->end(), [this](const auto& r) { return r.device_id == device_id_; });
  if (own == reports->end()) {
    // A message about something else comes between states; for a while nothing is said of it.
    if (reports->empty() && ++empty_reads_ < kPatience) return Status::kNothingNew;
    return refuse(problem_, Status::kVanished, "the Inverse3 was unplugged", "Plug it in again.");
  }
  empty_reads_ = 0;
  answer_due_ = true;
  const dvec3 p_D = own->cursor - middle_;  // The service's axes are those of D.
  const dquat q = own->orientation.value_or(dquat(1.0, 0.0, 0.0, 0.0));
  for (int i = 0; i < 3; ++i) state.position[i] = p_D[i];
  state.orientation[0] = q.w, state.orientation[1] = q.x, state.orientation[2] = q.y, state.orientation[3] = q.z;
  state.buttons = own->buttons;
  state.flags = kCalibrated;  // The service does that.
  return Status::kOk;
}

Status HaplyDevice::write(const Command& command) noexcept {
  Command wanted = command;
  if (!command.motors) std::fill_n(wanted.force, 3, 0.0);
  // Zero does not wait for a state to answer: none may ever come.
  const double(&sent)[3] = steps_.last().force;
  const bool stops = !command.motors && (sent[0] != 0.0 || sent[1] != 0.0 || sent[2] != 0.0);
  if (!answer_due_ && !stops) return Status::kOk;
  answer_due_ = false;
  const Command now = steps_.next(wanted);
  socket_->send(haplyForceCommand(device_id_, {now.force[0], now.force[1], now.force[2]}));
  return Status::kOk;
}

void HaplyDriver::configure(const char* key, const char* value) noexcept {
  if (std::string_view(key) == "address") address_ = value;
  if (std::string_view(key) == "middle") middle_ = parseVector(value);
}

std::uint32_t HaplyDriver::find(Found* found, std::uint32_t room, Problem& problem) noexcept {
  const auto socket = WebSocket::connect(address_, kLookPatience, problem);
  if (socket == nullptr) {
    copyText(problem.fix, kStart);
    return 0;
  }
  const auto reports = firstReports(*socket, kLookPatience);
  if (!reports) return 0;
  std::uint32_t count = 0;
  for (const HaplyReport& report : *reports) {
    if (count < room) {
      copyText(found[count].id, report.device_id);
      copyText(found[count].name, "Haply Inverse3");
      copyText(found[count].place, address_);
    }
    ++count;
  }
  return count;
}

Device* HaplyDriver::open(const char* id, Problem& problem) noexcept {
  const std::string_view wanted(id);
  const bool is_address = wanted.starts_with("ws://");
  auto socket = WebSocket::connect(is_address ? std::string(wanted) : address_, kConnectPatience, problem);
  if (socket == nullptr) {
    copyText(problem.fix, kStart);
    return nullptr;
  }
  const auto reports = firstReports(*socket, kFirstPatience);
  if (reports) {
    for (const HaplyReport& report : *reports) {
      if (wanted.empty() || is_address || wanted == report.device_id)
        return new HaplyDevice(std::move(socket), report, middle_);
    }
  }
  refuse(problem, Status::kNotFound, "Haply's service answers, but shows no such Inverse3",
         "Plug the Inverse3 in and switch it on.");
  return nullptr;
}

void HaplyDriver::close(Device* device) noexcept {
  delete static_cast<HaplyDevice*>(device);
}

std::uint64_t HaplyDriver::presence() noexcept {
  PresenceNumber number;
  number.add(WebSocket::isServed(address_, kServedPatience) ? 1u : 0u);
  for (const UsbDevice& device : usbDevices()) {
    number.add(device.place);
    number.add(device.serial);
  }
  return number.value();
}

}  // namespace hapticell::driver
