// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/manipulation_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/in_memory_link.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

/// What a test sees of a loop's link, and how it says when the hand may go on. Outlives both.
class Seen {
 public:
  /// By the loop's thread, once a step.
  void stepped(const haptic::HapticControl& control, const haptic::ConstraintSet& set, const dvec3& force_D) {
    {
      const std::lock_guard lock(mutex_);
      ++steps_;
      control_ = control;
      set_ = set;
      largest_force_ = std::max(largest_force_, glm::length(force_D));
    }
    changed_.notify_all();
  }
  void ended(std::thread::id who, const haptic::HapticControl& control, const haptic::ConstraintSet& set) {
    const std::lock_guard lock(mutex_);
    ended_by_ = who;
    control_ = control;
    set_ = set;
  }
  /// Waits until the loop has made `more` steps.
  void awaitSteps(std::uint64_t more) {
    std::unique_lock lock(mutex_);
    const std::uint64_t until = steps_ + more;
    changed_.wait(lock, [&] { return steps_ >= until; });
  }
  template <typename T>
  T read(T Seen::*member) {
    const std::lock_guard lock(mutex_);
    return this->*member;
  }
  void setHand(const dvec3& p) {
    const std::lock_guard lock(mutex_);
    hand_ = p;
  }

  std::uint64_t steps_ = 0;
  haptic::HapticControl control_;
  haptic::ConstraintSet set_;
  double largest_force_ = 0.0;
  dvec3 hand_{0.0};
  std::thread::id ended_by_;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
};

/// A server in virtual time behind the loop's link: 10 ms of it pass at each step, however long a step takes.
class SteppedServer final : public haptic::HapticLink {
 public:
  explicit SteppedServer(Seen& seen)
      : seen_(seen),
        loop_(device_, clock_, haptic::configuredLoop(device_, {})),
        link_(loop_, clock_, haptic::describe(device_), {.latency = 0.001}) {
    EXPECT_TRUE(device_.open());
    device_.place({});
  }
  ~SteppedServer() override { seen_.ended(std::this_thread::get_id(), control_, set_); }

  haptic::LinkState linkState() const override { return link_.linkState(); }
  haptic::LinkProblem problem() const override { return link_.problem(); }
  std::optional<haptic::DeviceDescription> device() const override { return link_.device(); }
  std::optional<haptic::HapticState> latestState() override {
    device_.hand().hold(Pose::translation(seen_.read(&Seen::hand_)), 0);
    for (int i = 0; i < 10; ++i) link_.step();
    seen_.stepped(control_, set_, loop_.current().force_D);
    return link_.latestState();
  }
  std::optional<haptic::ServerStatistics> latestStatistics() override { return link_.latestStatistics(); }
  void sendSet(const haptic::ConstraintSet& set) override { link_.sendSet(set_ = set); }
  void sendControl(const haptic::HapticControl& control) override { link_.sendControl(control_ = control); }
  void sendHandTarget(const haptic::HandTarget& target) override { link_.sendHandTarget(target); }

 private:
  Seen& seen_;
  haptic::VirtualClock clock_;
  haptic::SimulatedDevice device_{{}};
  haptic::ForceLoop loop_;
  haptic::InMemoryLink link_;
  haptic::HapticControl control_;
  haptic::ConstraintSet set_;
};

constexpr int kPatience = 20'000;  ///< Steps.

class ManipulationLoopTest : public testing::Test {
 protected:
  ManipulationLoopTest() { loop = std::make_unique<ManipulationLoop>(std::make_unique<SteppedServer>(seen), fast()); }
  static config::Configuration fast() {
    config::Configuration configuration;
    configuration.manipulation.rate_hz = 1000.0;
    return configuration;
  }
  /// Steps until it is so; false if that takes too many.
  bool comesTrue(const std::function<bool()>& condition) {
    for (int i = 0; i < kPatience; ++i) {
      if (condition()) return true;
      seen.awaitSteps(1);
    }
    return false;
  }
  bool takesSnapshotWhere(const std::function<bool(const SceneSnapshot&)>& condition) {
    return comesTrue([&] { return loop->latest(snapshot) && condition(snapshot); });
  }
  /// Holds the box that hangs 20 mm above a table; forces are on.
  void holdTheBox() {
    loop->post(command::SetDocument{test::boxOverTable(0.02), {}});
    loop->post(command::SetForces{true});
    ASSERT_TRUE(comesTrue([&] {
      loop->post(command::Grab{2});  // Refused as long as the scene is being prepared.
      return loop->latest(snapshot) && snapshot.stylus.held == 2 && snapshot.stylus.force_ramp == 1.0;
    }));
  }

