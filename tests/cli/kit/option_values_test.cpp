// SPDX-License-Identifier: Apache-2.0
// The readers of what options take: addresses, arguments of a xacro, entities, durations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "cli/kit/motion_options.h"
#include "cli/kit/timing.h"
#include "cli/kit/value_kind.h"
#include "cli/kit/workcell_arguments.h"
#include "cli/kit/xacro_arguments.h"
#include "tests/cli/kit/kept_words.h"
#include "tests/support/test_data.h"

namespace hapticell::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;

TEST(XacroArguments, EachBeginsBehindACommaAndMayHoldCommas) {
  const FileWithArguments read = splitXacroArguments("some,arm.xacro,prefix:=left_,size:=1,2,url:=a:=b,empty:=");
  EXPECT_EQ(read.file, "some,arm.xacro");
  const std::map<std::string, std::string> wanted{{"prefix", "left_"}, {"size", "1,2"}, {"url", "a:=b"}, {"empty", ""}};
  EXPECT_EQ(read.arguments, wanted);
  EXPECT_THAT(splitXacroArguments("arm.urdf").arguments, IsEmpty());
  EXPECT_EQ(splitXacroArguments("a:=b.xacro").file, "a:=b.xacro") << "no argument comes first";
}

TEST(XacroArguments, AFileOfTheWholeNameComesFirst) {
  const hapticell::test::TemporaryFolder folder;
  const std::string name = folder.write("arm.xacro,size:=2", "").string();
  EXPECT_EQ(splitXacroArguments(name).file, name);
  EXPECT_THAT(splitXacroArguments(name).arguments, IsEmpty());
  EXPECT_EQ(splitXacroArguments(name + "1").arguments.at("size"), "21");
}

TEST(XacroArguments, WordsWithoutANameAreRefused) {
  const auto read = parseXacroArguments({"prefix:=left_", "mode:="});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->at("prefix"), "left_");
  EXPECT_EQ(read->at("mode"), "");
  for (const char* bad : {"prefix", ":=left", "", "prefix=left"}) {
    const auto refused = parseXacroArguments({"a:=b", bad});
    ASSERT_FALSE(refused) << bad;
    EXPECT_THAT(refused.error().message(), HasSubstr("NAME:=VALUE"));
  }
}

TEST(WorkcellArguments, WhatMayHoldCommas) {
  const auto addition = parseAddition("odd,name.stl,name=a,b,unit=in,pose=1,0,0,1,0,0,0");
  ASSERT_TRUE(addition.has_value());
  EXPECT_EQ(addition->what, "odd,name.stl");
  EXPECT_EQ(addition->name, "a,b");
  EXPECT_DOUBLE_EQ(addition->options.metres_per_unit.value_or(0.0), 0.0254);
  EXPECT_EQ(addition->X_WE.p.x, 1.0);
  EXPECT_FALSE(parseAddition(",name=a").has_value());
}

TEST(WorkcellArguments, ChecksHaveTwoSides) {
  const auto set = parseCheck("a+b c:d,safety=0");
  ASSERT_TRUE(set.has_value());
  EXPECT_THAT(set->first, ElementsAre("a", "b c"));
  EXPECT_THAT(set->second, ElementsAre("d"));
  EXPECT_EQ(set->safety_distance, 0.0);
  EXPECT_EQ(set->near_miss, workcell::PairSet{}.near_miss);
  EXPECT_THAT(parseCheck("a:")->second, IsEmpty()) << "everything";
}

TEST(WorkcellArguments, AMountingHasALinkAndAPose) {
  // A quaternion typed with three digits is made one of length 1.
  const auto mounting = parseMounting("--on", "rail.urdf,length:=3,link=carriage,pose=0,0,0.5,0.707,0,0,0.707");
  ASSERT_TRUE(mounting);
  EXPECT_EQ(mounting->what, "rail.urdf,length:=3");
  EXPECT_EQ(mounting->link, "carriage");
  EXPECT_NEAR(glm::length(mounting->X_LE.q), 1.0, 1e-12);
  EXPECT_NEAR((mounting->X_LE * dvec3(1.0, 0.0, 0.0)).y, 1.0, 1e-12) << "a quarter turn";
  EXPECT_EQ(mounting->X_LE.p, dvec3(0.0, 0.0, 0.5));
}

