// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/client_table.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/system/plain_text.h"
#include "haptic/devices/device_care.h"
#include "haptic/protocol/link_problem.h"
#include "haptic/server/clock.h"
#include "haptic/server/force_loop.h"

namespace hapticell::haptic {

namespace {

// s for a refused client to read why: many round trips of any network. Half: a slow one may not learn it; twice: it
// keeps its place twice as long.
constexpr double kFarewellTime = 1.0;
// Refused clients that may still read why, a quarter of max_waiting. Half: in a crowd more are cut off without a
// reason; twice: more sockets for clients that were refused.
constexpr std::ptrdiff_t kMostFarewells = 32;
// Waiting connections of the controller's machine that make room for no other, so that it can come back. Half: a
// third try of its own can be closed; twice: others lose four places more.
constexpr std::size_t kWayBack = 4;
// Bytes of what a client calls itself: a line of a log. Half: some names are cut; twice: a long line.
constexpr std::size_t kLongestName = 80;
// s between two states of a stylus that lies still: 20 Hz, as in docs/library/protocol.md. Half: an idle desk
// works twice as much; twice: near the 0.1 s after which a heart-beat is due.
constexpr double kStillPeriod = 0.05;
// A stylus that lies still trembles by its encoders' steps: so many of the device's own (one to each side, and half),
// and rad. Half: one step is motion, so nothing rests; twice: slow motion comes in steps of 3 counts.
constexpr double kStillSteps = 1.5, kStillTurn = 1e-3;

double seconds(std::int64_t nanoseconds) {
  return kSecondsPerNanosecond * static_cast<double>(nanoseconds);
}

}  // namespace

ClientTable::ClientTable(ForceLoop& loop, const Clock& clock, const DeviceDescription& device,
                         const NetworkOptions& options)
    : loop_(loop), clock_(clock), device_(device), options_(options), reports_(options.report) {}

ClientTable::~ClientTable() {
  for (const auto& client : clients_) client->stream->close();
  loop_.closeLink();
}

void ClientTable::report(ReportBudget::Kind kind, const std::string& sentence) {
  reports_.tell(kind, sentence, clock_.now());
}

void ClientTable::report(const Client& client, const std::string& sentence) {
  const bool controls = client.kind == ClientKind::kController;
  report(controls ? ReportBudget::Kind::kController : ReportBudget::Kind::kWatcher, sentence);
}

bool ClientTable::waits(const Client& client) {
  return !client.gone && !client.kind && !client.has_key && !client.stream->finishing();
}

bool ClientTable::makeRoom(const std::string& network) {
  std::map<std::string, std::size_t> waiting;  // By network.
  for (const auto& client : clients_) waiting[client->network] += waits(*client) ? 1 : 0;
  if (waiting[network] >= options_.max_waiting_of_address) {
    dropOldest(network);
    return false;
  }
  std::size_t all = 0;
  std::string most = network;
  for (const auto& [name, count] : waiting) {
    all += count;
    const bool kept_free = name == controllers_network_ && count <= kWayBack;
    if (!kept_free && count > waiting[most]) most = name;
  }
  if (all < options_.max_waiting) return true;
  dropOldest(most);
  return false;
}

void ClientTable::dropOldest(const std::string& network) {
  const auto oldest =
      std::find_if(clients_.begin(), clients_.end(), [&](const auto& c) { return waits(*c) && c->network == network; });
  if (oldest == clients_.end()) return;
  drop(**oldest, {});
  reports_.count(ReportBudget::Kind::kRefused);
}

void ClientTable::limitFarewells() {
  const auto leaves = [](const auto& c) { return !c->gone && c->stream->finishing(); };
  if (std::count_if(clients_.begin(), clients_.end(), leaves) < kMostFarewells) return;
  drop(**std::find_if(clients_.begin(), clients_.end(), leaves), {});
}

bool ClientTable::add(std::unique_ptr<ByteStream> connection) {
  auto made = std::make_unique<Client>();
  Client& client = *made;
  client.since_ns = client.heard_ns = clock_.now();
  client.stream = std::make_shared<MessageStream>(
      std::move(connection),
      MessageStream::Handlers{
          .message = [this, &client](const Message& message) { hear(client, message); },
          .garbage = [this, &client](const Error& error) { refuse(client, "Not understood: " + error.message()); },
          .unauthenticated =
              [this, &client](HandshakeFailure, const Text& why) {
                report(ReportBudget::Kind::kRefused, "Refused " + client.name + ": " + english(why) + ".");
                drop(client, {});
              },
          .opened = [this, &client] { opened(client); },
          .closed = [this, &client] { drop(client, "is gone"); }});
  client.name = "a program at " + client.stream->peer();
  client.network = client.stream->peerNetwork();
  const bool room = makeRoom(client.network);
  clients_.push_back(std::move(made));
  client.stream->start();
  return room;
}

void ClientTable::opened(Client& client) {
  client.has_key = options_.key.has_value();
  client.heard_ns = clock_.now();
}

void ClientTable::hear(Client& client, const Message& message) {
  client.heard_ns = clock_.now();
  if (&client == controller_) loop_.heard();
  if (!client.kind) {
    const auto* hello = std::get_if<Hello>(&message);
    return hello != nullptr ? hearHello(client, *hello) : refuse(client, "The first message must be a Hello.");
  }
  if (const auto* beat = std::get_if<Heartbeat>(&message)) {
    client.heartbeat.heard(*beat, client.heard_ns);
    client.beats.heard(client.heard_ns, client.heartbeat.roundTrip());
    if (&client == controller_) loop_.expectWithin(client.beats.limit());
    return client.stream->send(encoder_.encode(Message(client.heartbeat.next(clock_.now()))));
  }
  if (const auto* calibrate = std::get_if<Calibrate>(&message); calibrate != nullptr && client.wants_condition) {
    if (options_.care != nullptr) options_.care->calibrate(calibrate->step);
    return;
  }
  hearController(client, message);
}

void ClientTable::hearController(Client& client, const Message& message) {
  const auto* set = std::get_if<ConstraintSet>(&message);
  const auto* control = std::get_if<HapticControl>(&message);
  const auto* target = std::get_if<HandTarget>(&message);
  if (set == nullptr && control == nullptr && target == nullptr) {
    return refuse(client,
                  "After its Hello a client sends only constraint sets, controls, hand targets and heart-beats.");
  }
  if (&client != controller_) return refuse(client, "A watcher may send heart-beats only.");
  if (set != nullptr) submitSet(client, *set);
  if (control != nullptr) loop_.submit(*control);
  if (target != nullptr) loop_.submit(*target);
}

void ClientTable::submitSet(const Client& client, const ConstraintSet& set) {
  stamped_ = set;
  const auto offset = client.heartbeat.fromPeerClock();
  // A stamp from outside may be anything: one that is not of the last minute counts as none.
  const std::int64_t earliest = clock_.now() - toNanoseconds(60.0);
  const bool plausible =
      offset && set.stamp_ns > earliest - *offset && set.stamp_ns <= clock_.now() - *offset + toNanoseconds(1.0);
  stamped_.stamp_ns = plausible ? set.stamp_ns + *offset : 0;
  loop_.submit(stamped_);
}

void ClientTable::hearHello(Client& client, const Hello& hello) {
  if (!hello.program.empty()) client.name = plainText(hello.program, kLongestName) + " at " + client.stream->peer();
  client.wants_condition = hello.wants_condition;
  if (hello.protocol_version != kProtocolVersion) {
    return refuse(client, "This haptic server speaks version " + std::to_string(kProtocolVersion) +
                              " of the protocol, the client version " + std::to_string(hello.protocol_version) +
                              ". Install the same release of both.");
  }
  // Whoever may control always gets in, however many watch.
  const bool controls = hello.kind == ClientKind::kController && grantControl(client, hello);
  if (controls) return welcome(client, ClientKind::kController);
  if (hello.kind == ClientKind::kWatcher || hello.accept_watching) {
    const std::optional<Refusal> full = crowded(client);
    return full ? refuse(client, *full) : welcome(client, ClientKind::kWatcher);
  }
  refuse(client, {.reason = RefusalReason::kControlled, .subject = controller_->name});
}

/// Why no more may watch; empty: there is room.
std::optional<Refusal> ClientTable::crowded(const Client& client) const {
  std::size_t all = 0, of_address = 0;
  for (const auto& other : clients_) {
    if (other->gone || other->stream->finishing() || other->kind != ClientKind::kWatcher) continue;
    ++all;
    of_address += other->network == client.network ? 1 : 0;
  }
  if (all >= options_.max_clients)
    return Refusal{.reason = RefusalReason::kFull, .subject = std::to_string(options_.max_clients)};
  const bool here = client.network.starts_with("127.") || client.network.starts_with("::/");
  if (!here && of_address >= options_.max_clients_of_address)
    return Refusal{.reason = RefusalReason::kFullOfMachine, .subject = std::to_string(of_address)};
  return std::nullopt;
}

bool ClientTable::controllerIsSilent() const {
  return seconds(clock_.now() - controller_->heard_ns) > options_.takeover_time;
}

bool ClientTable::grantControl(Client& client, const Hello& hello) {
  if (controller_ != nullptr && hello.take_over) {
    Client& before = *controller_;
    refuse(before, {.reason = RefusalReason::kTakenOver, .subject = client.name});
  } else if (controller_ != nullptr && controllerIsSilent() && !hello.accept_watching) {
    // One that would watch leaves it to its user.
    Client& silent = *controller_;
    refuse(silent, {.reason = RefusalReason::kSilent, .subject = client.name});
  }
  return controller_ == nullptr;
}

void ClientTable::welcome(Client& client, ClientKind kind) {
  client.kind = kind;
  told_ns_ = 0;
  if (kind == ClientKind::kController) {
    controller_ = &client;
    controllers_process_ = PeerProcess::find(client.stream->peer(), options_.port);
    controllers_network_ = client.network;
    loop_.openLink();
  }
  client.stream->send(encoder_.encode(Message(Welcome{
      .protocol_version = kProtocolVersion, .kind = kind, .tick_rate_hz = 1.0 / loop_.period(), .device = device_})));
  if (client.wants_condition && options_.care != nullptr) {
    client.stream->send(encoder_.encode(Message(options_.care->condition())));
  }
  report(client, client.name + (kind == ClientKind::kController ? " controls the stylus." : " watches."));
}

void ClientTable::refuse(Client& client, const std::string& sentence) {
  refuse(client, Refusal{.sentence = sentence});
}

void ClientTable::refuse(Client& client, Refusal refusal) {
  if (client.gone || client.stream->finishing()) return;
  refusal.sentence = english(problemOf(refusal));
  if (&client == controller_) {
    controller_ = nullptr;
    loop_.closeLink();
  }
  report(ReportBudget::Kind::kRefused, "Refused " + client.name + ": " + refusal.sentence);
  limitFarewells();
  client.since_ns = clock_.now();
  client.stream->send(encoder_.encode(Message(std::move(refusal))));
  client.stream->finish();
}

void ClientTable::drop(Client& client, const std::string& why) {
  if (client.gone) return;
  client.gone = true;
  client.stream->close();
  if (&client == controller_) {
    controller_ = nullptr;
    loop_.closeLink();
  }
  if (client.kind && !why.empty()) report(client, client.name + " " + why + ".");
}

void ClientTable::broadcast() {
  const auto sendToAll = [this](MessageStream::Slot slot, std::span<const std::uint8_t> frame) {
    for (const auto& client : clients_) {
      if (client->kind && !client->gone) client->stream->sendNewest(slot, frame);
    }
  };
  if (loop_.updateState()) {
    if (isNews(loop_.state())) {
      sendToAll(MessageStream::Slot::kState, encoder_.encode(loop_.state()));
      told_state_ = loop_.state();
      told_ns_ = clock_.now();
    }
    reportStall(loop_.state().client_stalled);
  }
  if (!loop_.updateFigures()) return;
  LinkFigures link;
  if (controller_ != nullptr) {
    link.round_trip = controller_->heartbeat.roundTrip();
    if (const auto offset = controller_->heartbeat.fromPeerClock())
      link.clock_offset = kSecondsPerNanosecond * static_cast<double>(*offset);
  }
  sendToAll(MessageStream::Slot::kStatistics, encoder_.encode(Message(statisticsOf(loop_.figures(), link))));
}

bool ClientTable::isNews(const HapticState& state) const {
  if (told_ns_ == 0 || state.forces_on || state.force_ramp > 0.0 || state.force_D != dvec3(0.0)) return true;
  if (seconds(clock_.now() - told_ns_) >= kStillPeriod) return true;
  const auto moved = [this](const Pose& a, const Pose& b) {
    return glm::length(a.p - b.p) > kStillSteps * device_.resolution ||
           glm::length(rotationVector(glm::conjugate(a.q) * b.q)) > kStillTurn;
  };
  return state.buttons != told_state_.buttons || state.adopted_set != told_state_.adopted_set ||
         state.forces_on != told_state_.forces_on || state.device_fault != told_state_.device_fault ||
         state.client_stalled != told_state_.client_stalled || moved(state.X_DS, told_state_.X_DS) ||
         moved(state.X_DP, told_state_.X_DP);
}

void ClientTable::reportStall(bool stalled) {
  if (stalled == stalled_) return;
  stalled_ = stalled;
  if (controller_ == nullptr) return;
  report(*controller_,
         controller_->name +
             (stalled ? " lives but has sent no constraint set that could be taken for 2 s: the force fades."
                      : " sends constraint sets again: the force returns through the engage gate."));
}

bool ClientTable::overdue(const Client& client, std::int64_t now) const {
  if (client.stream->finishing()) return seconds(now - client.since_ns) > kFarewellTime;
  if (options_.key && !client.has_key) return seconds(now - client.since_ns) > options_.handshake_time;
  if (!client.kind) return seconds(now - client.since_ns) > options_.hello_time;
  return seconds(now - client.heard_ns) > options_.silence_time;
}

void ClientTable::sendCondition() {
  if (options_.care == nullptr || options_.care->changes() == told_condition_) return;
  told_condition_ = options_.care->changes();
  const DeviceCondition condition = options_.care->condition();
  for (const auto& client : clients_) {
    if (client->kind && client->wants_condition && !client->gone)
      client->stream->send(encoder_.encode(Message(condition)));
  }
}

void ClientTable::sweep() {
  sendCondition();
  if (controller_ != nullptr && controllers_process_ && controllers_process_->isDying()) {
    controllers_process_.reset();
    drop(*controller_, "is gone");
  }
  const std::int64_t now = clock_.now();
  for (const auto& client : clients_) {
    if (client->gone || !overdue(*client, now)) continue;
    if (options_.key && !client->has_key) {
      report(ReportBudget::Kind::kRefused, "Gave up " + client->name + ": it did not show the key.");
      drop(*client, {});
    } else if (!client->kind && !client->stream->finishing()) {
      refuse(*client, "No Hello within " + std::to_string(static_cast<int>(options_.hello_time)) + " seconds.");
    } else {
      drop(*client, "was silent for too long");
    }
  }
  std::erase_if(clients_, [](const auto& client) { return client->gone; });
  reports_.summarize(now);
}

}  // namespace hapticell::haptic
