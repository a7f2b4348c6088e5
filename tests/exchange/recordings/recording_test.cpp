// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/recording.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "exchange/mcap/mcap_reader.h"
#include "exchange/mcap/mcap_writer.h"
#include "exchange/messages/ros_messages.h"
#include "exchange/recordings/message_decoding.h"
#include "exchange/recordings/recording_check.h"
#include "exchange/recordings/recording_reader.h"
#include "exchange/recordings/recording_topics.h"
#include "exchange/recordings/recording_writer.h"
#include "exchange/recordings/trace_table.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::exchange {
namespace {

namespace fs = std::filesystem;

trajectory::Trajectory sampleMotion(const std::string& entity) {
  trajectory::Trajectory motion;
  motion.name = "weld \"1\"";
  motion.entity = entity;
  motion.moved = "tcp";
  motion.take = "today";
  motion.joint_names = {"A1", "A2"};
  motion.channel_names = {"force_x", "force_y", "force_z", "contact"};
  motion.touches = {{0.01, 0.02, entity + "/hand", "fixture", 3.5}};
  for (int i = 0; i < 50; ++i) {
    const double joints[] = {0.1 * i / 3.0, -1e-17 * i}, channels[] = {0.1 * i, 1.0 / 3.0, -1.0 * i, 1.0 * (i % 2)};
    trajectory::Trajectory::Frame frame;
    frame.t = -0.01 + i / 1000.0;
    frame.X_WT = {{i / 7.0, 1.0, -2.0}, quaternionFromRotationVector({0.1 * i, 0.2, 0.3})};
    frame.by_hand = i == 7;
    frame.dwell = i == 9 ? 0.25 : 0.0;
    frame.is_pose_apart = i > 40;
    if (i == 9) frame.name = std::make_shared<const std::string>("above the clamp");
    EXPECT_TRUE(motion.addFrame(frame, joints, channels));
  }
  return motion;
}

Recording sampleRecording() {
  Recording recording;
  recording.motions = {sampleMotion("robot"), sampleMotion("gripper")};
  recording.has_moved_frame = true;
  for (int i = 0; i < 300; ++i) {
    StylusSample sample;
    sample.t = i / 1000.0;
    sample.X_DS = {{0.001 * i, 0.0, 1.0 / 3.0}, quaternionFromRotationVector({0.01 * i, 0.0, 0.0})};
    sample.X_DP = sample.X_DS;
    sample.force_D = {0.0, 0.1 * i, -0.2};
    sample.buttons = i > 100 ? 1u : 4u;
    sample.contact = i > 200;
    sample.X_WM = sample.X_DS;
    recording.stylus.push_back(sample);
  }
  recording.contacts = {{0.2, 0.3, "robot/link_1", "table", 7.5}};
  trajectory::TrainingSession training{"kim", "peg", {}};
  training.attempts.push_back({"2026-01-02T10:00:00Z", 0.8, true, {}, trajectory::RunKind::kRetention, ""});
  training.attempts.back().score.points = 71.25;
  recording.trainings = {training};
  recording.files = {{"session.json", "{}\n"}};
  return recording;
}

class RecordingFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("hmcap-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(RecordingFiles, ComeBackWithEveryNumber) {
  const Recording wanted = sampleRecording();
  const auto written = writeMcapRecording(wanted, folder_ / "a.mcap");
  ASSERT_TRUE(written) << written.error().message();
  const auto read = readMcapRecording(folder_ / "a.mcap");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->motions.size(), 2u);
  const auto& motion = read->motions[1];
  EXPECT_EQ(motion.entity, "gripper");
  EXPECT_EQ(motion.size(), 50u);
  EXPECT_NEAR(motion[3].t, -0.007, 1e-9);
  EXPECT_EQ(motion[9].nameText(), "above the clamp");
  EXPECT_EQ(motion.channels(5)[1], 1.0 / 3.0);
  EXPECT_EQ(motion.joints(4)[0], wanted.motions[1].joints(4)[0]);
  EXPECT_EQ(read->stylus.at(299).force_D, wanted.stylus[299].force_D);
  EXPECT_EQ(read->stylus.at(0).buttons, 4u);
  EXPECT_EQ(read->trainings.at(0).attempts.at(0).score.points, 71.25);
  EXPECT_TRUE(isMcapFile("A.MCAP"));
}

TEST_F(RecordingFiles, CheckFindsOneChangedNumber) {
  Recording wanted = sampleRecording();
  ASSERT_TRUE(writeMcapRecording(wanted, folder_ / "a.mcap"));
  ASSERT_TRUE(checkRecording(wanted, folder_ / "a.mcap"));
  wanted.stylus[17].force_D.y += 1e-12;
  EXPECT_FALSE(checkRecording(wanted, folder_ / "a.mcap"));
  wanted = sampleRecording();
  wanted.contacts[0].max_force = 7.4;
  EXPECT_FALSE(checkRecording(wanted, folder_ / "a.mcap"));
}

TEST_F(RecordingFiles, SameRecordingGivesSameBytes) {
  EXPECT_EQ(mcapBytes(sampleRecording()).value(), mcapBytes(sampleRecording()).value());
}

TEST_F(RecordingFiles, NothingToWriteIsAnError) {
  EXPECT_FALSE(mcapBytes({}));
  Recording close;
  close.motions.resize(1);
  close.motions[0].addFrame({0.1, {}});
  close.motions[0].addFrame({0.1 + 1e-11, {}});
  EXPECT_FALSE(mcapBytes(close));
}

