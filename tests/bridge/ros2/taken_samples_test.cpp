// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/taken_samples.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "bridge/ros2/ros_conversion.h"
#include "tests/bridge/ros2/private_domain.h"

namespace hapticell::bridge {
namespace {

/// A writer and a reader of joint states that found each other; each message carries one number.
struct NumberedJoints {
  PrivateDomain domain;
  std::unique_ptr<RosNode> writing = PrivateDomain::node(), reading = PrivateDomain::node();
  dds_entity_t writer = 0, reader = 0;
  JointStateMessage message{{"x"}};
  std::vector<double> taken;

  explicit NumberedJoints(RosQuality heard) {
    writer = writing->advertise("/numbers", sensor_msgs_msg_dds__JointState__desc, RosQuality::kDefault).value_or(0);
    reader = reading->subscribe("/numbers", sensor_msgs_msg_dds__JointState__desc, heard).value_or(0);
    EXPECT_TRUE(eventually([&] { return writing->readersOf(writer) == 1 && reading->writersOf(reader) == 1; }));
  }
  void write(int first, int count) {
    for (int i = first; i < first + count; ++i) EXPECT_TRUE(writing->write(writer, message.at(i, {1.0 * i})));
  }
  void take() {
    takeAll<sensor_msgs_msg_dds__JointState_>(reader, [this](const auto& state) {
      ASSERT_EQ(state.position._length, 1u);
      EXPECT_EQ(nanosecondsOf(state.header.stamp), static_cast<std::int64_t>(state.position._buffer[0]));
      taken.push_back(state.position._buffer[0]);
    });
  }
};

TEST(TakeAll, GivesHundredsOfSamplesInTheirOrderAndEachOnce) {
  NumberedJoints joints(RosQuality::kSensor);  // Its readers hold 1000.
  joints.take();
  EXPECT_TRUE(joints.taken.empty());
  joints.write(0, 300);  // Not a multiple of what is taken at once.
  EXPECT_TRUE(eventually([&] { return joints.take(), joints.taken.size() >= 300; }));
  joints.write(300, 128);  // A multiple of it.
  EXPECT_TRUE(eventually([&] { return joints.take(), joints.taken.size() >= 428; }));
  joints.take();
  std::vector<double> written(428);
  std::iota(written.begin(), written.end(), 0.0);
  EXPECT_EQ(joints.taken, written);
}

TEST(TakeAll, LeavesOutSamplesThatOnlySayThatAWriterIsGone) {
  NumberedJoints joints(RosQuality::kDefault);
  joints.write(7, 1);
  EXPECT_TRUE(eventually([&] { return joints.take(), joints.taken.size() == 1; }));
  ASSERT_EQ(dds_delete(joints.writer), DDS_RETCODE_OK);
  // DDS by itself: how many samples there are, and whether the first one has data.
  const auto left = [&](bool& has_data) {
    constexpr std::uint32_t kMost = 64;  // As takeAll(): Cyclone DDS 0.10 fills in as many addresses as the reader ever lent.
    void* samples[kMost] = {nullptr};
    dds_sample_info_t infos[kMost];
    const dds_return_t count = dds_read(joints.reader, samples, infos, kMost, kMost);
    has_data = count > 0 && infos[0].valid_data;
    if (count > 0) dds_return_loan(joints.reader, samples, count);
    return count;
  };
  bool has_data = true;
  ASSERT_TRUE(eventually([&] { return left(has_data) == 1; }));
  EXPECT_FALSE(has_data);
  joints.take();
  EXPECT_EQ(joints.taken, std::vector<double>{7.0});
  EXPECT_EQ(left(has_data), 0) << "taken all the same";
}

}  // namespace
}  // namespace hapticell::bridge
