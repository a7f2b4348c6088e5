// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/tcp_link.h"

#include <pthread.h>

#include <algorithm>
#include <asio/connect.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include "haptic/protocol/heartbeat.h"
#include "haptic/rendering/triple_buffer.h"
#include "haptic/transport/message_stream.h"
#include "haptic/transport/press_latch.h"
#include "haptic/transport/secure_stream.h"

namespace hapticell::haptic {

using asio::ip::tcp;
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

/// The network thread and what it shares with the caller's.
class TcpLink::Connection {
 public:
  explicit Connection(const TcpLinkOptions& options)
      : options_(options), resolver_(context_), retry_timer_(context_), heartbeat_timer_(context_), socket_(context_) {
    if (options_.key) secure_.emplace(SecureStreams::Side::kClient, *options_.key);
    problem_ = {Text("Connecting to the haptic server at %1.", server())};
    connect();
    beat();
    thread_ = std::thread([this] { run(); });
  }

  ~Connection() {
    asio::post(context_, [this] { context_.stop(); });
    thread_.join();
    if (stream_) stream_->close();
  }

  // Caller's side.

  template <typename T>
  void submit(TripleBuffer<T>& outbox, const T& value) {
    if (state() != LinkState::kConnected || !controls_stylus_) return;
    outbox.write(value);
    if (!wake_pending_.exchange(true)) asio::post(context_, [this] { sendNewest(); });
  }

  template <typename T>
  static std::optional<T> newest(TripleBuffer<T>& inbox) {
    return inbox.update() ? std::optional<T>(inbox.value()) : std::nullopt;
  }

  LinkState state() const { return state_.load(std::memory_order_acquire); }

  LinkProblem problem() const {
    const std::scoped_lock lock(mutex_);
    return state() == LinkState::kConnected ? LinkProblem() : problem_;
  }

  std::optional<DeviceDescription> device() const {
    const std::scoped_lock lock(mutex_);
    return state() == LinkState::kConnected ? std::optional(welcome_.device) : std::nullopt;
  }

  std::optional<DeviceCondition> condition() const {
    const std::scoped_lock lock(mutex_);
    return state() == LinkState::kConnected ? condition_ : std::nullopt;
  }

  void calibrate(std::uint32_t step) {
    asio::post(context_, [this, step] {
      if (stream_ && welcomed_) stream_->send(encoder_.encode(Message(Calibrate{step})));
    });
  }

  void takeOver() {
    asio::post(context_, [this] {
      take_over_ = true;
      disconnect({Text("Taking the stylus.")});
    });
  }

  bool hasStylus() const { return controls_stylus_; }

  ClientKind grantedKind() const {
    const std::scoped_lock lock(mutex_);
    return welcome_.kind;
  }

  TripleBuffer<HapticState> states;
  PressLatch presses;
  TripleBuffer<ServerStatistics> statistics;
  TripleBuffer<ConstraintSet> sets;
  TripleBuffer<HapticControl> controls;
  TripleBuffer<HandTarget> targets;
  std::atomic<std::uint64_t> connections{0};

 private:
  std::string server() const { return options_.host + ":" + std::to_string(options_.port); }

