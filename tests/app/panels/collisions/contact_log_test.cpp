// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/contact_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace hapticell::app {
namespace {

using Kind = ContactEvent::Kind;

std::string nameOf(workcell::EntityId entity, const std::string& part) {
  return (entity == 1 ? "part" : "jig, \"left\"") + (part.empty() ? "" : " " + part);
}

/// What the loop tells at a time: the gap of the one pair, m; 0 is contact, below 10 mm a near miss.
manipulation::SceneSnapshot at(double time_s, double gap, double force_n = 0.0) {
  manipulation::SceneSnapshot snapshot;
  snapshot.time_s = time_s;
  snapshot.stylus.held = 1;
  snapshot.stylus.force_n = force_n;
  manipulation::PairState pair;
  pair.moved = 1, pair.other = 2;
  pair.distance = gap;
  pair.contact = gap <= 0.0;
  pair.near_miss = gap < 0.010;
  snapshot.pairs.push_back(pair);
  return snapshot;
}

std::vector<Kind> kinds(const ContactLog& log) {
  std::vector<Kind> result;
  for (const ContactEvent& event : log.events()) result.push_back(event.kind);
  return result;
}

TEST(ContactLog, EventsComeInTheirOrderWithLeastDistanceGreatestForceAndLength) {
  ContactLog log;
  for (int i = 0; i <= 100; ++i) {
    // Comes down from 20 mm, stays from 1 s to 2 s with a force that swells to 1.5 N, goes up again.
    const double t = 0.03 * i;
    const double gap = 0.02 * std::max({1.0 - t, 0.0, t - 2.0});
    log.take(at(t, gap, gap > 0.0 ? 0.0 : 1.5 - 2.0 * std::abs(t - 1.5)), nameOf);
  }
  ASSERT_EQ(kinds(log),
            (std::vector{Kind::kNearMissBegan, Kind::kContactBegan, Kind::kContactEnded, Kind::kNearMissEnded}));
  const ContactEvent& ended = log.events()[2];
  EXPECT_NEAR(ended.time_s, 2.0, 0.031);
  EXPECT_NEAR(ended.duration_s, 1.0, 0.061);
  EXPECT_NEAR(ended.force_n, 1.5, 0.05);
  EXPECT_EQ(ended.distance, 0.0);
  EXPECT_EQ(log.events()[0].moved, "part");
}

TEST(ContactLog, AContactThatIsLostForAMomentGoesOn) {
  ContactLog log;
  for (int i = 0; i < 60; ++i) log.take(at(0.02 * i, i % 4 == 3 ? 0.001 : 0.0), nameOf);
  EXPECT_EQ(kinds(log), (std::vector{Kind::kNearMissBegan, Kind::kContactBegan}));
}

TEST(ContactLog, LettingGoEndsAllAtOnce) {
  ContactLog log;
  log.take(at(1.0, 0.0, 1.0), nameOf);
  manipulation::SceneSnapshot released;
  released.time_s = 1.02;
  log.take(released, nameOf);
  EXPECT_EQ(kinds(log).back(), Kind::kNearMissEnded);
  EXPECT_EQ(log.events().size(), 4u);
}

TEST(ContactLog, TheSameSnapshotTwiceIsOneAndAnOlderOneIsANewLoop) {
  ContactLog log;
  log.take(at(5.0, 0.0), nameOf);
  log.take(at(5.0, 0.0), nameOf);
  EXPECT_EQ(log.count(), 2u);
  log.take(at(0.1, 0.0), nameOf);
  EXPECT_EQ(log.count(), 6u) << "what lasted ended with the old loop, and begins in the new one";
}

TEST(ContactLog, TheTableHasOneLineAnEventAndQuotesNames) {
  ContactLog log;
  log.take(at(1.25, 0.0, 0.75), nameOf);
  std::istringstream lines(log.csv());
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line, "t,event,moved,against,distance,force,duration");
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line, "1.250,near_miss_began,part,\"jig, \"\"left\"\"\",0.000000,0.750,0.000");
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line, "1.250,contact_began,part,\"jig, \"\"left\"\"\",0.000000,0.750,0.000");
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(ContactLog, TheOldestGoWhenThereAreTooManyAndThatIsTold) {
  ContactLog log;
  for (std::size_t i = 0; i < ContactLog::kMost; ++i) {
    log.take(at(static_cast<double>(i), 0.0), nameOf);
    manipulation::SceneSnapshot released;
    released.time_s = static_cast<double>(i) + 0.5;
    log.take(released, nameOf);
  }
  EXPECT_EQ(log.events().size(), ContactLog::kMost);
  EXPECT_EQ(log.dropped(), 3 * ContactLog::kMost);
}

}  // namespace
}  // namespace hapticell::app