  Seen seen;
  std::unique_ptr<ManipulationLoop> loop;
  SceneSnapshot snapshot;
};

TEST_F(ManipulationLoopTest, StepsAndShowsWithNothingInItsScene) {
  ASSERT_TRUE(takesSnapshotWhere([](const SceneSnapshot& s) { return s.step > 10 && s.stylus.connected; }));
  EXPECT_EQ(snapshot.stylus.held, 0U);
  EXPECT_TRUE(loop->takeResults().empty());
  const std::uint64_t step = snapshot.step;
  ASSERT_TRUE(takesSnapshotWhere([](const SceneSnapshot&) { return true; })) << "a newer one";
  EXPECT_GT(snapshot.step, step);
}

TEST_F(ManipulationLoopTest, RestsWhileNothingIsHeldAndWakesByACommandByForcesAndByTheHand) {
  const auto idle = [](const SceneSnapshot& s) { return s.idle; };
  const auto works = [](const SceneSnapshot& s) { return !s.idle; };
  ASSERT_TRUE(takesSnapshotWhere(idle));
  loop->post(command::SetClutch{false});
  ASSERT_TRUE(takesSnapshotWhere(works));
  ASSERT_TRUE(takesSnapshotWhere(idle));
  seen.setHand({0.0, 0.0, 0.01});
  ASSERT_TRUE(takesSnapshotWhere(works));
  ASSERT_TRUE(takesSnapshotWhere(idle));
  EXPECT_NEAR(snapshot.stylus.X_DS.p.z, 0.01, 1e-3) << "it goes on looking";
  loop->post(command::SetForces{true});
  ASSERT_TRUE(takesSnapshotWhere([](const SceneSnapshot& s) { return s.stylus.force_ramp == 1.0; }));
  EXPECT_FALSE(snapshot.idle);
  const std::uint64_t step = snapshot.step;
  ASSERT_TRUE(takesSnapshotWhere([step](const SceneSnapshot& s) { return s.step > step + 600; }));
  EXPECT_FALSE(snapshot.idle) << "with forces on it never rests";
}

TEST_F(ManipulationLoopTest, TakesCommandsMovesWhatIsHeldAndFeelsTheTable) {
  holdTheBox();
  seen.setHand({0.0, 0.0, -0.024});
  ASSERT_TRUE(takesSnapshotWhere([](const SceneSnapshot& s) { return s.stylus.force_n > 1.0; }));
  ASSERT_EQ(snapshot.entities.size(), 1U);
  EXPECT_EQ(snapshot.entities[0].id, 2U);
  EXPECT_TRUE(snapshot.entities[0].in_contact);
  EXPECT_GE(snapshot.entities[0].X_WE.p.z, 0.03) << "never inside the table";
  EXPECT_LE(snapshot.entities[0].X_WE.p.z, 0.0315) << "at its safety distance";
  loop->post(command::Release{});
  std::vector<Result> results;
  ASSERT_TRUE(comesTrue([&] {
    for (const Result& result : loop->takeResults()) results.push_back(result);
    return !results.empty() && std::holds_alternative<result::Moved>(results.back());
  }));
  EXPECT_TRUE(std::holds_alternative<result::Grabbed>(results.front()));
  EXPECT_NEAR(std::get<result::Moved>(results.back()).X_WE.p.z, 0.031, 5e-4);
}

/// Whoever shows pictures is called as soon as there is one of a new contact.
TEST_F(ManipulationLoopTest, SaysAtOnceThatThereIsAPictureOfAContact) {
  std::atomic<int> called{0};
  loop = std::make_unique<ManipulationLoop>(std::make_unique<SteppedServer>(seen), fast(), [&called] { ++called; });
  holdTheBox();
  EXPECT_EQ(called, 0);
  EXPECT_EQ(snapshot.felt_ns, 0);
  seen.setHand({0.0, 0.0, -0.024});
  ASSERT_TRUE(comesTrue([&] { return called > 0; }));
  while (loop->latest(snapshot)) {
  }
  EXPECT_GT(snapshot.felt_ns, 0);
  EXPECT_TRUE(std::any_of(snapshot.pairs.begin(), snapshot.pairs.end(), [](const auto& pair) { return pair.contact; }));
}

