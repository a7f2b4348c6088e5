// SPDX-License-Identifier: Apache-2.0
// What all readers of texts are made of: lines, words, numbers, members of JSON and TOML, references to files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <toml++/toml.h>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/support/test_data.h"
#include "workcell/text/content_rules.h"
#include "workcell/text/field_reader.h"
#include "workcell/text/file_content.h"
#include "workcell/text/package_path.h"
#include "workcell/text/read_record.h"
#include "workcell/text/text_cursor.h"
#include "workcell/text/toml_fields.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> wordsOfLine(TextCursor& cursor) {
  std::vector<std::string> words;
  for (auto word = cursor.nextWord(); !word.empty(); word = cursor.nextWord()) words.emplace_back(word);
  return words;
}

TEST(TextCursor, LinesEndAsOnAnySystemAndKeepTheirNumbers) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "v 1\t2  3 " + end + end + "f 1" + end;
    TextCursor cursor(text);
    ASSERT_TRUE(cursor.nextLine());
    EXPECT_THAT(wordsOfLine(cursor), ElementsAre("v", "1", "2", "3"));
    ASSERT_TRUE(cursor.nextLine());
    EXPECT_EQ(cursor.nextWord(), "");
    ASSERT_TRUE(cursor.nextLine());
    EXPECT_EQ(english(cursor.place()), "line 3");
    EXPECT_EQ(cursor.restOfLine(), "f 1");
    EXPECT_EQ(cursor.nextWord(), "") << "used up";
    EXPECT_FALSE(cursor.nextLine());
  }
}

TEST(TextCursor, ALineGoesOnBehindABackslashButNotARemark) {
  TextCursor cursor("f 1 \\\n2 3\n# remark \\\nv 1", TextCursor::Continuation::kBackslash);
  ASSERT_TRUE(cursor.nextLine());
  EXPECT_THAT(wordsOfLine(cursor), ElementsAre("f", "1", "2", "3"));
  ASSERT_TRUE(cursor.nextLine());
  ASSERT_TRUE(cursor.nextLine());
  EXPECT_THAT(wordsOfLine(cursor), ElementsAre("v", "1"));
}

TEST(TextCursor, WordsAcrossLinesAndBytesLeft) {
  TextCursor cursor("one two\n\n three");
  EXPECT_EQ(cursor.nextWordOfText(), "one");
  EXPECT_EQ(cursor.nextWordOfText(), "two");
  EXPECT_EQ(cursor.nextWordOfText(), "three");
  EXPECT_EQ(cursor.bytesLeft(), 0u);
  EXPECT_EQ(cursor.nextWordOfText(), "");
}

