// SPDX-License-Identifier: Apache-2.0
// What the commands below ergonomics take, read and report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cli/ergonomics/ergonomics_advice_report.h"
#include "cli/ergonomics/ergonomics_commands.h"
#include "cli/ergonomics/ergonomics_input.h"
#include "cli/ergonomics/ergonomics_posture_input.h"
#include "cli/ergonomics/ergonomics_report.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

using nlohmann::json;
using Ordered = nlohmann::ordered_json;  // What reports are made of: it compares the order too.
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ErgonomicsCommand, TakesItsWords) {
  test::expectRefusals({addErgonomicsCommand},
                       {{{"ergonomics"}, "subcommand is required"},
                        {{"ergonomics", "rula", "--input", "{}"}, ""},
                        {{"ergonomics", "eaws"}, "--input is required"},
                        {{"ergonomics", "posture", "--language", "de"}, "--language"},
                        {{"ergonomics", "workplace"}, "--station is required"},
                        {{"ergonomics", "workplace", "--station", "table", "--rise", "0,0.1"}, "--rise"}});
  EXPECT_THAT(test::OneCommand({addErgonomicsCommand}).below("ergonomics"),
              ::testing::UnorderedElementsAre("posture", "en1005", "iso11226", "eaws", "workplace", "rula", "reba",
                                              "owas", "niosh"));
  test::OneCommand command({addErgonomicsCommand});
  EXPECT_THAT(command.error({"ergonomics", "owas", "--input", R"({"code": "2181"})"}), HasSubstr("code"));
}

TEST(ErgonomicsInput, IsTextInPlaceOrAFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(*readErgonomicsInput(" {\"code\": 1}"), json({{"code", 1}}));
  EXPECT_EQ(*readErgonomicsInput(folder.write("in.json", "{\"code\": 2}").string()), json({{"code", 2}}));
  EXPECT_THAT(readErgonomicsInput("{\"code\": ").error().message(), HasSubstr("--input"));
  EXPECT_THAT(readErgonomicsInput((folder.path() / "none.json").string()).error().message(), HasSubstr("none.json"));
  EXPECT_FALSE(readErgonomicsInput(std::string(100000, '['))) << "nested without end";
  EXPECT_EQ(shortText(json(std::string(200, 'a'))).size(), 60U);
  EXPECT_EQ(shortText(json(1.5)), "1.5");
}

TEST(ErgonomicsInput, RefusesByTheNameOfTheField) {
  const auto message = [](const auto& read) { return read ? std::string() : read.error().message(); };
  const json scores{{"neck", 1}, {"trunk", 2}, {"legs", 2}, {"upper_arm", 2}, {"lower_arm", 1}, {"wrist", 1}};
  const auto with = [&](const char* name, const json& value) {
    json changed = scores;
    changed[name] = value;
    return json{{"scores", changed}};
  };
  EXPECT_EQ(message(rebaInput({{"scores", scores}, {"load", 2}})), "");
  EXPECT_THAT(message(rebaInput(with("neck", 2.5))), HasSubstr("neck"));
  EXPECT_THAT(message(rebaInput(with("neck", true))), HasSubstr("neck"));
  EXPECT_THAT(message(rebaInput(with("nek", 1))), HasSubstr("nek"));
  EXPECT_THAT(message(rebaInput({{"scores", scores}, {"angles", json::object()}})), HasSubstr("both are given"));
  EXPECT_THAT(message(rulaInput(json::object())), HasSubstr("neither is given"));
  EXPECT_THAT(message(rulaInput({{"angles", {{"trunk_flexion", 400}}}})), HasSubstr("trunk_flexion"));
  EXPECT_THAT(message(rulaInput({{"angles", {{"wrist_twist", "left"}}}})), HasSubstr("wrist_twist"));
  EXPECT_THAT(message(owasInput({{"code", "2181"}})), HasSubstr("legs"));
  EXPECT_THAT(message(owasInput({{"code", 215}})), HasSubstr("code"));
}

