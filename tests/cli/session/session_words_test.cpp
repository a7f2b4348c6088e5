// SPDX-License-Identifier: Apache-2.0
// Settings, planner and results of the session commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/session/session_commands.h"
#include "cli/session/session_plan.h"
#include "cli/session/session_recording.h"
#include "cli/session/session_report.h"
#include "cli/session/session_settings.h"
#include "manipulation/manipulators/moved_by.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;

TEST(SessionCommands, TakeTheirWords) {
  test::expectRefusals(
      {addSessionCommand, addRecordCommand, addFeelCommand},
      {{{"session", "--workcell", "a.hcell", "--entity", "a"}, "--hand is required"},
       {{"session", "--workcell", "a.hcell", "--entity", "a", "--hand", "h.csv", "--set", "a=1", "--set", "b=2"}, ""},
       {{"session", "--workcell", "a.hcell", "--entity", "a", "--hand", "h.csv", "--live", "65536"}, "--live"},
       {{"record", "--seconds", "0"}, "--seconds"},
       {{"record", "--from", "a.htraj", "-o", "a.mcap", "--rate", "1000"}, ""},
       {{"feel", "--only", "M4", "--full"}, ""},
       {{"feel", "M4"}, "M4"}});
}

TEST(SessionSettings, AreTakenOver) {
  manipulation::SessionOptions options;
  options.pairs.sets.resize(2);
  SessionPlanWords plan;
  for (const char* setting : {"moved_by=right_hand", "lock=trunk", "forces=off", "safety_distance=0.004", "on_contact=stop",
                              "force_class=dynamics", "plan_goal=out", "plan_hints=a.csv", "plan_authority=0.5",
                              "manipulation.rate_hz=250"}) {
    const auto done = applySessionSetting(setting, options, plan);
    EXPECT_TRUE(done) << setting << ": " << done.error().message();
  }
  EXPECT_EQ(manipulation::wordOf(options.moved_by, false), "right_hand");
  ASSERT_NE(manipulation::locksOf(options.moved_by), nullptr);
  EXPECT_TRUE(manipulation::locksOf(options.moved_by)->trunk);
  EXPECT_FALSE(options.forces);
  for (const auto& set : options.pairs.sets) EXPECT_EQ(set.safety_distance, 0.004);
  EXPECT_EQ(options.configuration.manipulation.safety_distance, 0.004);
  EXPECT_EQ(options.on_contact, workcell::OnContact::kStop);
  EXPECT_EQ(options.force_class, workcell::ForceClass::kDynamics);
  EXPECT_EQ(plan.goal, "out");
  EXPECT_EQ(plan.hints, "a.csv");
  EXPECT_EQ(options.configuration.manipulation.plan_authority, 0.5);
  EXPECT_EQ(options.configuration.manipulation.rate_hz, 250.0);
  ASSERT_TRUE(applySessionSetting("moved_by=left_hand", options, plan));
  EXPECT_TRUE(manipulation::locksOf(options.moved_by)->trunk) << "the lock stays";
}

TEST(SessionSettings, AnErrorChangesNothing) {
  manipulation::SessionOptions options;
  SessionPlanWords plan;
  ASSERT_TRUE(applySessionSetting("moved_by=right_hand", options, plan));
  ASSERT_TRUE(applySessionSetting("lock=trunk", options, plan));
  const std::pair<const char*, const char*> cases[] = {{"moved_by", "KEY=VALUE"},
                                                       {"=on", "KEY=VALUE"},
                                                       {"moved_by=tcp", "trunk"},
                                                       {"forces=maybe", "on or off"},
                                                       {"safety_distance=2", "0 to 1"},
                                                       {"safety_distance=0.1m", "0 to 1"},
                                                       {"lock=nose", "nose"},
                                                       {"on_contact=jump", "jump"},
                                                       {"colour=red", "plan_clearance"},
                                                       {"manipulation.rate_hz=fast", "fast"}};
  for (const auto& [setting, part] : cases) {
    const auto refused = applySessionSetting(setting, options, plan);
    ASSERT_FALSE(refused) << setting;
    EXPECT_THAT(refused.error().message(), HasSubstr(part)) << setting;
    EXPECT_EQ(manipulation::wordOf(options.moved_by, false), "right_hand") << setting;
    EXPECT_TRUE(options.forces);
    EXPECT_FALSE(options.on_contact);
    EXPECT_EQ(options.configuration.manipulation.rate_hz, config::Configuration().manipulation.rate_hz);
  }
}

TEST(SessionSettings, DevicesAreThoseThatAreSimulated) {
  for (const char* name : {"phantom_desktop", "touch", "touch_x", "premium", "premium_6dof"})
    EXPECT_TRUE(simulatedDevice(name)) << name;
  const auto none = simulatedDevice("falcon9");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message(), HasSubstr("premium_6dof"));
}

