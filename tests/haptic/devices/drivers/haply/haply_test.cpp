// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "haptic/devices/driver_device.h"
#include "haptic/devices/driver_session.h"
#include "haptic/devices/drivers/haply/haply_driver.h"
#include "haptic/devices/drivers/haply/web_socket.h"
#include "tests/haptic/devices/contact_rig.h"
#include "tests/haptic/devices/drivers/haply/fake_haply_service.h"

namespace hapticell::driver {
namespace {

using ::testing::HasSubstr;

TEST(HaplyMessages, ReadsDeviceAndGrip) {
  const auto reports = readHaplyMessage(
      R"({"inverse3":[{"device_id":"04BD","state":{"cursor_position":{"x":0.1,"y":-0.2,"z":0.3}}}],)"
      R"("wireless_verse_grip":[{"state":{"orientation":{"x":0,"y":0,"z":0.6,"w":0.8},"buttons":{"a":false,"b":true}}}]})");
  ASSERT_TRUE(reports);
  ASSERT_EQ(reports->size(), 1u);
  EXPECT_EQ((*reports)[0].device_id, "04BD");
  EXPECT_EQ((*reports)[0].cursor, dvec3(0.1, -0.2, 0.3));
  EXPECT_NEAR((*reports)[0].orientation->z, 0.6, 1e-12);
  EXPECT_EQ((*reports)[0].buttons, 2u);
  EXPECT_TRUE(readHaplyMessage("{}")->empty());
}

TEST(HaplyMessages, RefusesGarbage) {
  const char* const device = R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0,"y":0,"z":0}}}])";
  for (const std::string& text :
       {std::string(), std::string("["), std::string("[]"), std::string(R"({"inverse3":7})"),
        std::string(R"({"inverse3":[{"state":{}}]})"),
        std::string(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":"0","y":0,"z":0}}}]})"),
        std::string(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1e999,"y":0,"z":0}}}]})"),
        device + std::string(R"(,"wireless_verse_grip":[{"state":{"orientation":{"x":0,"y":0,"z":0,"w":0}}}]})")}) {
    EXPECT_FALSE(readHaplyMessage(text)) << text;
  }
}

RC_GTEST_PROP(HaplyMessages, AnyTextDoesNoHarm, (const std::string& text)) {
  readHaplyMessage(text);
}

TEST(HaplyMessages, CommandHasTheServicesForm) {
  const auto command = nlohmann::json::parse(haplyForceCommand("04BD", {1.0, -2.0, 0.5}));
  EXPECT_EQ(command["inverse3"][0]["device_id"], "04BD");
  EXPECT_EQ(command["inverse3"][0]["commands"]["set_cursor_force"]["values"]["y"], -2.0);
}

/// Turns until `good` holds: a network has to be waited for.
template <typename Condition>
bool turnUntil(haptic::DriverSession& session, const Command& command, Condition&& good) {
  for (int i = 0; i < 30000; ++i) {
    if (good(session.turn(command))) return true;
  }
  return false;
}

TEST(Haply, MeasuresAndPushes) {
  FakeHaplyService service;
  HaplyDriver driver;
  driver.configure("address", service.address().c_str());
  driver.configure("middle", "0,-0.2,0.2");
  Found found[2];
  Problem problem;
  ASSERT_EQ(driver.find(found, 2, problem), 1u) << problem.found;
  EXPECT_STREQ(found[0].id, "04BD");
  std::atomic<std::int64_t> now{1};
  haptic::DriverSession session(driver, "04BD", {.now = [&] { return now.load(); }});
  problem = session.open();
  ASSERT_EQ(problem.status, Status::kOk) << problem.found;
  EXPECT_EQ(session.capabilities().measured_axes, 6u);
  Command push;
  push.motors = true;
  push.force[0] = 0.5, push.force[1] = -1.0, push.force[2] = 1.5;
  ASSERT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.measurements > 0; }));
  const State state = session.turn(push).state;
  EXPECT_NEAR(state.position[0], 0.05, 1e-12);
  EXPECT_NEAR(state.position[1], 0.05, 1e-12);
  EXPECT_NEAR(state.orientation[3], 0.6, 1e-12);
  EXPECT_EQ(state.buttons, 5u);
  const auto force = [&] {
    const auto command = service.lastCommand();
    return command ? (*command)["inverse3"][0]["commands"]["set_cursor_force"]["values"]["z"].get<double>() : -1.0;
  };
  EXPECT_TRUE(turnUntil(session, push, [&](const auto&) { return force() == 1.5; }));
  // The virtual work is the same in both frames: the cursor's motion is the position's, axis by axis, and so is the
  // force.
  const auto values = (*service.lastCommand())["inverse3"][0]["commands"]["set_cursor_force"]["values"];
  EXPECT_EQ(values["x"], 0.5);
  EXPECT_EQ(values["y"], -1.0);
  service.x = 0.06, service.y = -0.17, service.z = 0.23;
  EXPECT_TRUE(turnUntil(session, push, [](const auto& answer) {
    const double* const p = answer.state.position;
    return std::abs(p[0] - 0.06) < 1e-12 && std::abs(p[1] - 0.03) < 1e-12 && std::abs(p[2] - 0.03) < 1e-12;
  }));
  session.close();  // A last word of zero.
  for (int i = 0; i < 30000 && force() != 0.0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(force(), 0.0);
}

