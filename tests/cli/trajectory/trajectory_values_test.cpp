// SPDX-License-Identifier: Apache-2.0
// The parts of the trajectory commands, called directly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "cli/trajectory/motion_file.h"
#include "cli/trajectory/motion_of_robot.h"
#include "cli/trajectory/tool_poses.h"
#include "cli/trajectory/trajectory_check.h"
#include "cli/trajectory/trajectory_command.h"
#include "cli/trajectory/trajectory_edits.h"
#include "cli/trajectory/trajectory_export.h"
#include "cli/trajectory/trajectory_options.h"
#include "cli/trajectory/trajectory_report.h"
#include "cli/trajectory/trajectory_retiming.h"
#include "cli/trajectory/trajectory_robot.h"
#include "cli/trajectory/trajectory_smoothing.h"
#include "tests/cli/kit/kept_words.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::cli {
namespace {

namespace fs = std::filesystem;
using trajectory::Trajectory;
using ::testing::HasSubstr;

/// A turn about z with a tool 0.5 m out: every pose is known.
constexpr const char* kTurner = R"(<robot name="turner"><link name="base"/><link name="tip"/><joint name="turn" type="revolute">
<parent link="base"/><child link="tip"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="2" effort="1"/></joint>
</robot>)";

Trajectory turning(const Pose& X_WB, const Pose& X_LT) {
  Trajectory motion;
  motion.joint_names = {"turn"};
  for (int i = 0; i <= 20; ++i) {
    const double q[] = {0.1 * i};
    Trajectory::Frame frame;
    frame.t = 0.1 * i;
    frame.X_WT = X_WB * Pose{{}, quaternionFromRotationVector({0.0, 0.0, q[0]})} * X_LT;
    EXPECT_TRUE(motion.addFrame(frame, q));
  }
  return motion;
}

class TrajectoryValuesTest : public ::testing::Test {
 protected:
  std::string file(const char* name) const { return (folder_.path() / name).string(); }
  test::TemporaryFolder folder_;
  std::string robot_ = folder_.write("turner.urdf", kTurner).string();
  test::KeptWords kept_;
  const ListenerOfThread listening_{kept_};
};

TEST_F(TrajectoryValuesTest, BaseOrToolIsFoundFromThePoses) {
  const Pose X_WB{{1.0, 2.0, 0.5}, quaternionFromRotationVector({0.3, 0.0, 0.0})}, X_LT = Pose::translation({0.5, 0.0, 0.1});
  for (const Trajectory& motion : {turning({}, {}), turning(X_WB, {}), turning({}, X_LT)}) {
    const auto tool = ToolPoses::create(robot_, motion);
    ASSERT_TRUE(tool) << tool.error().message();
    EXPECT_TRUE(tool->match());
    EXPECT_LT(tool->largestError(motion).position, 1e-9);
    EXPECT_LT(glm::distance(tool->posesOf(motion)[7].X_WT.p, motion[7].X_WT.p), 1e-9);
  }
  EXPECT_FALSE(ToolPoses::create(robot_, turning(X_WB, X_LT))->match()) << "only one of the two";
  Trajectory other = turning({}, {});
  other.joint_names = {"bend"};
  EXPECT_THAT(ToolPoses::create(robot_, other).error().message(), HasSubstr("'bend'"));
}

TEST_F(TrajectoryValuesTest, MissingPosesComeFromTheRobot) {
  Trajectory motion = turning({}, {});
  motion.has_poses = false;
  TrajectoryOptions options;
  std::vector<Text> assumptions;
  EXPECT_FALSE(withRobot(motion, options, assumptions)->tool) << "no robot was given";
  options.limits.robot = robot_;
  const auto with = withRobot(motion, options, assumptions);
  ASSERT_TRUE(with);
  ASSERT_TRUE(with->tool);
  EXPECT_TRUE(with->motion.has_poses);
  EXPECT_EQ(assumptions.size(), 1U);
  const std::string written = folder_.write("bad.htraj", toJsonText(turning({}, Pose::translation({1e-3, 0.0, 0.0})))).string();
  const auto promises = withPosesByJoints(Promises(), with->tool, written);
  ASSERT_TRUE(promises);
  EXPECT_NEAR(promises->list.back().measured, 1e-3, 1e-9) << "measured in the file";
}