TEST(TextNumbers, AreWholeWordsWithAPoint) {
  EXPECT_EQ(parseNumber("+1.5e-3"), 0.0015);
  EXPECT_EQ(parseNumber("1e-999"), 0.0);
  EXPECT_EQ(parseNumber("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parseNumber("-1e999"), -std::numeric_limits<double>::infinity()) << "with its sign";
  EXPECT_TRUE(std::isnan(parseNumber("nan").value_or(0.0)));
  for (const char* none : {"", "+", "-", "1,5", "1.5x", "0x10", "+-1", "++1", " 1"})
    EXPECT_FALSE(parseNumber(none)) << none;
  EXPECT_EQ(parseInteger("-12"), -12);
  EXPECT_EQ(parseInteger("+12"), 12);
  for (const char* none : {"", "1.0", "99999999999999999999", "+-1", "1 "}) EXPECT_FALSE(parseInteger(none)) << none;
}

TEST(TextNumbers, CoordinatesOfAnEnormousSizeAreRefusedWithTheirLine) {
  EXPECT_TRUE(isUsable(1e12) && isUsable(dvec3(0.0)));
  EXPECT_FALSE(isUsable(1.01e12) || isUsable(std::nan("")) || isUsable(dvec3(0, INFINITY, 0)));
  TextCursor good("1 2\n3");
  EXPECT_EQ(*readPoint(good), dvec3(1, 2, 3));
  for (const char* bad : {"\n1 nan 3", "\n1 1e13 3", "\n1 two 3", "\n1 2"}) {
    TextCursor cursor(bad);
    const auto point = readPoint(cursor);
    ASSERT_FALSE(point) << bad;
    EXPECT_THAT(point.error().message(), HasSubstr("line 2")) << bad;
    EXPECT_THAT(point.error().message(), HasSubstr("vertex")) << bad;
  }
  EXPECT_THAT(unusableCoordinate("line 2", dvec3(1, std::nan(""), 3)).message(), HasSubstr("nan"));
}

TEST(TextNumbers, WordsInMessagesAreShortAndPrintable) {
  EXPECT_EQ(inQuotes("word"), "'word'");
  EXPECT_LT(inQuotes(std::string(1000, 'x')).size(), 60u);
  EXPECT_EQ(inQuotes(std::string("a\0\x01"
                                 "b",
                                 4))
                .find('\0'),
            std::string::npos);
}

class JsonFields : public ::testing::Test {
 protected:
  FieldReader reader(const std::string& text) {
    object_ = Json::parse(text);
    error_.reset();
    return FieldReader(object_, "entity 'table'", error_);
  }
  std::string message() const { return error_ ? error_->message() : ""; }
  Json object_;
  std::optional<Error> error_;
};

TEST_F(JsonFields, AbsentMembersLeaveTheirTargets) {
  FieldReader fields = reader(R"({"name": "a", "on": true, "size": 2.5, "words": ["x", "y"], "kind": "solid",
    "pose": {"position": [1, 2, 3], "quaternion": [0, 0, 0, 1]}})");
  std::string name = "before", other = "before";
  bool on = false;
  double size = 0.0;
  std::vector<std::string> words;
  Pose pose;
  int kind = -1;
  fields.read("name", name);
  fields.read("absent", other);
  fields.read("on", on);
  fields.read("size", size);
  fields.read("words", words);
  fields.read("pose", pose);
  fields.readWord("kind", {"robot", "solid"}, kind);
  EXPECT_EQ(message(), "");
  EXPECT_EQ(name, "a");
  EXPECT_EQ(other, "before");
  EXPECT_TRUE(on);
  EXPECT_EQ(size, 2.5);
  EXPECT_THAT(words, ElementsAre("x", "y"));
  EXPECT_EQ(pose.p, dvec3(1, 2, 3));
  EXPECT_EQ(kind, 1);
  Diagnostics diagnostics;
  fields.warnAboutOthers(diagnostics);
  EXPECT_TRUE(diagnostics.warnings.empty());
}

TEST_F(JsonFields, TheFirstMemberOfTheWrongKindIsTheError) {
  for (const char* text : {R"({"size": "2"})", R"({"size": null})", R"({"size": 1e999})", R"({"size": [1]})"}) {
    Json parsed = Json::parse(text, nullptr, false);
    if (parsed.is_discarded()) continue;
    object_ = parsed;
    error_.reset();
    FieldReader fields(object_, "entity 'table'", error_);
    double size = 7.0;
    fields.read("size", size);
    EXPECT_EQ(size, 7.0) << text;
    EXPECT_THAT(message(), HasSubstr("entity 'table'")) << text;
    EXPECT_THAT(message(), HasSubstr("size")) << text;
  }
  FieldReader fields = reader(R"({"kind": "ghost", "size": "2", "n": [1, 2]})");
  int kind = 3;
  double size = 0.0;
  std::vector<double> numbers;
  fields.readWord("kind", {"robot", "solid"}, kind);
  fields.read("size", size);
  EXPECT_THAT(message(), HasSubstr("ghost")) << "the first counts";
  EXPECT_EQ(kind, 3);
  EXPECT_FALSE(fields.readNumbers("n", 3, numbers));
}

TEST_F(JsonFields, WhatNobodyAskedForAndWhatIsMissingIsSaid) {
  FieldReader fields = reader(R"({"naem": "a"})");
  std::string name;
  fields.read("name", name);
  Diagnostics diagnostics;
  fields.warnAboutOthers(diagnostics);
  ASSERT_EQ(diagnostics.warnings.size(), 1u);
  EXPECT_THAT(english(diagnostics.warnings[0]), HasSubstr("naem"));
  fields.require("name");
  EXPECT_THAT(message(), HasSubstr("name"));
  EXPECT_EQ(fields.array("naem"), nullptr);
}

TEST_F(JsonFields, PosesAndPrettyTextsAreReadAgain) {
  const Pose pose{{0.1, -0.2, 1e-9}, glm::normalize(dquat(0.5, 0.1, -0.7, 0.3))};
  const Json written = {{"pose", toJson(pose)}, {"list", {1, 2, 3}}};
  const std::string text = prettyText(written);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_THAT(text, HasSubstr("[1, 2, 3]"));
  FieldReader fields = reader(text);
  Pose again;
  fields.read("pose", again);
  EXPECT_EQ(again.p, pose.p);
  EXPECT_LT(glm::length(rotationVector(again.q * glm::conjugate(pose.q))), 1e-15);
}

class TomlFieldsTest : public ::testing::Test {
 protected:
  TomlFields fields(const std::string& text) {
    table_ = toml::parse(text);
    error_.reset();
    return TomlFields(table_, "[part]", error_);
  }
  std::string message() const { return error_ ? error_->message() : ""; }
  toml::table table_;
  std::optional<Error> error_;
};

TEST_F(TomlFieldsTest, NumbersAreScaledAndBounded) {
  TomlFields part =
      fields("length = 250\nname = 'a'\non = true\nlist = [1, 2.5]\npoint = [1, 2, 3]\nkind = 'b'\ncolor = '#ff8000'");
  double length = 0.0;
  std::string name;
  bool on = false;
  std::vector<double> list;
  dvec3 point(0.0);
  int kind = -1;
  std::array<float, 4> color{};
  part.read("length", length, 1e-3, 0.0, 1000.0);
  part.read("name", name);
  part.read("on", on);
  part.readList("list", list, 2.0);
  part.readPoint("point", point, 1e-3);
  part.readWord("kind", {"a", "b"}, kind);
  part.readColor("color", color);
  part.refuseOthers();
  EXPECT_EQ(message(), "");
  EXPECT_NEAR(length, 0.25, 1e-15);
  EXPECT_TRUE(on);
  EXPECT_THAT(list, ElementsAre(2.0, 5.0));
  EXPECT_LT(glm::distance(point, dvec3(0.001, 0.002, 0.003)), 1e-15);
  EXPECT_EQ(kind, 1);
  EXPECT_NEAR(color[1], 128.0f / 255.0f, 1e-6f);
}

TEST_F(TomlFieldsTest, WrongKindsRangesAndUnknownKeysAreErrors) {
  double value = 7.0;
  for (const char* bad :
       {"length = 'x'", "length = 2000", "length = -1", "length = nan", "length = inf", "length = [1]"}) {
    TomlFields part = fields(bad);
    part.read("length", value, 1e-3, 0.0, 1000.0);
    EXPECT_THAT(message(), HasSubstr("length")) << bad;
    EXPECT_EQ(value, 7.0);
  }
  TomlFields unknown = fields("lenght = 1");
  unknown.read("length", value);
  unknown.refuseOthers();
  EXPECT_THAT(message(), HasSubstr("lenght"));
  std::array<float, 4> color{};
  for (const char* bad : {"color = 'red'", "color = '#ff80'", "color = '#gggggg'"}) {
    TomlFields part = fields(bad);
    part.readColor("color", color);
    EXPECT_TRUE(part.failed()) << bad;
  }
  TomlFields missing = fields("a = 1");
  missing.require("b");
  EXPECT_THAT(message(), HasSubstr("b"));
}

TEST_F(TomlFieldsTest, APoseIsInDegreesOrAQuaternion) {
  Pose pose;
  TomlFields by_angles = fields("position = [100, 0, 0]\nrpy = [0, 0, 90]");
  by_angles.readPose(pose, 1e-3);
  EXPECT_EQ(message(), "");
  EXPECT_LT(glm::distance(pose * dvec3(1, 0, 0), dvec3(0.1, 1.0, 0.0)), 1e-12);
  TomlFields by_quaternion = fields("quaternion = [0, 0, 0, 1.0005]");
  by_quaternion.readPose(pose, 1.0);
  EXPECT_LT(glm::distance(pose.rotate({1, 0, 0}), dvec3(-1, 0, 0)), 1e-12) << "made unit";
  for (const char* bad :
       {"quaternion = [0, 0, 0, 0]", "quaternion = [0, 0, 0, 2]", "quaternion = [1, 0, 0]", "rpy = [1, 2]"}) {
    TomlFields none = fields(bad);
    none.readPose(pose, 1.0);
    EXPECT_TRUE(none.failed()) << bad;
  }
}

TEST(FileContent, OnlyRegularFilesAreRead) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(*readFileContent(folder.write("a", std::string("x\0y", 3))), std::string("x\0y", 3));
  EXPECT_EQ(*readFileContent(folder.write("empty", "")), "");
  for (const fs::path& bad : {folder.path(), folder.path() / "none", fs::path("/dev/zero"), fs::path()}) {
    const auto content = readFileContent(bad);
    ASSERT_FALSE(content) << bad;
    EXPECT_EQ(content.error().file, bad.string());
  }
}