manipulation::SessionOptions cellOptions() {
  manipulation::SessionOptions options;
  workcell::Entity part, fixture;
  part.id = 3;
  part.name = options.entity = "part";
  fixture.id = 4;
  fixture.name = "fixture";
  fixture.X_WE = Pose::translation({1.0, 0.0, 0.0});
  fixture.frames.push_back({"slot", Pose::translation({0.0, 0.0, 0.2})});
  options.entities = {part, fixture};
  return options;
}

TEST(SessionPlan, GoalsAreReadOrRefused) {
  for (const char* goal : {"out", "frame:fixture", "frame:slot", "pose:0,0,0.1,0.707,0,0,0.707"}) {
    auto options = cellOptions();
    const auto added = addPlanner({goal, ""}, false, options);
    EXPECT_TRUE(added) << goal;
    ASSERT_TRUE(options.assistance) << goal;
    EXPECT_EQ(options.assistance->authority, options.configuration.manipulation.plan_authority);
  }
  const std::pair<SessionPlanWords, const char*> cases[] = {{{"frame:table", ""}, "'table'"},
                                                            {{"frame:", ""}, "plan_goal"},
                                                            {{"pose:0,0,0,2,0,0,0", ""}, "length 1"},
                                                            {{"pose:0,0,0", ""}, "plan_goal"},
                                                            {{"pose:0,0,nan,1,0,0,0", ""}, "plan_goal"},
                                                            {{"joints:1,2", ""}, "2 joints"},
                                                            {{"home", ""}, "'home'"},
                                                            {{"", "a.csv"}, "plan_hints"},
                                                            {{"out", "/none.csv"}, "none.csv"}};
  for (const auto& [words, part] : cases) {
    auto options = cellOptions();
    const auto refused = addPlanner(words, false, options);
    ASSERT_FALSE(refused) << part;
    EXPECT_THAT(refused.error().message(), HasSubstr(part));
    EXPECT_FALSE(options.assistance);
  }
  auto options = cellOptions();
  EXPECT_TRUE(addPlanner({}, false, options));
  EXPECT_FALSE(options.assistance) << "nobody asked for one";
}

manipulation::SessionReport touchedReport() {
  manipulation::SessionReport report;
  report.duration_s = 2.0;
  manipulation::ContactInterval contact;
  contact.entity = 3;
  contact.other = 4;
  contact.other_part = "jaw";
  contact.time_in = 0.5;
  contact.time_out = 0.75;
  contact.max_force = 2.5;
  report.contacts = {contact};
  report.limits = {{"at its upper limit", manipulation::LimitKind::kJoint, -1, 0.25, 0.5}};
  report.end.X_WM = Pose::translation({0.0, 0.0, 0.5});
  return report;
}

TEST(SessionReport, NamesWhatTouched) {
  const ordered_json json = sessionJson(touchedReport(), cellOptions());
  EXPECT_EQ(json["entity"], "part");
  EXPECT_EQ(json["contacts"][0]["entities"], ordered_json({"part", "fixture"}));
  EXPECT_EQ(json["contacts"][0]["max_force"], 2.5);
  EXPECT_EQ(json["limits"][0]["kind"], "joint");
  EXPECT_FALSE(json["limits"][0].contains("joint")) << "a solid has no joints";
  EXPECT_EQ(json["final_state"]["moved_frame"]["position"], ordered_json({0.0, 0.0, 0.5}));
  EXPECT_EQ(json["final_state"]["moved_frame"]["quaternion"], ordered_json({1.0, 0.0, 0.0, 0.0}));
  EXPECT_FALSE(json.contains("plan"));
}

TEST(SessionRecording, HasContactsByNameAndNoTimesOfTheMachine) {
  exchange::Recording recording;
  const ordered_json result{{"entity", "part"}, {"timing", {{"machine_time_s", 3.0}}}};
  addSession(recording, touchedReport(), cellOptions(), result);
  EXPECT_TRUE(recording.has_moved_frame);
  EXPECT_TRUE(recording.motions.empty()) << "an empty motion is none";
  ASSERT_EQ(recording.contacts.size(), 1U);
  EXPECT_EQ(recording.contacts[0], (trajectory::Trajectory::Touch{0.5, 0.75, "part", "fixture/jaw", 2.5}));
  ASSERT_EQ(recording.files.size(), 1U);
  EXPECT_EQ(recording.files[0].first, "session.json");
  EXPECT_EQ(ordered_json::parse(recording.files[0].second), (ordered_json{{"entity", "part"}}));
  manipulation::TraceRow row;
  row.t = 0.25;
  row.X_DP.p = dvec3(1.0, 2.0, 3.0);
  row.force_D = dvec3(4.0, 0.0, 0.0);
  row.buttons = 2;
  row.contact = true;
  const exchange::StylusSample wanted{0.25, {}, row.X_DP, row.force_D, {}, 2, true, {}};
  EXPECT_TRUE(stylusSampleOf(row) == wanted);
}

}  // namespace
}  // namespace hapticell::cli