/// A file as a robot's logger writes it: times of a clock, several topics.
std::string foreignFile(bool two_topics) {
  std::string bytes;
  McapWriter writer([&](std::string_view more) -> Expected<void> {
    bytes += more;
    return {};
  });
  const auto joints = writer.addSchema({"sensor_msgs/msg/JointState", "ros2msg", rosDefinition("sensor_msgs/msg/JointState")});
  const auto first = writer.addChannel({joints, "/arm/joint_states", "cdr", {}});
  const auto second = writer.addChannel({joints, "/hand/joint_states", "cdr", {}});
  for (int i = 0; i < 20; ++i) {
    const std::int64_t time = 1'700'000'000'000'000'000 + 10'000'000 * i;
    const RosJointState state{{time, ""}, {"a", "b"}, {0.1 * i, 0.2 * i}, {}, {}};
    writer.write(first, static_cast<std::uint64_t>(time), toCdr(state));
    if (two_topics) writer.write(second, static_cast<std::uint64_t>(time), toCdr(state));
  }
  EXPECT_TRUE(writer.finish().has_value());
  return bytes;
}

TEST_F(RecordingFiles, MotionOfAnotherProgramIsRead) {
  const auto read = parseMcapRecording(foreignFile(false), "arm.mcap");
  ASSERT_TRUE(read) << read.error().message();
  const auto& motion = read->motions.at(0);
  EXPECT_EQ(motion.joint_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_FALSE(motion.has_poses);
  ASSERT_EQ(motion.size(), 20u);
  EXPECT_NEAR(motion[19].t, 0.19, 1e-12);
  EXPECT_EQ(motion.joints(19)[1], 0.2 * 19);
}

TEST_F(RecordingFiles, TopicHasToBeChosenAmongSeveral) {
  const std::string bytes = foreignFile(true);
  const auto refused = parseMcapRecording(bytes, "arm.mcap");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("/hand/joint_states"), std::string::npos);
  EXPECT_TRUE(parseMcapRecording(bytes, "arm.mcap", "/arm/joint_states"));
  EXPECT_FALSE(parseMcapRecording(bytes, "arm.mcap", "/nothing"));
}

TEST_F(RecordingFiles, PosesThatAreNoneAreRefused) {
  EXPECT_FALSE(usablePose({{0, 0, 0}, dquat(0.0, 0.0, 0.0, 0.0)}));
  EXPECT_FALSE(usablePose({{std::nan(""), 0, 0}, dquat(1.0, 0.0, 0.0, 0.0)}));
  EXPECT_TRUE(usablePose({{0, 0, 0}, dquat(1.0005, 0.0, 0.0, 0.0)}));
}

TEST_F(RecordingFiles, TraceOfASessionIsRead) {
  std::ofstream(folder_ / "trace.csv") << "t,x,y,z,qw,qx,qy,qz,proxy_x,proxy_y,proxy_z,fx,fy,fz,button,contact,moved_x,"
                                          "moved_y,moved_z,moved_qw,moved_qx,moved_qy,moved_qz,tx,ty,tz\n"
                                          "0.001,1,2,3,1,0,0,0,4,5,6,7,8,9,1,1,10,11,12,0,1,0,0,13,14,15\n";
  ASSERT_TRUE(isTraceTable(folder_ / "trace.csv"));
  const auto samples = readTraceTable(folder_ / "trace.csv");
  ASSERT_TRUE(samples) << samples.error().message();
  EXPECT_EQ(samples->at(0).force_D, dvec3(7, 8, 9));
  EXPECT_EQ(samples->at(0).torque_D, dvec3(13, 14, 15));
  EXPECT_EQ(samples->at(0).X_WM.p, dvec3(10, 11, 12));
  EXPECT_EQ(topics::nanoseconds(samples->at(0).t), 1'000'000);
}

TEST_F(RecordingFiles, StylusAloneIsAMotion) {
  Recording recording = sampleRecording();
  recording.motions.clear();
  ASSERT_TRUE(writeMcapRecording(recording, folder_ / "s.mcap"));
  std::vector<Text> notes;
  const auto motion = readMcapMotion(folder_ / "s.mcap", {}, &notes);
  ASSERT_TRUE(motion) << motion.error().message();
  EXPECT_EQ(motion->size(), 300u);
  EXPECT_EQ(notes.size(), 1u);
}

TEST_F(RecordingFiles, AllMotionsAreReadAndTheRestIsNamed) {
  const Recording recording = sampleRecording();
  ASSERT_TRUE(writeMcapRecording(recording, folder_ / "all.mcap"));
  std::vector<Text> notes, first_notes;
  const auto all = readMcapMotions(folder_ / "all.mcap", notes);
  const auto first = readMcapMotion(folder_ / "all.mcap", {}, &first_notes);
  ASSERT_TRUE(all && first);
  ASSERT_EQ(all->motions.size(), 2u);
  EXPECT_FALSE(all->is_stylus);
  EXPECT_EQ(trajectory::toJsonText(all->motions[0]), trajectory::toJsonText(*first));
  EXPECT_EQ(all->motions[1].entity, "gripper");
  std::string said;
  for (const Text& note : notes) said += english(note) + "\n";
  EXPECT_EQ(said,
            "samples of the stylus, not read: 300\ncontacts of the session, not read: 1\n"
            "results of training, not read: 1\nattachment, not read: session.json\n");
  ASSERT_EQ(first_notes.size(), 1u);
  EXPECT_EQ(english(first_notes[0]), "motions in the file, of which the first is read: 2");
}

}  // namespace
}  // namespace hapticell::exchange
