// SPDX-License-Identifier: Apache-2.0
#include "agents/task/agent_task.h"

#include <gtest/gtest.h>

#include "agents/task/agent_section.h"
#include "agents/task/section_reader.h"

namespace hapticell::agents {
namespace {

const char* const kTask = R"(
cell = "field.hcell"
entity = "robot"
clearance = 0.004
[goal]
position = [1.0, 2.0, 3.0]
quaternion = [0.0, 1.0, 0.0, 0.0]
angle_tolerance = 10.0
[spread]
start_angle = 5.0
[[agent]]
what = "goal"
weight = 2.0
speed = 0.5
[[agent]]
what = "operator"
enabled = false
)";

TEST(AgentTask, ReadsWhatItsFileSays) {
  const auto task = AgentTask::parse(kTask, "/cells/t.toml");
  ASSERT_TRUE(task) << task.error().message();
  EXPECT_EQ(task->name, "t");
  EXPECT_EQ(task->cell, "/cells/field.hcell");
  EXPECT_EQ(task->goal.p_WG, dvec3(1.0, 2.0, 3.0));
  ASSERT_TRUE(task->goal.q_WG);
  EXPECT_DOUBLE_EQ(task->goal.q_WG->x, 1.0);
  EXPECT_NEAR(task->goal.angle_tolerance, 10.0 * kDegree, 1e-15);
  EXPECT_NEAR(task->spread.start_angle, 5.0 * kDegree, 1e-15);
  EXPECT_DOUBLE_EQ(task->clearance, 0.004);
  ASSERT_EQ(task->agents.size(), 2U);
  EXPECT_EQ(task->agents[0].weight, 2.0);
  EXPECT_FALSE(task->agents[1].enabled);
  const AgentTask copy = *task;  // Its tables outlive the original.
  SectionReader reader(copy.agents[0]);
  double speed = 0.0;
  reader.fields().read("speed", speed);
  EXPECT_TRUE(reader.end());
  EXPECT_EQ(speed, 0.5);
}

TEST(AgentTask, ErrorsNameFileLineAndKey) {
  const auto fault = [](const std::string& from, const std::string& to) {
    std::string text = kTask;
    text.replace(text.find(from), from.size(), to);
    const auto task = AgentTask::parse(text, "/cells/t.toml");
    return task ? std::string("read") : task.error().message();
  };
  EXPECT_NE(fault("clearance = 0.004", "clearence = 0.004").find("clearence"), std::string::npos);
  EXPECT_NE(fault("weight = 2.0", "weight = -2.0").find("line 13"), std::string::npos) << fault("weight = 2.0", "weight = -2.0");
  EXPECT_NE(fault("what = \"operator\"", "what = \"goal\"").find("each agent once"), std::string::npos);
  EXPECT_NE(fault("position = [1.0, 2.0, 3.0]\n", "").find("position"), std::string::npos);
  EXPECT_NE(fault("[goal]", "[goal").find("not TOML"), std::string::npos);
}

TEST(AgentSection, AFaultNamesTheFileAndTheAgent) {
  const auto task = AgentTask::parse(kTask, "/cells/t.toml");
  ASSERT_TRUE(task) << task.error().message();
  const AgentSection& section = task->agents[1];
  EXPECT_EQ(section.kind, "operator");
  EXPECT_EQ(section.weight, 1.0) << "where the file says none";
  const std::string words = section.fault(Text("no hand"), Text("a hand"), Text("Lend one.")).message();
  for (const char* part : {"/cells/t.toml", "operator", "no hand", "a hand", "Lend one."})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in " << words;
}

}  // namespace
}  // namespace hapticell::agents
