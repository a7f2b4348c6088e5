// SPDX-License-Identifier: Apache-2.0
#include "studies/document/study_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "config/configuration.h"
#include "studies/document/study_document.h"

namespace hapticell::studies {
namespace {

const std::string kStudy =
    "# Größe: what it is about\n"
    "name = \"Préss ü\"   # keep\n"
    "cell = 'press.hcell'\n"
    "future_key = 1979-05-27\n"
    "\n"
    "# The robot.\n"
    "[[vary]]\n"
    "what = \"position\" # é\n"
    "values = [0.1,\n"
    "  0.2, # inner\n"
    "]\n"
    "axis=\"x\"\n"
    "\n"
    "# The table.\n"
    "[[vary]]\n"
    "what = \"size\"\n"
    "unknown = [1, \"two\"]\n"
    "\n"
    "[[ask]]\n"
    "what = \"reach\"";

StudyText studyText(const std::string& text) {
  auto study = StudyText::parse(text, "s.hstudy");
  EXPECT_TRUE(study) << study.error().message();
  return study ? *study : StudyText();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(StudyText, ReadsEveryKindOfValue) {
  const StudyText study = studyText(kStudy);
  EXPECT_EQ(study.count("vary"), 2U);
  EXPECT_EQ(study.count("search"), 0U);
  EXPECT_EQ(study.word({}, "name"), "Préss ü");
  EXPECT_EQ(std::get<std::vector<double>>(study.value({"vary", 0}, "values")), (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(study.keys({"vary", 0}), (std::vector<std::string>{"what", "values", "axis"}));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(study.value({"vary", 1}, "unknown")));
  EXPECT_EQ(study.written({"vary", 1}, "unknown"), "[1, \"two\"]");
  EXPECT_EQ(study.written({}, "future_key"), "1979-05-27");
}

/// Against the text with exactly this piece exchanged: nothing else may change, comments and strange keys included.
TEST(StudyText, ChangesOnlyWhatIsSet) {
  StudyText study = studyText(kStudy);
  ASSERT_TRUE(study.set({}, "name", std::string("A \"b\"")));
  EXPECT_EQ(study.text(), replaced(kStudy, "\"Préss ü\"", "\"A \\\"b\\\"\""));
  study = studyText(kStudy);
  ASSERT_TRUE(study.set({"vary", 0}, "values", std::vector<double>{0.5, 1.0}));
  EXPECT_EQ(study.text(), replaced(kStudy, "[0.1,\n  0.2, # inner\n]", "[0.5, 1]"));
  study = studyText(kStudy);
  ASSERT_TRUE(study.set({"vary", 0}, "values", {}));
  EXPECT_EQ(study.text(), replaced(kStudy, "values = [0.1,\n  0.2, # inner\n]\n", ""));
  study = studyText(kStudy);
  ASSERT_TRUE(study.set({"vary", 0}, "from", -0.5));
  EXPECT_EQ(study.text(), replaced(kStudy, "axis=\"x\"\n", "axis=\"x\"\nfrom = -0.5\n") + "\n");
  study = studyText(kStudy);
  ASSERT_TRUE(study.set({"search", 0}, "starts", 3.0));
  EXPECT_EQ(study.text(), kStudy + "\n\n[search]\nstarts = 3\n");
}

TEST(StudyText, AddsAndRemovesTables) {
  StudyText study = studyText(kStudy);
  ASSERT_TRUE(study.add("vary", {{"what", std::string("joint")}, {"from", 0.0}, {"note", {}}}));
  EXPECT_EQ(study.text(), replaced(kStudy, "\"two\"]\n", "\"two\"]\n\n[[vary]]\nwhat = \"joint\"\nfrom = 0\n") + "\n");
  ASSERT_TRUE(study.remove({"vary", 2}));
  EXPECT_EQ(study.text(), kStudy + "\n");
  ASSERT_TRUE(study.remove({"vary", 1}));
  EXPECT_EQ(study.text(),
            replaced(kStudy, "\n# The table.\n[[vary]]\nwhat = \"size\"\nunknown = [1, \"two\"]\n", "") + "\n");
  ASSERT_TRUE(study.add("objective", {{"value", std::string("reach.share")}}));
  EXPECT_TRUE(study.text().ends_with("what = \"reach\"\n\n[[objective]]\nvalue = \"reach.share\"\n")) << study.text();
  EXPECT_FALSE(study.remove({"vary", 7}));
}

TEST(StudyText, RefusesWhatItCannotKeep) {
  StudyText study = studyText("vary = [{what = \"size\"}]\n");
  EXPECT_FALSE(study.set({"vary", 0}, "from", 1.0));
  EXPECT_TRUE(study.set({"vary", 0}, "what", std::string("joint")));
  EXPECT_EQ(study.text(), "vary = [{what = \"joint\"}]\n");
  EXPECT_FALSE(StudyText::parse("a = \n", "x"));
  const std::string before = study.text();
  EXPECT_FALSE(study.set({}, "no key", std::string("x")));
  EXPECT_EQ(study.text(), before);
}

/// A study made from nothing is one that StudyDocument reads.
TEST(StudyText, MakesAStudyFromNothing) {
  StudyText study;
  ASSERT_TRUE(study.set({}, "cell", std::string("a.hcell")));
  ASSERT_TRUE(study.add("vary", {{"what", std::string("position")}, {"from", -0.25}, {"to", 1.0 / 3.0}}));
  ASSERT_TRUE(study.add("ask", {{"what", std::string("reach")}}));
  ASSERT_TRUE(study.set({"sampling", 0}, "method", std::string("halton")));
  ASSERT_TRUE(study.set({"sampling", 0}, "samples", 7.0));
  const auto document = StudyDocument::parse(study.text(), "/tmp/s.hstudy");
  ASSERT_TRUE(document) << document.error().message();
  EXPECT_EQ(document->samples, 7U);
  EXPECT_EQ(std::get<double>(study.value({"vary", 0}, "to")), 1.0 / 3.0);
}

/// Every shipped study, each value written again as it is read: the same study.
TEST(StudyText, KeepsTheShippedStudies) {
  const auto folder = config::findShippedFile("studies");
  ASSERT_TRUE(folder) << folder.error().message();
  int studies = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    if (entry.path().extension() != ".hstudy") continue;
    ++studies;
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    const std::string before = text.str();
    StudyText study = studyText(before);
    for (const char* table : {"vary", "ask", "require", "objective"}) {
      for (std::size_t i = 0; i < study.count(table); ++i) {
        for (const std::string& key : study.keys({table, i})) {
          const StudyValue value = study.value({table, i}, key);
          ASSERT_FALSE(std::holds_alternative<std::monostate>(value)) << key;
          ASSERT_TRUE(study.set({table, i}, key, value));
          EXPECT_EQ(study.value({table, i}, key), value);
        }
      }
    }
    EXPECT_EQ(std::count(before.begin(), before.end(), '#'),
              std::count(study.text().begin(), study.text().end(), '#'));
  }
  EXPECT_EQ(studies, 3);
}

}  // namespace
}  // namespace hapticell::studies