TEST(ReadRecord, HoldsWhatIsNotedWhileItLivesTheInnerOneHidesTheOuter) {
  ReadRecord::note("/nobody/listens");
  ReadRecord outer;
  ReadRecord::note("/a");
  {
    const ReadRecord inner;
    ReadRecord::note("/b");
    EXPECT_THAT(inner.files(), ElementsAre(fs::path("/b")));
  }
  ReadRecord::note("/c");
  ReadRecord::note("/c");
  EXPECT_THAT(outer.files(), ElementsAre(fs::path("/a"), fs::path("/c")));
}

TEST(PackagePath, PackagesAreFoundBesideAndAboveTheDescription) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "arm" / "urdf");
  fs::create_directories(folder.path() / "arm" / "meshes");
  folder.write("arm/package.xml", "<package><name>arm_description</name></package>");
  const fs::path mesh = folder.write("arm/meshes/link 1.stl", "x"), urdf = folder.path() / "arm" / "urdf";
  for (const char* uri : {"package://arm/meshes/link 1.stl", "package://arm_description/meshes/link%201.stl",
                          "../meshes/link 1.stl", "..\\meshes\\link 1.stl", "file://package://arm/meshes/link 1.stl"}) {
    const auto found = findReference(uri, urdf);
    ASSERT_TRUE(found) << uri;
    EXPECT_TRUE(fs::equivalent(found->path, mesh)) << uri;
    EXPECT_TRUE(found->taken_for_package.empty()) << uri;
  }
  EXPECT_TRUE(findReference("file://" + (folder.path() / "arm" / "package.xml").string(), urdf));
  EXPECT_FALSE(findReference("package://arm/meshes/none.stl", urdf));
  EXPECT_FALSE(findReference("", urdf));
  EXPECT_FALSE(findReference("package://arm/../../secret", urdf));
  const auto guessed = findReference("package://renamed/meshes/link 1.stl", urdf);
  ASSERT_TRUE(guessed);
  EXPECT_FALSE(guessed->taken_for_package.empty());
  EXPECT_THAT(english(takenForPackage("package://renamed/meshes/link 1.stl", *guessed)), HasSubstr("renamed"));
}

