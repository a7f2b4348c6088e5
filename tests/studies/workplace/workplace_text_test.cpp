// SPDX-License-Identifier: Apache-2.0
// The tables as the reader of studies understands them, and key by key.
#include "studies/workplace/workplace_text.h"

#include <gtest/gtest.h>

#include "mannequin/body/figure.h"
#include "studies/document/study_document.h"
#include "studies/document/study_section.h"

namespace hapticell::studies {
namespace {

using Words = std::vector<std::string>;

StudyText headed() {
  return *StudyText::parse("cell = \"a.hcell\"\n# By hand.\n", "w.hstudy");
}

WorkplaceTables benchTables() {
  WorkplaceTables tables;
  tables.mannequin = "worker";
  tables.station = {"bench", "vise"};
  tables.ahead_W = {0.6, 0.8, 0.0};
  tables.height = {{"from", -0.1}, {"to", 0.2}, {"steps", 4.0}};
  tables.distance = {{"values", std::vector<double>{-0.05, 0.0}}};
  return tables;
}

TEST(WorkplaceText, AsksForAPlaceThatAllReachAndThatScoresLeast) {
  StudyText text = headed();
  ASSERT_TRUE(addWorkplaceTables(text, benchTables(), {}));
  const auto document = StudyDocument::parse(text.text(), "/tmp/w.hstudy");
  ASSERT_TRUE(document) << document.error().message();
  ASSERT_EQ(document->variations.size(), 2u);
  EXPECT_EQ(document->variations[0].kind + " " + document->variations[0].name, "position height");
  EXPECT_EQ(document->variations[1].kind + " " + document->variations[1].name, "position distance");
  ASSERT_EQ(document->questions.size(), 1u);
  EXPECT_EQ(document->questions[0].kind, "posture");
  ASSERT_EQ(document->requirements.size(), 1u);
  EXPECT_EQ(document->requirements[0].value, "posture.share");
  EXPECT_EQ(document->requirements[0].at_least, 1.0);
  EXPECT_FALSE(document->requirements[0].at_most);
  ASSERT_EQ(document->objectives.size(), 1u);
  EXPECT_EQ(document->objectives[0].value, "posture.rula");
  EXPECT_FALSE(document->objectives[0].is_greatest);

  EXPECT_TRUE(text.text().starts_with(headed().text())) << "what was there stays";
  for (const std::size_t k : {0u, 1u}) EXPECT_EQ(text.value({"vary", k}, "entities"), StudyValue(Words{"bench", "vise"}));
  EXPECT_EQ(text.value({"vary", 0}, "axis"), StudyValue(std::string("z")));
  EXPECT_EQ(text.value({"vary", 0}, "from"), StudyValue(-0.1));
  EXPECT_EQ(text.value({"vary", 0}, "to"), StudyValue(0.2));
  EXPECT_EQ(text.value({"vary", 0}, "steps"), StudyValue(4.0));
  EXPECT_EQ(text.value({"vary", 1}, "direction"), StudyValue(std::vector<double>{0.6, 0.8, 0.0}));
  EXPECT_EQ(text.value({"vary", 1}, "values"), StudyValue(std::vector<double>{-0.05, 0.0}));
  EXPECT_EQ(text.word({"ask", 0}, "entity"), "worker");
  EXPECT_EQ(text.word({"ask", 0}, "frame"), "bench") << "its targets move with the first entity of the station";
  EXPECT_EQ(text.value({"ask", 0}, "bodies"), StudyValue(workplaceBodies()));
  EXPECT_EQ(text.value({"ask", 0}, "methods"), StudyValue(Words{"rula"}));
  for (const char* absent : {"task", "all_pairs", "each_body", "postures"})
    EXPECT_EQ(text.value({"ask", 0}, absent), StudyValue()) << absent;
}

TEST(WorkplaceText, SaysWhatElseIsChosen) {
  WorkplaceTables tables = benchTables();
  tables.may_sit = true;
  tables.task = "lift";
  tables.methods = {"rula", "reba"};
  tables.each_body = tables.postures = tables.all_pairs = true;
  StudyText text = headed();
  ASSERT_TRUE(addWorkplaceTables(text, tables, {"s", "h", "d", "work"}));
  const auto document = StudyDocument::parse(text.text(), "/tmp/w.hstudy");
  ASSERT_TRUE(document) << document.error().message();
  ASSERT_EQ(document->variations.size(), 3u);
  EXPECT_EQ(document->variations[0].kind + " " + document->variations[0].name, "stance s");
  EXPECT_EQ(document->variations[1].name + document->variations[2].name, "hd");
  EXPECT_EQ(document->questions.at(0).name, "work");
  EXPECT_EQ(document->requirements.at(0).value, "work.share");
  EXPECT_EQ(document->objectives.at(0).value, "work.rula");
  EXPECT_EQ(text.word({"vary", 0}, "entity"), "worker");
  EXPECT_EQ(text.value({"vary", 0}, "values"), StudyValue(Words{"given", "seated"}));
  EXPECT_EQ(text.word({"ask", 0}, "task"), "lift");
  EXPECT_EQ(text.value({"ask", 0}, "methods"), StudyValue(Words{"rula", "reba"}));
  for (const char* flag : {"all_pairs", "each_body", "postures"})
    EXPECT_EQ(text.value({"ask", 0}, flag), StudyValue(true)) << flag;

  tables.may_stand = false;
  StudyText seated = headed();
  ASSERT_TRUE(addWorkplaceTables(seated, tables, {}));
  EXPECT_EQ(seated.value({"vary", 0}, "values"), StudyValue(Words{"seated"}));
}

TEST(WorkplaceText, RefusesTablesThatAreWrittenWithinALine) {
  auto text = StudyText::parse("cell = \"a.hcell\"\nvary = [{what = \"position\"}]\n", "w.hstudy");
  ASSERT_TRUE(text) << text.error().message();
  EXPECT_FALSE(addWorkplaceTables(*text, benchTables(), {}));
}

TEST(WorkplaceText, ItsBodiesAreTheFourBoundaryFigures) {
  const auto figures = mannequin::boundaryFigures();
  ASSERT_EQ(workplaceBodies().size(), figures.size());
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const std::string& body = workplaceBodies()[k];  // "female:5" is P5F.
    const std::string name = "P" + body.substr(body.find(':') + 1) + (body.starts_with("female") ? "F" : "M");
    EXPECT_EQ(name, figures[k].name);
  }
}

}  // namespace
}  // namespace hapticell::studies