// Hignett and McAtamney, "Rapid Entire Body Assessment (REBA)", 2000: table A has 3 for trunk 2, neck 1, legs 2.
TEST(ErgonomicsReport, GivesScoresWithTheirReasons) {
  const auto input =
      rebaInput({{"scores", {{"neck", 1}, {"trunk", 2}, {"legs", 2}, {"upper_arm", 2}, {"lower_arm", 1}, {"wrist", 1}}},
                 {"load", 2},
                 {"coupling", 0},
                 {"activity", 0}});
  ASSERT_TRUE(input);
  const auto report = scoredReport(ergonomics::Reba(), *input);
  EXPECT_EQ(report["score_a"], 3 + 2);
  EXPECT_EQ(report["score_b"], 1);
  EXPECT_EQ(report["score"], 4);
  EXPECT_FALSE(report["partial"].get<bool>());
  EXPECT_EQ(report["score_range"], Ordered::array({4, 4}));
  for (const auto& driver : report["drivers"]) EXPECT_LT(driver["score"], report["score"]) << driver;
  const auto partial = scoredReport(ergonomics::Reba(), *rebaInput({{"scores", {{"neck", 1}}}}));
  EXPECT_TRUE(partial["score"].is_null());
  EXPECT_TRUE(partial["partial"].get<bool>());
  EXPECT_THAT(partial["missing"].get<std::vector<std::string>>(), ::testing::Contains("trunk"));
  const auto owas = scoredReport(ergonomics::Owas(), *owasInput({{"code", "4141"}}));
  EXPECT_EQ(owas["score"], 4);
  EXPECT_EQ(owas["sub_scores"], Ordered({{"back", 4}, {"arms", 1}, {"legs", 4}, {"load", 1}}));
}

const json kLift{{"load_kg", 10},          {"h_cm", 40},      {"v_cm", 30},        {"d_cm", 70}, {"asymmetry_deg", 30},
                 {"frequency_per_min", 2}, {"duration_h", 2}, {"coupling", "poor"}};

TEST(ErgonomicsReport, OfALiftIsTheRevisedEquation) {
  const auto input = liftingInput(kLift);
  ASSERT_TRUE(input);
  EXPECT_FALSE(input->is_composite);
  const auto result = ergonomics::lift(input->tasks[0], input->conditions);
  ASSERT_TRUE(result);
  const auto report = liftingReport(input->tasks[0], *result);
  // 1 to 2 hours, 2 a minute: FM 0.84; poor coupling below 75 cm: CM 0.90.
  const double limit =
      23.0 * 25.0 / 40.0 * (1.0 - 0.003 * 45.0) * (0.82 + 4.5 / 70.0) * (1.0 - 0.0032 * 30.0) * 0.84 * 0.9;
  EXPECT_NEAR(report["recommended_weight_limit_kg"].get<double>(), limit, 1e-9);
  EXPECT_NEAR(report["score"].get<double>(), 10.0 / limit, 1e-9);
  EXPECT_EQ(report["inputs"]["coupling"], "poor");
  json again = json::object();
  for (const auto& [name, value] : report["inputs"].items()) again[name] = json::parse(value.dump());
  EXPECT_NEAR(ergonomics::lift(liftingInput(again)->tasks[0])->recommended_weight_limit_kg, limit, 1e-9)
      << "the inputs of a report are an input";
  ASSERT_FALSE(report["next_level"].is_null());
  for (const auto& change : report["next_level"]["any_of"])
    EXPECT_LE(change["lifting_index"].get<double>(), 1.0 + 1e-9);
}

TEST(ErgonomicsReport, OfSeveralLiftsNamesTheTask) {
  json light = kLift;
  light["load_kg"] = 5;
  const auto input = liftingInput({{"tasks", {light, kLift}}});
  ASSERT_TRUE(input);
  EXPECT_TRUE(input->is_composite);
  const auto result = ergonomics::compositeLift(input->tasks, input->conditions);
  ASSERT_TRUE(result);
  const auto report = compositeReport(*input, *result);
  EXPECT_EQ(report["order"], Ordered::array({2, 1})) << "the heavier one first, counted from 1";
  ASSERT_EQ(report["tasks"].size(), 2U);
  EXPECT_GE(report["score"].get<double>(), report["tasks"][1]["frequency_independent_index"].get<double>());
  json bad = kLift;
  bad["h_cm"] = -1;
  EXPECT_THAT(liftingInput({{"tasks", {kLift, bad}}}).error().message(), HasSubstr("task 2, h_cm"));
  EXPECT_THAT(liftingInput({{"load_kg", 3}}).error().message(), HasSubstr("h_cm"));
  EXPECT_THAT(liftingInput({{"tasks", json::array()}}).error().message(), HasSubstr("tasks"));
  json one_handed = kLift;
  one_handed["one_handed"] = "yes";
  EXPECT_THAT(liftingInput(one_handed).error().message(), HasSubstr("one_handed"));
}