TEST_F(TrajectoryValuesTest, LimitsAreGivenOrThoseOfTheRobot) {
  const Trajectory motion = turning({}, {});
  std::vector<Text> assumptions;
  const auto of_robot = limitsFor(motion, {robot_, {}, {}, {}}, assumptions);
  ASSERT_TRUE(of_robot) << of_robot.error().message();
  EXPECT_EQ(of_robot->velocity, std::vector{2.0});
  EXPECT_EQ(of_robot->acceleration, std::vector{8.0}) << "full speed in 0.25 s";
  EXPECT_EQ(assumptions.size(), 1U);
  const auto given = limitsFor(motion, {"", {3.0}, {5.0}, {70.0}}, assumptions);
  ASSERT_TRUE(given);
  EXPECT_EQ(given->jerk, std::vector{70.0});
  EXPECT_EQ(assumptions.size(), 1U);
  EXPECT_THAT(limitsFor(motion, {"", {1.0, 2.0}, {}, {}}, assumptions).error().message(), HasSubstr("--velocity: 2 numbers"));
  EXPECT_THAT(limitsFor(motion, {}, assumptions).error().message(), HasSubstr("--robot or --velocity"));
  trajectory::ProgramOptions program;
  std::vector<Text> notes;
  EXPECT_TRUE(addConfigurations(motion, robot_, trajectory::ProgramFormat::kKrl, program, notes));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_FALSE(program.configuration) << "no six axes";
}

TEST_F(TrajectoryValuesTest, InfoIsOfTheWholeMotion) {
  const Pose X_LT = Pose::translation({0.5, 0.0, 0.0});
  const auto info = trajectoryInfo(turning({}, X_LT), {});
  ASSERT_TRUE(info);
  EXPECT_EQ((*info)["frames"], 21);
  EXPECT_NEAR((*info)["duration"], 2.0, 1e-12);
  EXPECT_NEAR((*info)["rotation"], 2.0, 1e-9);
  EXPECT_NEAR((*info)["length"], 20.0 * std::sin(0.05), 1e-9) << "chords of 0.1 rad, two half metres";
  EXPECT_NEAR((*info)["max_speed"], 10.0 * std::sin(0.05), 1e-9);
  EXPECT_EQ((*info)["poses_apart"], 0);
  EXPECT_EQ(distanceJson({0.5, 0.25}), (nlohmann::ordered_json{{"position", 0.5}, {"angle", 0.25}}));
}

TEST_F(TrajectoryValuesTest, FilesAreWrittenAndReadByTheirExtension) {
  const Trajectory motion = turning({}, Pose::translation({0.5, 0.0, 0.0}));
  for (const char* name : {"a.csv", "a.htraj", "a.json"}) {
    ASSERT_TRUE(saveTrajectory(motion, file(name))) << name;
    const auto read = readMotionFile(file(name));
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->size(), motion.size());
    EXPECT_LT(glm::distance((*read)[13].X_WT.p, motion[13].X_WT.p), 1e-8);
  }
  EXPECT_TRUE(saveTrajectory(motion, ""));
  EXPECT_THAT(saveTrajectory(motion, file("a.txt")).error().message(), HasSubstr(".htraj, .json or .csv"));
  EXPECT_FALSE(fs::exists(file("a.txt")));
  EXPECT_THAT(readMotionFile(file("none.csv")).error().message(), HasSubstr("none.csv"));
  EXPECT_THAT(programReadOptions(robot_).error().message(), HasSubstr("six joints"));
  EXPECT_FALSE(programReadOptions("")->forward_kinematics);
}