TEST_F(ManipulationLoopTest, EndsWithForcesOffAndNothingToFeel) {
  holdTheBox();
  ASSERT_TRUE(comesTrue([&] { return seen.read(&Seen::set_).count > 0; }));
  ASSERT_TRUE(seen.read(&Seen::control_).forces_enabled);
  loop.reset();
  EXPECT_FALSE(seen.control_.forces_enabled);
  EXPECT_EQ(seen.set_.count, 0U);
  EXPECT_EQ(seen.ended_by_, std::this_thread::get_id()) << "its thread must have been joined before";
}

/// Ended in the middle of it (the device is disconnected): what was recorded so far and where it was let go are kept.
TEST_F(ManipulationLoopTest, GivesBackWhatWasRecordedWhenItIsEnded) {
  holdTheBox();
  command::StartRecording order;
  order.take = "cut short";
  order.options.mode = trajectory::RecordingMode::kEveryStep;
  loop->post(order);
  seen.setHand({0.02, 0.0, 0.0});
  ASSERT_TRUE(takesSnapshotWhere([](const SceneSnapshot& s) { return s.recording.on && s.recording.frames > 20; }));
  const std::size_t frames = snapshot.recording.frames;
  const result::Recorded* recorded = nullptr;
  const result::Moved* moved = nullptr;
  const std::vector<Result> results = loop->finish();
  for (const Result& one : results) {
    if (const auto* found = std::get_if<result::Recorded>(&one)) recorded = found;
    if (const auto* found = std::get_if<result::Moved>(&one)) moved = found;
  }
  ASSERT_NE(recorded, nullptr);
  ASSERT_EQ(recorded->trajectories.size(), 1U);
  EXPECT_EQ(recorded->trajectories[0].take, "cut short");
  EXPECT_GE(recorded->trajectories[0].size(), frames);
  ASSERT_NE(moved, nullptr);
  EXPECT_GT(moved->X_WE.p.x, 0.0) << "let go where it was";
  EXPECT_TRUE(loop->finish().empty()) << "ended already";
}

TEST_F(ManipulationLoopTest, TakesTheNewestDocumentAndKeepsWhatIsHeld) {
  holdTheBox();
  for (int i = 0; i < 20; ++i) {
    std::vector<workcell::Entity> entities = test::boxOverTable(0.02);
    entities.push_back(
        test::solid(3, "plate", geometry::makeBox({0.2, 0.2, 0.01 + 1e-4 * i}), Pose::translation({0.5, 0, 0.1})));
    loop->post(command::SetDocument{std::move(entities), {}});
  }
  ASSERT_TRUE(takesSnapshotWhere([](const SceneSnapshot& s) { return s.stylus.held == 2; }));
  seen.setHand({0.02, 0.0, 0.0});
  ASSERT_TRUE(
      takesSnapshotWhere([](const SceneSnapshot& s) { return !s.entities.empty() && s.entities[0].X_WE.p.x > 0.015; }));
}

TEST_F(ManipulationLoopTest, MayBePostedToFromManyThreadsAndEndedMeanwhile) {
  holdTheBox();
  std::vector<std::thread> users;
  for (int k = 0; k < 3; ++k) {
    users.emplace_back([&, k] {
      for (int i = 0; i < 300; ++i) {
        loop->post(command::SetScale{{ScaleLevel::kNumber, 1.0 + 0.1 * k}});
        if (k == 0) loop->takeResults();
      }
    });
  }
  for (std::thread& user : users) user.join();
  loop->post(command::SetScale{{ScaleLevel::kNumber, 2.0}});
  ASSERT_TRUE(takesSnapshotWhere([](const SceneSnapshot& s) { return s.stylus.motion_scale == 2.0; }));
}

}  // namespace
}  // namespace hapticell::manipulation