TEST(PostureInput, ZonesNameWhatIsMissing) {
  const json angles{{"trunk_flexion", 30},
                    {"trunk_twist", 0},
                    {"trunk_side_bend", 0},
                    {"upper_arm_flexion", 15},
                    {"gaze_below_horizontal", 10}};
  const auto zones = zonesReport("en1005", angles);
  ASSERT_TRUE(zones);
  EXPECT_EQ((*zones)["level"], 2) << "EN 1005-4: 20 to 60 degrees";
  json held = angles;
  held["static"] = true;
  EXPECT_EQ((*zonesReport("en1005", held))["level"], 3) << "held there without support";
  EXPECT_THAT(zonesReport("iso11226", held).error().message(), HasSubstr("head_inclination"));
  held["trunk"] = 1;
  EXPECT_THAT(zonesReport("en1005", held).error().message(), HasSubstr("trunk"));
  EXPECT_THAT(zonesReport("en1005", json::array()).error().message(), HasSubstr("object"));
}

TEST(PostureInput, EawsSharesAreAtMostOneInAll) {
  const auto points = eawsReport({{"stand_bent", 0.05}, {"sit_upright", 0.5}});
  ASSERT_TRUE(points);
  EXPECT_NEAR((*points)["score"].get<double>(), 6.0, 1e-9) << "the form's lines 3 and 8";
  EXPECT_FALSE((*points)["complete"].get<bool>());
  EXPECT_THAT(eawsReport({{"lie", 0.7}, {"sit_bent", 0.7}}).error().message(), HasSubstr("shares"));
  EXPECT_THAT(eawsReport({{"sitting", 1}}).error().message(), HasSubstr("sitting"));
  EXPECT_THAT(eawsReport({{"lie", -0.1}}).error().message(), HasSubstr("lie"));
}

TEST(PostureInput, ATaskIsReadAsInDocuments) {
  const auto task = workTaskInput(json::object());
  ASSERT_TRUE(task) << task.error().message();
  EXPECT_EQ(task->name, "Task");
  EXPECT_FALSE(workTaskInput({{"lode", 3}})) << "no field is called so";
  EXPECT_FALSE(workTaskInput(json::array()));
  const test::TemporaryFolder folder;
  EXPECT_THAT(bestPlaceIn(folder.path() / "none.json").error().message(), HasSubstr("none.json"));
  EXPECT_FALSE(bestPlaceIn(folder.write("other.json", "{}"))) << "no placement in it";
}

TEST(AdviceReport, ChangesAreInTheWordsOfTheInput) {
  const ergonomics::FieldChange flag{"static", true, 1.0, 0.0};
  EXPECT_EQ(toJson(flag), Ordered({{"input", "static"}, {"from", true}, {"to", false}}));
  const ergonomics::LiftingChange coupling{"coupling", 2.0, 0.0, {}};
  EXPECT_EQ(toJson(coupling),
            Ordered({{"input", "coupling"}, {"from", "poor"}, {"to", "good"}, {"lifting_index", nullptr}}));
  const ergonomics::LiftingChange nearer{"h_cm", 40.0, 25.0, 0.9};
  EXPECT_EQ(toJson(nearer), Ordered({{"input", "h_cm"}, {"from", 40.0}, {"to", 25.0}, {"lifting_index", 0.9}}));
  const auto places = toJson(ergonomics::BetterPlaces{});
  EXPECT_EQ(places.size(), ergonomics::kPostureMethods.size());
  for (const auto& place : places) EXPECT_TRUE(place.is_null());
}

TEST(AdviceReport, ForcesThatWereNotEnteredAreMissing) {
  ergonomics::HandForces forces;
  forces.force_n[1] = 30.0;
  forces.limits = {{"own", 1, 30.0, 40.0, 2, 28.0}, {"RULA", 1, 30.0, 98.1, 1, 19.6}};
  forces.missing = {"load_left"};
  const auto report = handForcesReport(forces);
  EXPECT_TRUE(report["left"]["force_n"].is_null());
  EXPECT_EQ(report["right"]["force_n"], 30.0);
  EXPECT_TRUE(report["partial"].get<bool>());
  EXPECT_EQ(report["limits"][0]["share"], 0.75);
  EXPECT_EQ(report["limits"][1]["next_class_n"], 98.1);
  ASSERT_EQ(report["drivers"].size(), 1U) << "those in the highest class only";
  EXPECT_EQ(report["drivers"][0]["lower_class_n"], 28.0);
}

}  // namespace
}  // namespace hapticell::cli
