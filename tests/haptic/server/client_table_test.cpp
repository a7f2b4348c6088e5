// SPDX-License-Identifier: Apache-2.0
// The rules for connections, over real sockets but in virtual time and in one thread.
#include "haptic/server/client_table.h"

#include <gtest/gtest.h>

#include <asio/io_context.hpp>

#include "haptic/server/clock.h"
#include "haptic/server/force_loop.h"
#include "tests/haptic/server/raw_client.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

class ClientTableTest : public ::testing::Test {
 protected:
  ClientTableTest() : acceptor_(io_, {asio::ip::address_v4::loopback(), 0}) {
    static_cast<void>(device_.open());
    device_.place(Pose::translation(dvec3(0.0, 0.0, 0.005)));
    options_.report = [this](const std::string& sentence) { reports += sentence + "\n"; };
    loop_.emplace(device_, clock, patientOptionsFor(device_));
    description_ = describe(device_);
    table.emplace(*loop_, clock, description_, options_);
  }
  ~ClientTableTest() override { table.reset(); }

  /// A client that the table has accepted and that has said Hello.
  std::unique_ptr<RawClient> client(const std::optional<Hello>& hello) {
    auto made = std::make_unique<RawClient>(acceptor_.local_endpoint().port());
    EXPECT_TRUE(table->add(plainStream(acceptor_.accept())));
    if (hello) {
      EXPECT_TRUE(made->send(*hello));
    }
    poll();
    return made;
  }
  /// Lets the table read what the clients have sent: over loopback it is there at once.
  void poll() {
    for (int i = 0; i < 4; ++i) {
      io_.restart();
      io_.poll();
    }
  }
  /// The clock goes on; the table looks after its clients as the network thread does.
  void pass(double seconds) {
    clock.advance(toNanoseconds(seconds));
    table->sweep();
    poll();
  }
  void tick() {
    clock.advance(toNanoseconds(loop_->period()));
    loop_->tick();
    table->broadcast();
    poll();
  }

  static Hello controller(const std::string& program) { return {.kind = ClientKind::kController, .program = program}; }
  static Hello watcher(const std::string& program) { return {.kind = ClientKind::kWatcher, .program = program}; }

  std::string reports;
  VirtualClock clock;
  std::optional<ClientTable> table;

 private:
  asio::io_context io_;
  asio::ip::tcp::acceptor acceptor_;
  SimulatedDevice device_;
  NetworkOptions options_;
  DeviceDescription description_;
  std::optional<ForceLoop> loop_;
};

TEST_F(ClientTableTest, AClientHasTwoSecondsForItsHello) {
  EXPECT_TRUE(table->empty());
  const auto mute = client(std::nullopt);
  pass(1.99);
  EXPECT_FALSE(table->empty());
  EXPECT_EQ(reports, "");
  pass(0.02);
  EXPECT_NE(reports.find("No Hello within 2 seconds"), std::string::npos) << reports;
  EXPECT_NE(mute->refusalThenEnd().find("No Hello within 2 seconds"), std::string::npos);
  pass(1.01);
  EXPECT_TRUE(table->empty()) << "it had a second to read why";
}

TEST_F(ClientTableTest, AWatcherThatIsSilentForFiveSecondsIsDroppedUnlessItsHeartBeats) {
  const auto silent = client(watcher("silent")), alive = client(watcher("alive"));
  ASSERT_TRUE(silent->receiveOf<Welcome>() && alive->receiveOf<Welcome>());
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(alive->send(Heartbeat{.sent_ns = 1 + i, .echo_ns = 0, .held_ns = 0}));
    poll();
    EXPECT_EQ(reports.find("silent for too long"), std::string::npos);
    pass(1.7);
  }
  EXPECT_NE(reports.find("silent at 127.0.0.1"), std::string::npos) << reports;
  EXPECT_NE(reports.find("was silent for too long"), std::string::npos) << reports;
  EXPECT_FALSE(table->empty());
  const auto beat = alive->receiveOf<Heartbeat>();
  ASSERT_TRUE(beat);
  EXPECT_EQ(beat->echo_ns, 1);
  EXPECT_EQ(silent->refusalThenEnd(), "");
}

TEST_F(ClientTableTest, OneControlsUntilItIsSilentOrAskedToGiveWay) {
  const auto first = client(controller("first"));
  const auto welcome = first->receiveOf<Welcome>();
  ASSERT_TRUE(welcome);
  EXPECT_EQ(welcome->kind, ClientKind::kController);
  EXPECT_EQ(welcome->tick_rate_hz, 1000.0);
  const auto refused = client(controller("second"))->receiveOf<Refusal>();
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->reason, RefusalReason::kControlled);
  EXPECT_EQ(refused->subject.substr(0, 5), "first") << "it is told by whom";
  Hello either = controller("either");
  either.accept_watching = true;
  const auto watching = client(either)->receiveOf<Welcome>();
  ASSERT_TRUE(watching);
  EXPECT_EQ(watching->kind, ClientKind::kWatcher);
  pass(0.79);
  EXPECT_TRUE(client(controller("too early"))->receiveOf<Refusal>());
  pass(0.02);
  const auto third = client(controller("third"));
  ASSERT_TRUE(third->receiveOf<Welcome>());
  const auto replaced = first->receiveOf<Refusal>();
  ASSERT_TRUE(replaced);
  EXPECT_EQ(replaced->reason, RefusalReason::kSilent);
  Hello user = controller("fourth");
  user.take_over = true;
  ASSERT_TRUE(client(user)->receiveOf<Welcome>()) << "at the user's request at once";
  const auto taken = third->receiveOf<Refusal>();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->reason, RefusalReason::kTakenOver);
  EXPECT_EQ(taken->subject.substr(0, 6), "fourth");
}

TEST_F(ClientTableTest, OnlyTheControllerMaySendSets) {
  const auto controls = client(controller("controls")), watches = client(watcher("watches"));
  ASSERT_TRUE(controls->receiveOf<Welcome>() && watches->receiveOf<Welcome>());
  ASSERT_TRUE(controls->send(floorSet(7)) && watches->send(floorSet(8)));
  poll();
  for (int i = 0; i < 5; ++i) tick();
  EXPECT_EQ(watches->refusalThenEnd(), "A watcher may send heart-beats only.");
  table.reset();  // Ends the connection, so that all that was sent can be read.
  std::uint64_t adopted = 0;
  while (const auto state = controls->receiveOf<HapticState>()) adopted = state->adopted_set;
  EXPECT_EQ(adopted, 7u);
}

TEST_F(ClientTableTest, AStylusThatLiesStillIsToldOfTwentyTimesASecond) {
  const auto watches = client(watcher("watches"));
  ASSERT_TRUE(watches->receiveOf<Welcome>());
  for (int i = 0; i < 1000; ++i) tick();
  table.reset();  // Ends the connection, so that all that was sent can be counted.
  int states = 0, statistics = 0;
  while (const auto message = watches->receive()) {
    states += std::holds_alternative<HapticState>(*message) ? 1 : 0;
    statistics += std::holds_alternative<ServerStatistics>(*message) ? 1 : 0;
  }
  EXPECT_GE(states, 20);
  EXPECT_LE(states, 25) << "the first milliseconds are news";
  EXPECT_GE(statistics, 9);
  EXPECT_LE(statistics, 11);
}

}  // namespace
}  // namespace hapticell::haptic