  void run() {
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

  void become(LinkState state, LinkProblem problem) {
    const std::scoped_lock lock(mutex_);
    problem_ = std::move(problem);
    state_.store(state, std::memory_order_release);
  }

  void connect() {
    if (state() == LinkState::kDisconnected) state_ = LinkState::kConnecting;
    attempt_began_ = nowNanoseconds();
    connecting_ = true;
    resolver_.async_resolve(options_.host, std::to_string(options_.port),
                            [this](std::error_code failed, const tcp::resolver::results_type& endpoints) {
                              if (failed) return failAttempt();
                              tryEndpoints(endpoints);
                            });
  }

  void tryEndpoints(const tcp::resolver::results_type& endpoints) {
    const bool leaves = std::any_of(endpoints.begin(), endpoints.end(),
                                    [](const auto& entry) { return !entry.endpoint().address().is_loopback(); });
    if (leaves && !options_.key) {
      connecting_ = false;
      return disconnect({Text("This station has no key for the haptic server at %1.", server()),
                   Text("Show one there with hapticell-haptic-server --pair, and type it here: hapticell-cli pair %1.",
                        server())});
    }
    socket_ = tcp::socket(context_);
    asio::async_connect(socket_, endpoints, [this](std::error_code failed, const tcp::endpoint&) {
      if (failed) return failAttempt();
      connecting_ = false;
      open();
    });
  }

  void failAttempt() {
    connecting_ = false;
    disconnect({Text("No haptic server answers at %1.", server()), Text("Start hapticell-haptic-server.")});
  }

  void open() {
    heard_ = nowNanoseconds();
    heartbeat_ = {};
    welcomed_ = wants_forces_ = forces_on_ = false;
    stream_ = std::make_shared<MessageStream>(
        secure_ ? secure_->make(std::move(socket_)) : plainStream(std::move(socket_)),
        MessageStream::Handlers{
            .message = [this](const Message& message) { hear(message); },
            .garbage = [this](const Error&) { disconnect(otherProgram()); },
            .unauthenticated = [this](HandshakeFailure failure, const Text& why) { disconnect(noHandshake(failure, why)); },
            .closed = [this] { disconnect(closedByServer()); }});
    stream_->start();
    stream_->send(encoder_.encode(Message(Hello{.protocol_version = kProtocolVersion,
                                                .kind = options_.kind,
                                                .accept_watching = options_.accept_watching,
                                                .program = options_.program,
                                                .wants_condition = true,
                                                .take_over = std::exchange(take_over_, false)})));
  }

  /// What helps differs: only another key wants new pairing.
  LinkProblem noHandshake(HandshakeFailure failure, const Text& why) const {
    if (failure == HandshakeFailure::kEnded)
      return {Text("The haptic server at %1 is there, but %2: it may be busy with many connections.", server(), why),
              Text("HaptiCell tries again by itself; the key that is kept stays good.")};
    const Text what("The haptic server at %1 and this station do not have the same key: %2.", server(), why);
    if (failure == HandshakeFailure::kOtherSpeech)
      return {what, Text("Start the server with its key (hapticell-haptic-server --listen ADDRESS), or see what else "
                         "answers there.")};
    return {what, Text("Pair them again: hapticell-haptic-server --pair there, hapticell-cli pair here.")};
  }

  LinkProblem closedByServer() const {
    if (welcomed_ || secure_) return {Text("The haptic server at %1 closed the connection.", server())};
    return {
        Text("The haptic server at %1 closed the connection at once: it may be one that wants a key "
             "(hapticell-cli pair), or busy with many connections.",
             server())};
  }

  LinkProblem otherProgram() const {
    if (secure_) return {Text("What answers at %1 is not a haptic server of this release.", server())};
    return {
        Text("What answers at %1 is not a haptic server of this release, or one that wants a key "
             "(hapticell-cli pair).",
             server())};
  }

  void hear(const Message& message) {
    heard_ = nowNanoseconds();
    if (const auto* welcome = std::get_if<Welcome>(&message)) return hearWelcome(*welcome);
    if (const auto* refusal = std::get_if<Refusal>(&message)) return disconnect(problemOf(*refusal), LinkState::kRefused);
    if (!welcomed_) return;
    if (const auto* state = std::get_if<HapticState>(&message)) {
      presses.hear(state->buttons);
      states.write(*state);
      forces_on_ = controls_stylus_ && (wants_forces_ || state->forces_on || state->force_ramp > 0.0);
    }
    if (const auto* figures = std::get_if<ServerStatistics>(&message)) statistics.write(*figures);
    if (const auto* condition = std::get_if<DeviceCondition>(&message)) {
      const std::scoped_lock lock(mutex_);
      condition_ = *condition;
    }
    if (const auto* beat = std::get_if<Heartbeat>(&message)) heartbeat_.heard(*beat, heard_);
  }

  void hearWelcome(const Welcome& welcome) {
    {
      const std::scoped_lock lock(mutex_);
      welcome_ = welcome;
      condition_.reset();
    }
    // What an earlier connection left unsent is not for this one.
    sets.update();
    controls.update();
    targets.update();
    presses.forget();
    controls_stylus_ = welcome.kind == ClientKind::kController;
    welcomed_ = true;
    ++connections;
    become(LinkState::kConnected, {});
    sendHeartbeat();
  }

  void disconnect(LinkProblem problem, LinkState state = LinkState::kDisconnected) {
    if (stream_) stream_->close();
    stream_.reset();
    // A refusal stays to be read until an attempt has another outcome.
    become(state, std::move(problem));
    retry_timer_.expires_after(duration(take_over_ ? 0.0 : options_.retry_time));
    retry_timer_.async_wait([this](std::error_code cancelled) {
      if (!cancelled) connect();
    });
  }

  void sendNewest() {
    wake_pending_ = false;
    if (!stream_ || !welcomed_) return;
    // Controls keep their order before sets: forces are enabled for what follows.
    if (controls.update()) {
      wants_forces_ = controls.value().forces_enabled;
      forces_on_ = forces_on_ || wants_forces_;
      stream_->send(encoder_.encode(Message(controls.value())));
    }
    if (stream_ && targets.update()) {
      stream_->sendNewest(MessageStream::Slot::kHandTarget, encoder_.encode(Message(targets.value())));
    }
    if (stream_ && sets.update()) stream_->sendNewest(MessageStream::Slot::kSet, encoder_.encode(sets.value()));
  }

  void sendHeartbeat() {
    if (stream_) stream_->send(encoder_.encode(Message(heartbeat_.next(nowNanoseconds()))));
  }

  void beat() {
    const double silence = 1e-9 * static_cast<double>(nowNanoseconds() - (connecting_ ? attempt_began_ : heard_));
    if (stream_ && silence > options_.silence_time) {
      disconnect({Text("The haptic server at %1 does not answer any more.", server())});
    } else if (stream_ && welcomed_) {
      sendHeartbeat();
    } else if (connecting_ && silence > 4.0 * options_.silence_time) {
      std::error_code ignored;
      socket_.close(ignored);  // Ends the attempt.
    }
    heartbeat_timer_.expires_after(duration(forces_on_ ? kQuickHeartbeatPeriod : kHeartbeatPeriod));
    heartbeat_timer_.async_wait([this](std::error_code cancelled) {
      if (!cancelled) beat();
    });
  }

  const TcpLinkOptions options_;
  asio::io_context context_{1};
  tcp::resolver resolver_;
  asio::steady_timer retry_timer_, heartbeat_timer_;
  tcp::socket socket_;
  std::optional<SecureStreams> secure_;
  std::shared_ptr<MessageStream> stream_;
  Encoder encoder_;
  HeartbeatExchange heartbeat_;
  std::int64_t heard_ = 0, attempt_began_ = 0;
  bool connecting_ = false, welcomed_ = false, take_over_ = false;
  bool wants_forces_ = false, forces_on_ = false;  // What was sent last, and whether there may be any.

  std::atomic<LinkState> state_{LinkState::kConnecting};
  std::atomic<bool> wake_pending_{false}, controls_stylus_{false};
  mutable std::mutex mutex_;
  LinkProblem problem_;
  Welcome welcome_;
  std::optional<DeviceCondition> condition_;
  std::thread thread_;
};

Expected<TcpLinkOptions> linkOptionsFor(const std::string& host, std::uint16_t port) {
  TcpLinkOptions options;
  options.host = host;
  options.port = port;
  const auto file = knownServerKeyFile(host, port);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return options;
  const auto key = loadKey(file);
  HAPTICELL_TRY(key);
  options.key = *key;
  return options;
}

TcpLink::TcpLink(const TcpLinkOptions& options)
    : connection_(std::make_unique<Connection>(options)), watches_(options.accept_watching) {}

TcpLink::~TcpLink() = default;

LinkState TcpLink::linkState() const {
  return connection_->state();
}

LinkProblem TcpLink::problem() const {
  return connection_->problem();
}

std::optional<DeviceDescription> TcpLink::device() const {
  return connection_->device();
}

void TcpLink::takeOver() {
  connection_->takeOver();
}

ClientKind TcpLink::grantedKind() const {
  return connection_->grantedKind();
}

std::optional<DeviceCondition> TcpLink::condition() const {
  return connection_->condition();
}

void TcpLink::calibrate(std::uint32_t step) {
  connection_->calibrate(step);
}

std::uint64_t TcpLink::connections() const {
  return connection_->connections;
}

std::optional<HapticState> TcpLink::latestState() {
  std::optional<HapticState> newest = Connection::newest(connection_->states);
  if (newest) newest->buttons = connection_->presses.take(newest->buttons);
  if (newest && watches_ && !connection_->hasStylus()) newest->buttons = 0;
  return newest;
}

std::optional<ServerStatistics> TcpLink::latestStatistics() {
  return Connection::newest(connection_->statistics);
}

void TcpLink::sendSet(const ConstraintSet& set) {
  connection_->submit(connection_->sets, set);
}

void TcpLink::sendControl(const HapticControl& control) {
  connection_->submit(connection_->controls, control);
}

void TcpLink::sendHandTarget(const HandTarget& target) {
  connection_->submit(connection_->targets, target);
}

}  // namespace hapticell::haptic