double forceSentTo(FakeHaplyService& service) {
  const auto command = service.lastCommand();
  return command ? (*command)["inverse3"][0]["commands"]["set_cursor_force"]["values"]["z"].get<double>() : -1.0;
}

/// The service lists no device any more, speaks of something else, or says nothing: 20 ms later the last command is
/// zero, though nothing comes that it would answer.
TEST(Haply, WithoutItsDeviceItsLastCommandIsZero) {
  for (const char* const instead : {R"({"inverse3":[]})", R"({"session":{"x":1}})", ""}) {
    FakeHaplyService service;
    HaplyDriver driver;
    std::atomic<std::int64_t> now{1};
    haptic::DriverSession session(driver, service.address(), {.now = [&] { return now.load(); }});
    ASSERT_EQ(session.open().status, Status::kOk);
    ASSERT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.takes_force; }));
    Command push;
    push.motors = true;
    push.force[2] = 1.5;
    ASSERT_TRUE(turnUntil(session, push, [&](const auto&) { return forceSentTo(service) == 1.5; }));
    service.say(instead);
    service.silent = *instead == '\0';
    for (int i = 0; i < 200; ++i) session.turn(push);  // What was under way has come.
    EXPECT_EQ(forceSentTo(service), 1.5);
    now += 20'000'000;
    session.turn(push);
    for (int i = 0; i < 30000 && forceSentTo(service) != 0.0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(forceSentTo(service), 0.0) << instead;
    EXPECT_TRUE(turnUntil(session, push, [](const auto& answer) { return answer.status == Status::kVanished; }));
    EXPECT_EQ(forceSentTo(service), 0.0);
  }
}

/// A service whose stylus stands 5 mm over the middle, upright: where the rig's set tells the contacts.
std::unique_ptr<FakeHaplyService> serviceAbove(unsigned short port = 0) {
  auto service = std::make_unique<FakeHaplyService>(port);
  service->x = 0.0, service->y = -0.2, service->z = 0.205;
  service->grip = false;
  return service;
}

/// A whole force loop on it, in the service's own time: contact, the service ends, nothing is left; it comes back, no
/// force by itself, and whoever switches it on again feels the floor again.
TEST(Haply, GoneInContactAndBack) {
  auto service = serviceAbove();
  const unsigned short port = service->port();
  HaplyDriver driver;
  driver.configure("middle", "0,-0.2,0.2");
  haptic::DriverDeviceOptions options{.calls = haptic::DriverCalls::kInline};
  options.session.reopen_turns = 5;
  haptic::DriverDevice device(driver, service->address(), options);
  ASSERT_TRUE(device.open());
  haptic::ContactRig rig(device);
  const auto runUntil = [&](auto&& good) {
    for (int i = 0; i < 30000 && !good(); ++i) rig.run(1);
    return good();
  };
  ASSERT_TRUE(runUntil([&] { return rig.loop.current().X_DS.p.z > 0.004; }));
  const auto pressUntilFelt = [&] {
    return runUntil([&] {
      if (!rig.loop.current().forces_on) {  // A service that is late by 20 ms costs the force: as a user would.
        service->z = 0.205;
        rig.switchOnAgain(0.0);
      }
      service->z = std::max(0.196, service->z - 2e-5);
      return rig.force() > 0.5;
    });
  };
  rig.engage(0.0);
  EXPECT_TRUE(pressUntilFelt());
  service.reset();
  EXPECT_TRUE(runUntil([&] { return rig.loop.current().device_fault; }));
  EXPECT_EQ(rig.force(), 0.0);
  service = serviceAbove(port);
  service->z = 0.196;
  EXPECT_TRUE(runUntil([&] { return !rig.loop.current().device_fault; }));
  rig.run(100);
  EXPECT_EQ(rig.force(), 0.0) << "a force came back by itself";
  service->z = 0.205;
  ASSERT_TRUE(runUntil([&] { return rig.loop.current().X_DS.p.z > 0.004; }));
  rig.switchOnAgain(0.0);
  EXPECT_TRUE(pressUntilFelt());
}

TEST(Haply, NobodyThere) {
  HaplyDriver driver;
  driver.configure("address", "ws://127.0.0.1:1");
  Found found[2];
  Problem problem;
  EXPECT_EQ(driver.find(found, 2, problem), 0u);
  EXPECT_EQ(problem.status, Status::kNotFound);
  EXPECT_THAT(problem.fix, HasSubstr("Haply Hub"));
  EXPECT_EQ(driver.open("", problem), nullptr);
}

