// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/in_memory_link.h"

#include <algorithm>

#include "geometry/system/assertion.h"

namespace hapticell::haptic {

InMemoryLink::InMemoryLink(ForceLoop& loop, VirtualClock& clock, const DeviceDescription& device,
                           const InMemoryLinkOptions& options)
    : loop_(loop), clock_(clock), device_(device), options_(options), generator_(options.seed) {
  connect();
}

void InMemoryLink::connect() {
  connected_ = true;
  next_heartbeat_ = clock_.now();
  loop_.openLink();
}

void InMemoryLink::disconnect() {
  connected_ = false;
  to_server_.parcels.clear();
  to_client_.parcels.clear();
  newest_state_.reset();
  newest_statistics_.reset();
  loop_.closeLink();
}

void InMemoryLink::step(std::uint32_t skipped) {
  clock_.advance(toNanoseconds(loop_.period() * (1.0 + skipped)));
  sendHeartbeat();
  deliverToServer();
  loop_.tick({.late_ns = 0, .skipped = skipped});
  sendState();
}

void InMemoryLink::send(Pipe& pipe, std::span<const std::uint8_t> frame, bool may_be_lost) {
  // Both are drawn for each message, so that a run with loss has the jitter of the run without.
  const double delay = options_.latency + options_.jitter * random();
  const bool lost = random() < options_.loss;
  if (lost && may_be_lost) return;
  pipe.last_due = std::max(pipe.last_due, clock_.now() + toNanoseconds(delay));
  Parcel& parcel = pipe.parcels.emplace_back();
  parcel.due = pipe.last_due;
  if (!pipe.spare.empty()) {
    parcel.frame = std::move(pipe.spare.back());
    pipe.spare.pop_back();
  }
  parcel.frame.assign(frame.begin(), frame.end());
}

bool InMemoryLink::receive(Pipe& pipe, Message& message) {
  if (pipe.parcels.empty() || pipe.parcels.front().due > clock_.now()) return false;
  Parcel parcel = std::move(pipe.parcels.front());
  pipe.parcels.pop_front();
  const auto decoded = decode(std::span<const std::uint8_t>(parcel.frame).subspan(kFrameHeaderBytes), message);
  HAPTICELL_DEMAND(decoded.has_value());  // Both ends are this program: an invalid message is our own mistake.
  pipe.spare.push_back(std::move(parcel.frame));
  return true;
}

void InMemoryLink::sendToServer(std::span<const std::uint8_t> frame, bool may_be_lost) {
  if (connected_ && !silent_) send(to_server_, frame, may_be_lost);
}

void InMemoryLink::sendHeartbeat() {
  if (clock_.now() < next_heartbeat_) return;
  next_heartbeat_ += toNanoseconds(kHeartbeatPeriod);
  sendToServer(encoder_.encode(Message(Heartbeat{.sent_ns = clock_.now(), .echo_ns = 0, .held_ns = 0})), false);
}

void InMemoryLink::deliverToServer() {
  while (receive(to_server_, at_server_)) {
    loop_.heard();
    if (const auto* set = std::get_if<ConstraintSet>(&at_server_)) loop_.submit(*set);
    if (const auto* control = std::get_if<HapticControl>(&at_server_)) loop_.submit(*control);
    if (const auto* target = std::get_if<HandTarget>(&at_server_)) loop_.submit(*target);
  }
}

void InMemoryLink::sendState() {
  if (!connected_) return;
  if (loop_.updateState()) send(to_client_, encoder_.encode(loop_.state()), true);
  if (!loop_.updateFigures()) return;
  send(to_client_, encoder_.encode(Message(statisticsOf(loop_.figures(), {2.0 * options_.latency, 0.0}))), true);
}

void InMemoryLink::receiveAtClient() {
  while (receive(to_client_, at_client_)) {
    if (const auto* state = std::get_if<HapticState>(&at_client_)) {
      presses_.hear(state->buttons);
      newest_state_ = *state;
    }
    if (const auto* statistics = std::get_if<ServerStatistics>(&at_client_)) newest_statistics_ = *statistics;
  }
}

LinkState InMemoryLink::linkState() const {
  return connected_ ? LinkState::kConnected : LinkState::kDisconnected;
}

LinkProblem InMemoryLink::problem() const {
  return connected_ ? LinkProblem() : LinkProblem{Text("The link in memory is closed.")};
}

std::optional<DeviceDescription> InMemoryLink::device() const {
  return connected_ ? std::optional(device_) : std::nullopt;
}

std::optional<HapticState> InMemoryLink::latestState() {
  receiveAtClient();
  if (newest_state_) newest_state_->buttons = presses_.take(newest_state_->buttons);
  return std::exchange(newest_state_, std::nullopt);
}

std::optional<ServerStatistics> InMemoryLink::latestStatistics() {
  receiveAtClient();
  return std::exchange(newest_statistics_, std::nullopt);
}

void InMemoryLink::sendSet(const ConstraintSet& set) {
  sendToServer(encoder_.encode(set), true);
}

void InMemoryLink::sendControl(const HapticControl& control) {
  sendToServer(encoder_.encode(Message(control)), false);
}

void InMemoryLink::sendHandTarget(const HandTarget& target) {
  sendToServer(encoder_.encode(Message(target)), true);
}

}  // namespace hapticell::haptic