TEST_F(TrajectoryValuesTest, ResultsAreMeasuredInTheFile) {
  const Trajectory motion = turning({}, Pose::translation({0.5, 0.0, 0.0}));
  TrajectoryOptions options;
  options.output = file("out.htraj");
  options.tolerance = options.joint_tolerance = 0.01;
  for (const auto make : {&simplifyTrajectory, &smoothTrajectory}) {
    fs::remove(options.output);
    const auto result = make(motion, options);
    ASSERT_TRUE(result) << result.error().message();
    EXPECT_TRUE(result->contains("promised"));
    const auto written = trajectory::readTrajectory(options.output);
    ASSERT_TRUE(written);
    for (std::size_t i = 0; i < motion.size(); ++i)
      EXPECT_LT(glm::distance(written->poseAt(motion[i].t).p, motion[i].X_WT.p), 0.01 + 1e-9);
    options.tolerance = 0.0;
    fs::remove(options.output);
    EXPECT_THAT(make(motion, options).error().message(), HasSubstr("--tolerance"));
    EXPECT_FALSE(fs::exists(options.output));
    options.tolerance = 0.01;
  }
  options.limits.velocity = {4.0};
  options.limits.acceleration = {40.0};
  options.passing = 1e-3;
  options.angle_passing = 2e-3;
  const auto retimed = retimeTrajectory(motion, options);
  ASSERT_TRUE(retimed) << retimed.error().message();
  EXPECT_LE((*retimed)["limit_use"]["velocity"].get<double>(), 1.0 + 1e-6);
  EXPECT_NEAR((*retimed)["duration_after"], 0.6, 0.05) << "2 rad at 4 rad/s, 0.1 s to that speed and back";
  options.mode = "fast";
  EXPECT_THAT(retimeTrajectory(motion, options).error().message(), HasSubstr("--mode"));
  options.to = "basic";
  EXPECT_THAT(exportTrajectory(motion, options).error().message(), HasSubstr("--to"));
  options.to = "csv";
  options.output = file("copy.csv");
  ASSERT_TRUE(exportTrajectory(motion, options));
  EXPECT_EQ(trajectory::readTrajectory(options.output)->size(), motion.size());
}

TEST_F(TrajectoryValuesTest, AFindingIsExitStatusOne) {
  const ResultWriter writer("-");
  EXPECT_EQ(finishTrajectory(writer, nlohmann::ordered_json{{"a", 1}}), ExitStatus::kDone);
  EXPECT_EQ(finishTrajectory(writer, nlohmann::ordered_json{{"found", true}}), ExitStatus::kCheckFound);
  EXPECT_EQ(finishTrajectory(writer, makeError({.found = "wrong"})), ExitStatus::kBadInput);
  EXPECT_EQ(kept_.errors.size(), 1U);
  TrajectoryCheckOptions options;
  options.workcell = "/none.hcell";
  EXPECT_THAT(checkTrajectory(turning({}, {}), options).error().message(), HasSubstr("none.hcell"));
}

TEST(TrajectoryCommands, TakeTheirWords) {
  test::expectRefusals({addTrajectoryCommand},
                       {{{"trajectory"}, "subcommand is required"},
                        {{"trajectory", "split", "a.csv"}, "--at is required"},
                        {{"trajectory", "check", "a.csv"}, "--workcell is required"},
                        {{"trajectory", "insert", "a.csv", "--at", "1", "--pose", "0,0,0,1,0,0,0"}, ""},
                        {{"trajectory", "delete", "a.csv", "--first", "x", "--last", "2"}, "--first"}});
  test::OneCommand command({addTrajectoryCommand});
  EXPECT_THAT(command.error({"trajectory", "trim", "/none.csv"}), HasSubstr("none.csv"));
}

}  // namespace
}  // namespace hapticell::cli