TEST(Haply, ItsPresenceTellsWhetherTheServiceRuns) {
  auto service = std::make_unique<FakeHaplyService>();
  const unsigned short port = service->port();
  HaplyDriver driver;
  driver.configure("address", service->address().c_str());
  const std::uint64_t there = driver.presence();
  EXPECT_EQ(driver.presence(), there);
  service.reset();
  const std::uint64_t none = driver.presence();
  EXPECT_NE(none, there);
  service = std::make_unique<FakeHaplyService>(port);
  EXPECT_EQ(driver.presence(), there);
  // Who only looked is not in the way of who drives it.
  Problem problem;
  Device* const device = driver.open("", problem);
  ASSERT_NE(device, nullptr) << problem.found;
  driver.close(device);
}

TEST(Haply, AServiceWithoutThatDevice) {
  FakeHaplyService service;
  HaplyDriver driver;
  driver.configure("address", service.address().c_str());
  Problem problem;
  EXPECT_EQ(driver.open("FFFF", problem), nullptr);
  EXPECT_THAT(problem.found, HasSubstr("no such Inverse3"));
}

TEST(Haply, GarbageAndAnUnpluggedDevice) {
  FakeHaplyService service;
  HaplyDriver driver;
  haptic::DriverSession session(driver, service.address());
  ASSERT_EQ(session.open().status, Status::kOk);
  service.say("{\"inverse3\": nonsense");
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.status == Status::kGarbled; }));
  service.say("");
  haptic::DriverSession again(driver, service.address());
  ASSERT_EQ(again.open().status, Status::kOk);
  service.say(R"({"inverse3":[{"device_id":"other","state":{"cursor_position":{"x":0,"y":0,"z":0}}}]})");
  EXPECT_TRUE(turnUntil(again, {}, [](const auto& answer) { return answer.status == Status::kVanished; }));
}

TEST(Haply, TheServiceEndsAndComesBack) {
  auto service = std::make_unique<FakeHaplyService>();
  const unsigned short port = service->port();
  HaplyDriver driver;
  std::vector<std::string> told;
  haptic::DriverSession session(driver, service->address(),
                                {.reopen_turns = 1, .report = [&](const std::string& text) { told.push_back(text); }});
  ASSERT_EQ(session.open().status, Status::kOk);
  service.reset();
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.status == Status::kVanished; }));
  EXPECT_THAT(told.at(0), HasSubstr("service"));
  service = std::make_unique<FakeHaplyService>(port);
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.status == Status::kOk; }));
}

/// Waits up to half a minute: a wait that is ever that long is a fault.
template <typename Condition>
bool comesTrue(Condition&& good) {
  for (int i = 0; i < 30000; ++i) {
    if (good()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(WebSocket, GivesTheNewestTextAndSendsTheNewest) {
  FakeHaplyService service;
  Problem problem;
  auto socket = WebSocket::connect(service.address() + "/any/path", 10000, problem);
  ASSERT_NE(socket, nullptr) << problem.found;
  EXPECT_TRUE(socket->isOpen());
  EXPECT_TRUE(comesTrue([&] { return socket->read(100).has_value(); }));
  // Texts that nobody reads are replaced: what is read is the last, once.
  service.say("{\"n\":1}");
  ASSERT_TRUE(comesTrue([&] { return socket->read(100) == "{\"n\":1}"; }));
  service.say("{\"n\":2}");
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  service.silent = true;
  ASSERT_TRUE(comesTrue([&] { return socket->read(100) == "{\"n\":2}"; }));
  EXPECT_TRUE(comesTrue([&] { return !socket->read(20).has_value(); })) << "nothing newer";
  for (int i = 0; i < 200; ++i) socket->send("{\"i\":" + std::to_string(i) + "}");
  const auto last = [&] {
    const auto command = service.lastCommand();
    return command && command->contains("i") ? (*command)["i"].get<int>() : -1;
  };
  EXPECT_TRUE(comesTrue([&] { return last() == 199; }));
  socket->send("{\"i\":1000}");
  socket.reset();  // What was sent just before still leaves.
  EXPECT_TRUE(comesTrue([&] { return last() == 1000; }));
}

TEST(WebSocket, KnowsThatTheOtherSideIsGoneOrNeverWas) {
  auto service = std::make_unique<FakeHaplyService>();
  const std::string address = service->address();
  EXPECT_TRUE(WebSocket::isServed(address, 10000));
  Problem problem;
  const auto socket = WebSocket::connect(address, 10000, problem);
  ASSERT_NE(socket, nullptr);
  service.reset();
  EXPECT_TRUE(comesTrue([&] { return !socket->isOpen(); }));
  EXPECT_FALSE(WebSocket::isServed(address, 1000));
  EXPECT_EQ(WebSocket::connect(address, 1000, problem), nullptr);
  EXPECT_EQ(problem.status, Status::kNotFound);
  EXPECT_THAT(problem.found, HasSubstr(address));
}

}  // namespace
}  // namespace hapticell::driver
