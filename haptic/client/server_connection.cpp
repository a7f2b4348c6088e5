// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/server_connection.h"

#include <pthread.h>

#include <chrono>
#include <exception>
#include <utility>

#include "haptic/client/server_problems.h"

namespace hapticell::haptic {

using std::chrono::steady_clock;

namespace {

/// SCHED_FIFO: below every thread of a haptic server (80, 70, 40), above all that has none. Half and twice (40 shares
/// with the network) hardly matter.
constexpr int kPriority = 20;

std::int64_t nowNanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

steady_clock::duration duration(double seconds) {
  return std::chrono::duration_cast<steady_clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

ServerConnection::ServerConnection(const TcpLinkOptions& options)
    : report(connectingTo(options.host + ":" + std::to_string(options.port))),
      options_(options),
      dialer_(context_, options.host, options.port, options.key.has_value(),
              {.connected = [this](asio::ip::tcp::socket socket) { open(std::move(socket)); },
               .failed = [this](LinkProblem problem) { disconnect(std::move(problem)); }}),
      retry_timer_(context_),
      heartbeat_timer_(context_) {
  if (options_.key) secure_.emplace(SecureStreams::Side::kClient, *options_.key);
  connect();
  beat();
  thread_ = std::thread([this] { run(); });
}

ServerConnection::~ServerConnection() {
  asio::post(context_, [this] { context_.stop(); });
  thread_.join();
  if (stream_) stream_->close();
}

void ServerConnection::calibrate(std::uint32_t step) {
  asio::post(context_, [this, step] {
    if (stream_ && welcomed_) stream_->send(encoder_.encode(Message(Calibrate{step})));
  });
}

void ServerConnection::takeOver() {
  asio::post(context_, [this] {
    take_over_ = true;
    disconnect({Text("Taking the stylus.")});
  });
}

void ServerConnection::run() {
  pthread_setname_np(pthread_self(), "haptic-link");
  // A late heart-beat costs the force. Where it is not granted, the server grants more time.
  sched_param parameter{};
  parameter.sched_priority = kPriority;
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
  while (!context_.stopped()) {
    try {
      context_.run();
    } catch (const std::exception& failure) {
      disconnect({Text("The link to the haptic server failed: %1.", failure.what())});
    }
  }
}

void ServerConnection::connect() {
  report.tryAgain();
  dialer_.dial();
}

void ServerConnection::open(asio::ip::tcp::socket socket) {
  heard_ = nowNanoseconds();
  heartbeat_ = {};
  welcomed_ = wants_forces_ = forces_on_ = false;
  stream_ = std::make_shared<MessageStream>(
      secure_ ? secure_->make(std::move(socket)) : plainStream(std::move(socket)),
      MessageStream::Handlers{
          .message = [this](const Message& message) { hear(message); },
          .garbage = [this](const Error&) { disconnect(strangerAt(server(), secure_.has_value())); },
          .unauthenticated = [this](HandshakeFailure failure,
                                    const Text& why) { disconnect(noHandshakeWith(server(), failure, why)); },
          .closed = [this] { disconnect(closedBy(server(), secure_.has_value(), welcomed_)); }});
  stream_->start();
  stream_->send(encoder_.encode(Message(Hello{.protocol_version = kProtocolVersion,
                                              .kind = options_.kind,
                                              .accept_watching = options_.accept_watching,
                                              .program = options_.program,
                                              .wants_condition = true,
                                              .take_over = std::exchange(take_over_, false)})));
}

void ServerConnection::hear(const Message& message) {
  heard_ = nowNanoseconds();
  if (const auto* welcome = std::get_if<Welcome>(&message)) return hearWelcome(*welcome);
  if (const auto* refusal = std::get_if<Refusal>(&message)) return disconnect(problemOf(*refusal), LinkState::kRefused);
  if (!welcomed_) return;
  if (const auto* state = std::get_if<HapticState>(&message)) hearState(*state);
  if (const auto* figures = std::get_if<ServerStatistics>(&message)) mailboxes.statistics.write(*figures);
  if (const auto* condition = std::get_if<DeviceCondition>(&message)) report.take(*condition);
  if (const auto* beat = std::get_if<Heartbeat>(&message)) heartbeat_.heard(*beat, heard_);
}

void ServerConnection::hearWelcome(const Welcome& welcome) {
  report.take(welcome);
  mailboxes.beginConnection();
  welcomed_ = true;
  report.connect();
  sendHeartbeat();
}

void ServerConnection::hearState(const HapticState& state) {
  mailboxes.presses.hear(state.buttons);
  mailboxes.states.write(state);
  forces_on_ = report.hasStylus() && (wants_forces_ || state.forces_on || state.force_ramp > 0.0);
}

void ServerConnection::disconnect(LinkProblem problem, LinkState state) {
  if (stream_) stream_->close();
  stream_.reset();
  // A refusal stays to be read until an attempt has another outcome.
  report.become(state, std::move(problem));
  retry_timer_.expires_after(duration(take_over_ ? 0.0 : options_.retry_time));
  retry_timer_.async_wait([this](std::error_code cancelled) {
    if (!cancelled) connect();
  });
}

void ServerConnection::sendNewest() {
  wake_pending_ = false;
  if (!stream_ || !welcomed_) return;
  // Controls keep their order before sets: forces are enabled for what follows.
  if (mailboxes.controls.update()) {
    const HapticControl& control = mailboxes.controls.value();
    wants_forces_ = control.forces_enabled;
    forces_on_ = forces_on_ || wants_forces_;
    stream_->send(encoder_.encode(Message(control)));
  }
  if (stream_ && mailboxes.targets.update())
    stream_->sendNewest(MessageStream::Slot::kHandTarget, encoder_.encode(Message(mailboxes.targets.value())));
  if (stream_ && mailboxes.sets.update())
    stream_->sendNewest(MessageStream::Slot::kSet, encoder_.encode(mailboxes.sets.value()));
}

void ServerConnection::sendHeartbeat() {
  if (stream_) stream_->send(encoder_.encode(Message(heartbeat_.next(nowNanoseconds()))));
}

void ServerConnection::beat() {
  const double silence =
      dialer_.isDialing() ? dialer_.dialingTime() : 1e-9 * static_cast<double>(nowNanoseconds() - heard_);
  if (stream_ && silence > options_.silence_time) {
    disconnect(silentServer(server()));
  } else if (stream_ && welcomed_) {
    sendHeartbeat();
  } else if (dialer_.isDialing() && silence > 4.0 * options_.silence_time) {
    dialer_.giveUp();
  }
  heartbeat_timer_.expires_after(duration(forces_on_ ? kQuickHeartbeatPeriod : kHeartbeatPeriod));
  heartbeat_timer_.async_wait([this](std::error_code cancelled) {
    if (!cancelled) beat();
  });
}

}  // namespace hapticell::haptic