TEST(WorkcellArguments, AnErrorNamesTheWrongPart) {
  const std::pair<const char*, std::vector<std::string>> additions[] = {
      {"a.stl,name=x,name=y", {"--add, name", "at most once"}},
      {"a.stl,unit=ell", {"--add, unit", "'ell'"}},
      {"a.stl,up=w", {"--add, up", "x, y or z"}},
      {"a.stl,tree=cut", {"--add, tree", "keep or merge"}},
      {"a.stl,chord=0", {"--add, chord", "1e-9 to 1000"}},
      {"a.stl,angle=4", {"--add, angle", "0.001 to 3"}},
      {"a.stl,colour=red", {"no option is named 'colour'", "tree"}},
      {"a.stl,pose=0,0,0,0,0,0,0", {"--add, pose", "length 1"}}};
  for (const auto& [text, parts] : additions) {
    const auto addition = parseAddition(text);
    ASSERT_FALSE(addition) << text;
    for (const std::string& part : parts) EXPECT_THAT(addition.error().message(), HasSubstr(part)) << text;
  }
  const std::pair<const char*, const char*> checks[] = {{"a", "one colon"},
                                                        {"a:b:c", "one colon"},
                                                        {":", "one colon"},
                                                        {"a+b:b", "one side only"},
                                                        {"a:b,safety=1.5", "--check, safety"},
                                                        {"a:b,near_miss=nan", "--check, near_miss"},
                                                        {"a:b,safety=0,safety=1", "at most once"}};
  for (const auto& [text, part] : checks) {
    const auto set = parseCheck(text);
    ASSERT_FALSE(set) << text;
    EXPECT_THAT(set.error().message(), HasSubstr(part)) << text;
  }
  for (const char* bad : {",link=a", "rail.urdf,link=a,link=b", "rail.urdf,pose=1,2,3"}) {
    const auto mounting = parseMounting("--part-on", bad);
    ASSERT_FALSE(mounting) << bad;
    EXPECT_THAT(mounting.error().message(), HasSubstr("--part-on"));
  }
}

TEST(Timing, GivesTheNearestRanks) {
  Timing timing;
  const nlohmann::ordered_json none = timing.toJson();
  for (const char* name : {"median_us", "p99_us", "max_us"}) EXPECT_EQ(none[name], 0.0);
  std::vector<double> durations;
  std::mt19937 random(3);
  for (int i = 0; i < 997; ++i) durations.push_back(std::uniform_real_distribution<double>(0.0, 50.0)(random));
  for (const double duration : durations) timing.addMicroseconds(duration);
  // The least value with at least this share of all at or below it.
  const auto rank = [&](double share) {
    double least = 1e9;
    for (const double candidate : durations) {
      const auto below = std::count_if(durations.begin(), durations.end(), [=](double d) { return d <= candidate; });
      if (static_cast<double>(below) >= share * static_cast<double>(durations.size())) least = std::min(least, candidate);
    }
    return least;
  };
  EXPECT_EQ(timing.toJson()["median_us"], rank(0.5));
  EXPECT_EQ(timing.toJson()["p99_us"], rank(0.99));
  EXPECT_EQ(timing.toJson()["max_us"], *std::max_element(durations.begin(), durations.end()));
}

TEST(ValueKinds, EachIsListedOnceAndItsEndingsHaveNoDot) {
  std::set<ValueKind> kinds;
  std::set<std::string_view> words_so_far;
  for (const ValueWords& words : valueKinds()) {
    EXPECT_TRUE(kinds.insert(words.kind).second) << words.word;
    EXPECT_EQ(&wordsOf(words.kind), &words);
    EXPECT_TRUE(words_so_far.insert(words.word).second) << words.word << ": completion knows a kind by its word";
    for (const char c : words.word) EXPECT_TRUE(c >= 'A' && c <= 'Z') << words.word;
    for (const std::string_view ending : words.endings)
      for (const char c : ending) EXPECT_TRUE((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) << ending;
  }
  EXPECT_TRUE(kinds.contains(ValueKind::kPicture)) << "the last one";
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(ValueKind::kPicture) + 1) << "one of them is not listed";
}

TEST(ValueKinds, AModelIsWhateverAMeshOrARobotIs) {
  const auto& models = wordsOf(ValueKind::kModel).endings;
  EXPECT_THAT(models, IsSupersetOf(wordsOf(ValueKind::kMesh).endings));
  EXPECT_THAT(models, IsSupersetOf(wordsOf(ValueKind::kRobot).endings));
  EXPECT_TRUE(wordsOf(ValueKind::kModel).from_library);
}

TEST(MotionOptions, AreReadAndChecked) {
  std::string up, markers;
  const auto add = [&](CLI::App& app) { addMotionReading(Subcommand(app).add("do", ""), up, markers); };
  CLI::App app;
  add(app);
  app.parse(std::vector<std::string>{"own.toml", "--markers", "--up=-z", "do"});
  EXPECT_EQ(markers, "own.toml");
  const auto reading = motionReading(up, markers);
  ASSERT_TRUE(reading);
  EXPECT_EQ(mannequin::nameOf(reading->up.value()), "-z");
  EXPECT_EQ(reading->markers, "own.toml");
  EXPECT_FALSE(motionReading("", "")->up) << "to be found from the motion";
  const auto refused = motionReading("w", "");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("'w'"));
}

TEST(MotionOptions, TheReportSaysHowAFileWasRead) {
  mannequin::RecordedMotion motion;
  motion.up = mannequin::UpAxis::kY;
  nlohmann::ordered_json skeleton, marked;
  addReading(motion, skeleton);
  EXPECT_EQ(skeleton["up"], "y");
  EXPECT_FALSE(skeleton.contains("marker_set"));
  EXPECT_EQ(skeleton["assumptions"], nlohmann::ordered_json::array()) << "a list even if nothing was assumed";
  motion.marker_set = "Plug-in Gait";
  motion.assumptions = {Text("a"), Text("b %1", 2)};
  addReading(motion, marked);
  EXPECT_EQ(marked["marker_set"], "Plug-in Gait");
  EXPECT_EQ(marked["assumptions"], nlohmann::ordered_json({"a", "b 2"}));
}

}  // namespace
}  // namespace hapticell::cli
