// SPDX-License-Identifier: Apache-2.0
// The one rule for what a file holds and is not used: files that have every listed thing, and the table of the page.
#include "workcell/text/content_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/importer/model_texts.h"
#include "tests/support/test_data.h"
#include "workcell/scenes/import_scene.h"
#include "workcell/scenes/sdf_cell_reader.h"
#include "workcell/scenes/whole_mesh.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;

const FormatRules& rulesOf(std::string_view format) {
  const auto all = contentRules();
  return *std::find_if(all.begin(), all.end(), [&](const FormatRules& f) { return f.format == format; });
}

std::string listOf(const FormatRules& format, Treatment treatment) {
  std::string text;
  for (const ContentRule& rule : format.rules) {
    if (rule.treatment == treatment) text += (text.empty() ? "`" : ", `") + std::string(rule.element) + "`";
  }
  return text;
}

bool tells(const std::vector<Text>& warnings, std::string_view element) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const Text& warning) { return english(warning).starts_with(std::string(element) + " ("); });
}

TEST(ContentRules, ThePageShowsWhatTheReadersDo) {
  const std::string page = readFileContent(test::sourceFile("docs/user/formats-content.md")).value();
  for (const FormatRules& format : contentRules()) {
    for (const Treatment treatment : {Treatment::kUsed, Treatment::kNoted, Treatment::kReported, Treatment::kRefused}) {
      const std::string list = listOf(format, treatment);
      if (list.empty()) continue;
      const std::string row = "| " + std::string(format.format) + ", " + toString(treatment) + " | " + list + " |";
      EXPECT_THAT(page, HasSubstr(row));
    }
    for (const ContentRule& rule : format.rules) {
      EXPECT_EQ(rule.treatment == Treatment::kReported, *rule.meaning != '\0') << rule.element;
    }
  }
}

TEST(ContentRules, EveryElementOfAnSdfFileIsTreatedAsListed) {
  test::TemporaryFolder folder;
  const std::string box = "<geometry><box><size>1 1 1</size></box></geometry>";
  folder.write("models/crate/model.sdf", "<sdf version='1.7'><model name='crate'><link name='l'><visual name='v'>" +
                                             box + "</visual></link></model></sdf>");
  folder.write("m.stl",
               "solid m\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
               "endfacet\nendsolid m\n");
  const std::string whole =
      "<sdf version='1.9'><world name='w'><model name='m'><link name='l'><visual name='v'>" + box +
      "<material><diffuse>1 0 0 1</diffuse></material></visual><collision name='c'>" + box +
      "</collision><visual name='w'><geometry><mesh><uri>m.stl</uri></mesh></geometry></visual></link><link name='k'/>"
      "<joint name='j' type='universal'><parent>l</parent><child>k</child><axis><xyz>1 0 "
      "0</xyz><limit><lower>-1</lower>"
      "<upper>1</upper></limit></axis><axis2><xyz>0 1 0</xyz></axis2></joint></model><include><uri>model://crate</uri>"
      "</include></world></sdf>";
  const auto told = [&](const std::string& text) {
    auto scene = readSdfCell(folder.write("cell.sdf", text), nullptr);
    EXPECT_TRUE(scene) << scene.error().message();
    std::vector<Text> warnings = scene ? scene->warnings : std::vector<Text>{};
    std::erase_if(warnings, [](const Text& w) { return english(w).find("moving joints") != std::string::npos; });
    return warnings;
  };
  EXPECT_TRUE(told(whole).empty());
  int tried = 0;
  std::string all = whole;
  std::vector<std::string_view> reported;
  for (const ContentRule& rule : rulesOf("SDF").rules) {
    const std::string_view parent = rule.element.substr(0, rule.element.find('/'));
    const std::string end = "</" + std::string(parent) + ">";
    if (rule.treatment == Treatment::kUsed || all.find(end) == std::string::npos) continue;
    const std::string child = "<" + std::string(rule.element.substr(parent.size() + 1)) + "/>";
    // A shape that is not read takes the place of one that is, or it would be a second one of the same body.
    if (parent == "geometry") {
      all.insert(all.find("</link>"),
                 "<visual name='" + std::to_string(tried) + "'><geometry>" + child + "</geometry></visual>");
    } else {
      all.insert(all.find(end), child);
    }
    ++tried;
    if (rule.treatment == Treatment::kReported) reported.push_back(rule.element);
  }
  EXPECT_GT(tried, 60);
  // And two that are in no list, of which the one in a namespace of its own is for another program.
  all.insert(all.find("</link>"), "<wing/><my:own/>");
  const auto warnings = told(all);
  for (const std::string_view element : reported) EXPECT_TRUE(tells(warnings, element)) << element;
  EXPECT_EQ(warnings.size(), reported.size() + 1);
  EXPECT_THAT(english(warnings), HasSubstr("link/wing (not supported by this reader)"));
}

TEST(ContentRules, EveryExtensionOfGltfIsTreatedAsListed) {
  test::TemporaryFolder folder;
  std::string names;
  for (const ContentRule& rule : rulesOf("glTF").rules) {
    if (rule.treatment == Treatment::kNoted) names += (names.empty() ? "\"" : ",\"") + std::string(rule.element) + "\"";
  }
  const auto read = [&](const std::string& more, const std::string& primitive = "") {
    return readScene(folder.write("a.gltf", test::gltfBox(more, primitive)), {}, nullptr);
  };
  const auto silent = read(",\"extensionsUsed\":[" + names + "],\"extensionsRequired\":[" + names + "]");
  ASSERT_TRUE(silent) << silent.error().message();
  EXPECT_TRUE(silent->warnings.empty());
  const auto told = read(",\"animations\":[{}],\"skins\":[{}]", ",\"weights\":[0.5]");
  ASSERT_TRUE(told) << told.error().message();
  for (const char* element : {"animations", "skins", "morph targets"}) EXPECT_TRUE(tells(told->warnings, element));
  const auto refused = read(",\"extensionsRequired\":[\"ACME_curved_space\"]");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("ACME_curved_space"));
}

TEST(ContentRules, EveryLibraryOfColladaIsTreatedAsListed) {
  test::TemporaryFolder folder;
  std::string libraries, empty;
  std::vector<std::string_view> reported;
  for (const ContentRule& rule : rulesOf("Collada").rules) {
    if (rule.treatment == Treatment::kUsed || rule.element.find('/') != std::string_view::npos) continue;
    const std::string name(rule.element);
    libraries += "<" + name + "><one id='" + name + "'/></" + name + ">";
    empty += "<" + name + "/><" + name + "><asset/><extra/></" + name + ">";
    if (rule.treatment == Treatment::kReported) reported.push_back(rule.element);
  }
  const auto scene = readScene(folder.write("a.dae", test::colladaBox(libraries)), {}, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->warnings.size(), reported.size());
  for (const std::string_view element : reported) EXPECT_TRUE(tells(scene->warnings, element)) << element;

  const auto silent = readScene(folder.write("b.dae", test::colladaBox(empty)), {}, nullptr);
  ASSERT_TRUE(silent) << silent.error().message();
  EXPECT_TRUE(silent->warnings.empty()) << "exporters write empty libraries: " << english(silent->warnings);

  Diagnostics notes;
  ASSERT_TRUE(readWholeMesh(folder.path() / "a.dae", {}, notes));
  EXPECT_EQ(notes.warnings.size(), reported.size());
  for (const Text& note : notes.warnings) EXPECT_EQ(english(note).find("a.dae: library_"), 0u) << english(note);
}

}  // namespace
}  // namespace hapticell::workcell