TEST(PackagePath, ReferencesThatLeaveTheirPackageAreSeen) {
  EXPECT_TRUE(leavesPackage("package://arm/../other/a.stl"));
  EXPECT_TRUE(leavesPackage("model://arm/a/../../b"));
  EXPECT_FALSE(leavesPackage("package://arm/a/../b.stl"));
  EXPECT_FALSE(leavesPackage("../b.stl")) << "no package";
  EXPECT_EQ(percentDecoded("a%20b%C3%A4"), "a b\xC3\xA4");
  EXPECT_EQ(percentDecoded("100% %zz %4"), "100% %zz %4");
  EXPECT_EQ(percentDecoded("a%00b"), "a%00b") << "a zero byte stays";
}

TEST(ContentRules, WhatAFileHoldsIsUsedNotedReportedOrRefused) {
  EXPECT_STREQ(toString(Treatment::kUsed), "used");
  EXPECT_STREQ(toString(Treatment::kRefused), "refused");
  ASSERT_FALSE(contentRules().empty());
  for (const FormatRules& format : contentRules()) {
    ContentReport report(format.format);
    std::set<std::string> names;
    for (const ContentRule& rule : format.rules) {
      EXPECT_TRUE(names.insert(std::string(rule.element)).second)
          << format.format << " has " << rule.element << " twice";
      ASSERT_NE(report.rule(rule.element), nullptr);
      EXPECT_EQ(report.meet(rule.element, "'arm'"), rule.treatment);
    }
    EXPECT_EQ(report.rule("no such thing"), nullptr);
    EXPECT_EQ(report.meet("no such thing", "line 12"), Treatment::kReported);
    EXPECT_EQ(report.meet("their:own", "line 12"), Treatment::kNoted) << "of another program";
    std::vector<Text> warnings;
    report.tell(warnings);
    const std::string all = english(warnings);
    EXPECT_THAT(all, HasSubstr("no such thing"));
    EXPECT_THAT(all, HasSubstr("line 12"));
  }
}

}  // namespace
}  // namespace hapticell::workcell
