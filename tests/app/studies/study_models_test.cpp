// SPDX-License-Identifier: Apache-2.0
// Studies in the window as values and models: no display is needed.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/studies/chart_axis.h"
#include "app/studies/floor_area.h"
#include "app/studies/result_table.h"
#include "app/studies/study_draft.h"
#include "app/studies/study_fields.h"
#include "app/studies/variant_map.h"
#include "studies/questions/question.h"
#include "studies/store/result_ranking.h"
#include "studies/variants/variation.h"
#include "workcell/entity/built_in_parts.h"

namespace hapticell::app {
namespace {

namespace fs = std::filesystem;

/// A box at (1, 2, 0.2) in a cell.
workcell::DocumentState cellWithABox() {
  workcell::Document document;
  workcell::Entity box = workcell::makeBuiltInPart("box:0.4,0.4,0.4", 1.0).value();
  box.name = "box";
  box.X_WE = Pose::translation({1.0, 2.0, 0.2});
  EXPECT_TRUE(document.execute(workcell::AddEntity{box}));
  return document.state();
}

std::string contentOf(const QString& path) {
  std::ifstream stream(path.toStdString());
  std::stringstream content;
  content << stream.rdbuf();
  return content.str();
}

/// 3 x 2 places: x 0, 0.1, 0.2 and y 0, 0.5; two answers; the last one misses the requirement.
ResultTable& filled(ResultTable& table) {
  studies::ResultHead head;
  head.study = "cell = \"a.hcell\"\n[[vary]]\nwhat = \"position\"\nname = \"px\"\nentity = \"box\"\naxis = \"x\"\n"
               "values = [0, 0.1, 0.2]\n[[vary]]\nwhat = \"position\"\nname = \"py\"\nentity = \"box\"\naxis = \"y\"\n"
               "values = [0, 0.5]\n[[ask]]\nwhat = \"reach\"\n[[objective]]\nvalue = \"a.time\"\n[[objective]]\n"
               "value = \"a.margin\"\ngoal = \"greatest\"\n";
  head.file = "/tmp/s.hstudy";
  head.variants = head.units = 6;
  using Kind = studies::Column::Kind;
  head.values = {{"px", Kind::kNumber, "m"}, {"py", Kind::kNumber, "m"}};
  head.answers = {{"a.time", Kind::kNumber, "s"}, {"a.margin", Kind::kNumber, ""}, {"a.word", Kind::kText, ""}};
  table.begin(head, "/tmp/s.hresults");
  std::vector<studies::ResultRow> rows;
  const double times[] = {5, 4, 3, 4, 1, 2}, margins[] = {0.5, 0.4, 0.1, 0.6, 0.2, 0.9};
  for (int i = 0; i < 6; ++i) {
    studies::ResultRow row;
    row.number = i;
    row.values = {studies::Value(0.1 * (i / 2)), studies::Value(0.5 * (i % 2))};
    row.answers = {times[i], margins[i], std::string(i % 2 == 0 ? "even" : "odd")};
    row.feasible = i != 5;
    row.violation = i == 5 ? 1.0 : 0.0;
    row.objective = times[i] - margins[i];
    rows.push_back(row);
  }
  table.add(rows);
  return table;
}

TEST(StudyFields, NameEveryKindOfTheLibrary) {
  for (const auto& kind : studies::variationKinds()) EXPECT_NE(studyKind("vary", kind.name), nullptr) << kind.name;
  for (const auto& kind : studies::questionKinds()) EXPECT_NE(studyKind("ask", kind.name), nullptr) << kind.name;
  EXPECT_EQ(varyKinds().size(), studies::variationKinds().size());
  EXPECT_EQ(askKinds().size(), studies::questionKinds().size());
}

TEST(StudyDraft, AFloorAreaIsTwoPositionsAboutTheGivenPlace) {
  const workcell::DocumentState cell = cellWithABox();
  StudyDraft draft;
  draft.begin("/cells/a.hcell");
  draft.addFloorRange("box");
  auto ranges = draft.floorRanges(cell);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_DOUBLE_EQ(ranges[0].x_from, 0.5);
  EXPECT_DOUBLE_EQ(ranges[0].y_to, 2.5);
  // The far right corner, then the middle, then one that would turn it inside out.
  ranges[0] = FloorArea::dragged(ranges[0], 3, {1.8, 2.25, 0.0});
  EXPECT_DOUBLE_EQ(ranges[0].x_to, 1.8);
  EXPECT_DOUBLE_EQ(ranges[0].x_from, 0.5);
  ranges[0] = FloorArea::dragged(ranges[0], 0, FloorArea::handlesOf(ranges[0])[0] + dvec3(0.1, -0.2, 0.0));
  EXPECT_NEAR(ranges[0].x_from, 0.6, 1e-12);
  EXPECT_NEAR(ranges[0].y_to, 2.05, 1e-12);
  draft.setFloorRange(ranges[0], cell);
  EXPECT_EQ(draft.text().written({"vary", 0}, "from"), "-0.4");
  EXPECT_EQ(draft.text().written({"vary", 0}, "to"), "0.9");
  EXPECT_EQ(draft.text().written({"vary", 1}, "to"), "0.05");
  EXPECT_LT(FloorArea::dragged(ranges[0], 1, {99.0, 99.0, 0.0}).x_from, ranges[0].x_to);
  // The coordinate itself.
  draft.set({"vary", 0}, "absolute", true);
  draft.setFloorRange(ranges[0], cell);
  EXPECT_EQ(draft.text().written({"vary", 0}, "from"), "0.6");
  EXPECT_TRUE(draft.isChanged());
}

TEST(StudyDraft, SavingElsewhereKeepsWhatPathsMean) {
  QTemporaryDir folder;
  const fs::path base(folder.path().toStdString());
  fs::create_directories(base / "one" / "two");
  std::ofstream(base / "one" / "s.hstudy") << "# kept\ncell = \"a.hcell\"\n[[vary]]\nwhat = \"position\"\n"
                                              "[[ask]]\nwhat = \"reach\"\ntargets = \"two/t.csv\"\nodd = 3\n";
  StudyDraft draft;
  ASSERT_TRUE(draft.open(QString::fromStdString((base / "one" / "s.hstudy").string())));
  EXPECT_EQ(draft.cell().toStdString(), (base / "one" / "a.hcell").string());
  EXPECT_EQ(draft.unknownKeys({"ask", 0}), std::vector<std::string>{"odd"});
  const QString other = QString::fromStdString((base / "one" / "two" / "s.hstudy").string());
  ASSERT_TRUE(draft.save(other));
  EXPECT_EQ(contentOf(other), "# kept\ncell = \"" + (base / "one" / "a.hcell").string() +
                                  "\"\n[[vary]]\nwhat = \"position\"\n[[ask]]\nwhat = \"reach\"\ntargets = \"t.csv\"\n"
                                  "odd = 3\n");
  EXPECT_FALSE(draft.open(folder.filePath("none.hstudy")));
  EXPECT_EQ(draft.file(), other) << "a failure changes nothing";
}

TEST(StudyDraft, ChangesTheMethodAndTheRest) {
  StudyDraft draft;
  draft.begin("/cells/a.hcell");
  EXPECT_EQ(draft.method(), "grid");
  draft.setMethod("sobol");
  EXPECT_EQ(draft.text().written({"sampling", 0}, "samples"), "100");
  draft.setMethod("search");
  EXPECT_EQ(draft.text().count("sampling"), 0U);
  EXPECT_EQ(draft.method(), "search");
  draft.setMethod("grid");
  EXPECT_EQ(draft.text().count("search"), 0U);
  draft.add("ask", {{"what", std::string("posture")}, {"methods", std::vector<std::string>{"reba"}}});
  const auto names = draft.resultNames();
  EXPECT_NE(std::find(names.begin(), names.end(), "posture.reba"), names.end());
  EXPECT_EQ(std::find(names.begin(), names.end(), "posture.rula"), names.end());
}

TEST(ResultTable, CountsRanksAndChooses) {
  ResultTable table;
  filled(table);
  EXPECT_EQ(table.rowCount(), 6);
  EXPECT_EQ(table.feasible(), 5U);
  // By hand: 4 (1 s) beats 2 (3 s, 0.1); 3 (4 s, 0.6) beats 0 and 1.
  EXPECT_EQ(table.front(), (std::set<std::size_t>{3, 4}));
  EXPECT_EQ(table.best(), 4U);
  EXPECT_EQ(table.word(0, table.columnNamed("a.word")), "even");
  EXPECT_EQ(table.isGreaterBetter(table.columnNamed("a.margin")), true);
  EXPECT_EQ(table.isGreaterBetter(table.columnNamed("a.time")), false);
  table.choose(3);
  EXPECT_EQ(table.chosen(), 3U);
  studies::ResultRow again = table.rows()[3];
  again.answers[0] = 0.5;
  table.add({again});
  EXPECT_EQ(table.rowCount(), 6) << "a row of a number that is there replaces it";
  EXPECT_EQ(table.chosen(), 3U) << "stays chosen while rows come";
  EXPECT_EQ(table.front(), (std::set<std::size_t>{3}));
  table.choose(77);
  EXPECT_FALSE(table.chosen());
}

TEST(VariantMap, StandsWhereTheVariantsAre) {
  ResultTable table;
  filled(table);
  const VariantMap map = mapOf(table, cellWithABox(), table.columnNamed("a.time"));
  ASSERT_EQ(map.cells.size(), 6U);
  EXPECT_NEAR(map.size.x, 0.092, 1e-9);
  EXPECT_NEAR(map.size.y, 0.46, 1e-9);
  EXPECT_DOUBLE_EQ(map.least, 1.0);
  EXPECT_DOUBLE_EQ(map.greatest, 5.0) << "infeasible ones do not count";
  const MapCell* cell = map.at({1.21, 2.1, 0.0});
  ASSERT_NE(cell, nullptr);
  EXPECT_EQ(cell->number, 4);
  EXPECT_DOUBLE_EQ(*map.shareOf(*cell), 1.0) << "the shortest time is the best";
  EXPECT_EQ(map.at({3.0, 2.0, 0.0}), nullptr);
  EXPECT_EQ(map.items().size(), 6U);
  EXPECT_NE(map.items()[5].pattern, map.items()[4].pattern) << "infeasible: told apart without colour";
}

TEST(VariantMap, ColoursGrowLighter) {
  double last = -1.0;
  for (double share = 0.0; share <= 1.0; share += 0.05) {
    const QColor color = heatColor(share);
    const double lightness = 0.2126 * color.redF() + 0.7152 * color.greenF() + 0.0722 * color.blueF();
    EXPECT_GT(lightness, last) << share;
    last = lightness;
  }
}

TEST(ChartAxis, TicksAreRoundAndWordsAreNamed) {
  const auto ticks = roundTicks(-0.13, 0.62, 5);
  ASSERT_GE(ticks.size(), 3U);
  for (const double tick : ticks) EXPECT_NEAR(tick / 0.2, std::round(tick / 0.2), 1e-9);
  EXPECT_EQ(roundTicks(3.0, 3.0, 5).size(), 1U);
  ResultTable table;
  filled(table);
  const ChartAxis words = ChartAxis::over(table, table.columnNamed("a.word"));
  EXPECT_EQ(words.words, (std::vector<QString>{"even", "odd"}));
  EXPECT_DOUBLE_EQ(words.shareOf(table, 0), 0.25);
  EXPECT_EQ(words.tickText(1.0), "odd");
  const ChartAxis times = ChartAxis::over(table, table.columnNamed("a.time"));
  EXPECT_GT(times.shareOf(table, 0), 0.9);
  EXPECT_LT(times.shareOf(table, 4), 0.1);
}

}  // namespace
}  // namespace hapticell::app
