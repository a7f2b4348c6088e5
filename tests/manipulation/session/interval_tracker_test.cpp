// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/interval_tracker.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hapticell::manipulation {
namespace {

using Tracker = IntervalTracker<std::string, int>;

/// Notes the data and the two times of each interval that ends.
struct Ended {
  std::vector<int>& data;
  std::vector<double>& times;
  void operator()(const Tracker::Interval& interval) const {
    data.push_back(interval.data);
    times.insert(times.end(), {interval.began, interval.seen});
  }
};

TEST(IntervalTracker, AnIntervalLastsFromTheFirstToTheLastTimeThatItIsSeen) {
  Tracker tracker;
  auto [first, begins] = tracker.see("a", 1.0);
  EXPECT_TRUE(begins);
  EXPECT_EQ(first.data, 0) << "new data";
  first.data = 7;
  for (const double t : {1.1, 1.2}) EXPECT_FALSE(tracker.see("a", t).second);
  std::vector<int> data;
  std::vector<double> times;
  tracker.endOlder(1.25, 0.1, Ended{data, times});
  EXPECT_TRUE(data.empty());
  tracker.endOlder(1.31, 0.1, Ended{data, times});
  EXPECT_EQ(data, std::vector{7});
  EXPECT_EQ(times, (std::vector{1.0, 1.2}));
  EXPECT_TRUE(tracker.see("a", 1.4).second) << "it has ended: the next one begins";
  EXPECT_EQ(tracker.see("a", 1.4).first.data, 0);
}

TEST(IntervalTracker, WhatIsNotSeenForAMomentGoesOn) {
  Tracker tracker;
  tracker.see("a", 0.0);
  tracker.endOlder(0.05, 0.05);
  EXPECT_FALSE(tracker.see("a", 0.05).second) << "just as long as it may be";
  EXPECT_EQ(tracker.see("a", 0.06).first.began, 0.0);
}

TEST(IntervalTracker, KeysAreFollowedEachForItselfAndEndTogetherWhenAsked) {
  Tracker tracker;
  tracker.see("b", 0.0).first.data = 2;
  tracker.see("a", 0.5).first.data = 1;
  tracker.see("a", 2.0);
  std::vector<int> data;
  std::vector<double> times;
  tracker.endOlder(2.0, 0.1, Ended{data, times});
  EXPECT_EQ(data, std::vector{2});
  tracker.see("c", 2.5).first.data = 3;
  tracker.endAll(Ended{data, times});
  EXPECT_EQ(data, (std::vector{2, 1, 3})) << "in the order of the keys";
  EXPECT_EQ(times, (std::vector{0.0, 0.0, 0.5, 2.0, 2.5, 2.5}));
  EXPECT_TRUE(tracker.see("a", 3.0).second);
}

}  // namespace
}  // namespace hapticell::manipulation
