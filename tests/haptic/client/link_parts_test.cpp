// SPDX-License-Identifier: Apache-2.0
// The parts of a client's link, each by itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptic/client/link_mailboxes.h"
#include "haptic/client/link_report.h"
#include "haptic/client/server_connection.h"
#include "haptic/client/server_dialer.h"
#include "haptic/client/server_problems.h"
#include "tests/haptic/server/live_server.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

TEST(LinkReport, TellsOfTheDeviceOnlyWhileItIsConnected) {
  LinkReport report({Text("Connecting.")});
  EXPECT_EQ(report.state(), LinkState::kConnecting);
  EXPECT_EQ(english(report.problem()), "Connecting.");
  EXPECT_EQ(report.grantedKind(), ClientKind::kController);
  EXPECT_FALSE(report.hasStylus());

  Welcome welcome;
  welcome.kind = ClientKind::kWatcher;
  welcome.device.peak_force = 6.4;
  report.take(welcome);
  DeviceCondition condition;
  condition.calibrated = false;
  report.take(condition);
  EXPECT_FALSE(report.device().has_value()) << "not yet connected";
  report.connect();
  EXPECT_TRUE(report.problem().empty());
  ASSERT_TRUE(report.device().has_value());
  EXPECT_EQ(report.device()->peak_force, 6.4);
  ASSERT_TRUE(report.condition().has_value());
  EXPECT_FALSE(report.condition()->calibrated);
  EXPECT_FALSE(report.hasStylus());
  EXPECT_EQ(report.connections(), 1u);

  report.become(LinkState::kDisconnected, {Text("Gone.")});
  EXPECT_FALSE(report.device().has_value());
  EXPECT_FALSE(report.condition().has_value());
  EXPECT_EQ(english(report.problem()), "Gone.");
  welcome.kind = ClientKind::kController;
  report.take(welcome);
  report.connect();
  EXPECT_TRUE(report.hasStylus());
  EXPECT_FALSE(report.condition().has_value()) << "that of the connection before";
  EXPECT_EQ(report.connections(), 2u);
}

TEST(LinkReport, ARefusalStaysToBeReadWhileItIsTriedAgain) {
  LinkReport report({Text("Connecting.")});
  report.become(LinkState::kRefused, {Text("Another controls it.")});
  report.tryAgain();
  EXPECT_EQ(report.state(), LinkState::kRefused);
  report.become(LinkState::kDisconnected, {Text("Gone.")});
  report.tryAgain();
  EXPECT_EQ(report.state(), LinkState::kConnecting);
  EXPECT_EQ(english(report.problem()), "Gone.");
}

TEST(LinkMailboxes, WhatAnEarlierConnectionLeftUnsentIsDropped) {
  LinkMailboxes mailboxes;
  HapticState third;
  third.tick = 3;
  mailboxes.states.write(third);
  mailboxes.controls.write({.forces_enabled = true});
  mailboxes.presses.hear(1);
  mailboxes.beginConnection();
  EXPECT_FALSE(mailboxes.controls.update());
  EXPECT_EQ(mailboxes.presses.take(0), 0u);
  const auto state = LinkMailboxes::newest(mailboxes.states);
  ASSERT_TRUE(state.has_value()) << "what was received stays";
  EXPECT_EQ(state->tick, 3u);
  EXPECT_FALSE(LinkMailboxes::newest(mailboxes.states).has_value());
}

TEST(ServerProblems, SayWhatHelps) {
  EXPECT_THAT(english(noKeyFor("10.0.0.7:4747")), HasSubstr("hapticell-cli pair 10.0.0.7:4747"));
  EXPECT_THAT(english(noServerAt("a:1")), HasSubstr("Start hapticell-haptic-server."));
  EXPECT_THAT(english(closedBy("a:1", false, false)), HasSubstr("wants a key"));
  EXPECT_EQ(english(closedBy("a:1", true, false)), "The haptic server at a:1 closed the connection.");
  EXPECT_EQ(closedBy("a:1", false, true), closedBy("a:1", true, false));
  EXPECT_NE(strangerAt("a:1", false), strangerAt("a:1", true));
  const Text why("it ended");
  EXPECT_THAT(english(noHandshakeWith("a:1", HandshakeFailure::kEnded, why)), HasSubstr("tries again by itself"));
  EXPECT_THAT(english(noHandshakeWith("a:1", HandshakeFailure::kOtherSpeech, why)), HasSubstr("--listen"));
  EXPECT_THAT(english(connectingTo("a:1")), HasSubstr("a:1"));
  EXPECT_THAT(english(silentServer("a:1")), HasSubstr("does not answer"));
}

TEST(ServerDialer, LeavesThisMachineOnlyWithAKey) {
  asio::io_context context;
  LinkProblem problem;
  // An address for documentation (RFC 5737): nothing is sent to it.
  ServerDialer dialer(context, "192.0.2.1", 4747, false,
                      {.connected = [](asio::ip::tcp::socket) { FAIL(); },
                       .failed = [&problem](LinkProblem failed) { problem = std::move(failed); }});
  EXPECT_FALSE(dialer.isDialing());
  dialer.dial();
  EXPECT_TRUE(dialer.isDialing());
  EXPECT_GE(dialer.dialingTime(), 0.0);
  context.run();
  EXPECT_FALSE(dialer.isDialing());
  EXPECT_EQ(problem, noKeyFor("192.0.2.1:4747"));
}

TEST(ServerDialer, HandsTheSocketOutAndMayBeUsedAgain) {
  LiveServer server;
  asio::io_context context;
  int connected = 0;
  ServerDialer dialer(context, "127.0.0.1", server.port(), false,
                      {.connected = [&connected](const asio::ip::tcp::socket& socket) { connected += socket.is_open(); },
                       .failed = [](const LinkProblem& problem) { FAIL() << english(problem); }});
  for (int attempt = 1; attempt <= 2; ++attempt) {
    dialer.dial();
    context.restart();
    context.run();
    EXPECT_EQ(connected, attempt);
  }
}

TEST(ServerConnection, DropsWhatIsSentWithoutAConnection) {
  LiveServer server;
  TcpLinkOptions options;
  options.port = server.port();
  ServerConnection connection(options);
  ASSERT_TRUE(eventually([&] { return connection.report.state() == LinkState::kConnected; }));
  HapticControl control;
  control.forces_enabled = true;
  connection.submit(connection.mailboxes.controls, control);
  EXPECT_TRUE(eventually([&] {
    const auto state = LinkMailboxes::newest(connection.mailboxes.states);
    return state && state->forces_on;
  }));
  server.stop();
  ASSERT_TRUE(eventually([&] { return connection.report.state() != LinkState::kConnected; }));
  control.forces_enabled = false;
  connection.submit(connection.mailboxes.controls, control);
  EXPECT_TRUE(connection.mailboxes.controls.value().forces_enabled);
}

}  // namespace
}  // namespace hapticell::haptic
