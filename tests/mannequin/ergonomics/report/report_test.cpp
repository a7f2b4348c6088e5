// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "mannequin/ergonomics/report/posture_report.h"

namespace hapticell::ergonomics {
namespace {

namespace fs = std::filesystem;

PostureReportInput inputFor(Language language) {
  PostureReportInput input;
  input.subtitle = "Bench, \"OP30\" <cover>";
  input.date = "20 Nov 2026";
  input.source = "A test.";
  input.language = language;
  input.figure = *mannequin::makeFigure({mannequin::Sex::kFemale, 1.525});
  input.posture = *mannequin::libraryPosture(input.figure, "overhead");
  input.task = workTaskPresets()[2];
  input.bodies = atSameTask(mannequin::boundaryFigures(), input.figure, input.posture, input.task);
  input.places = betterPlaces(input.figure, input.posture, input.task);
  input.history = {stripOf("P5 woman", {0, 0, 1, 1, 2, 3, 3, 0})};
  input.history_seconds = 4.0;
  return input;
}

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Report, SaysBodyTaskScoresDriversAssumptionsStandardsAndSignature) {
  const std::string html = reportHtml(postureReport(inputFor(Language::kEnglish)));
  for (const char* word : {"Posture assessment", "1525 mm", "Screwing, nut runner", "RULA", "REBA", "OWAS",
                           "EN 1005-4:2005", "ISO 11226:2000", "McAtamney", "What drives the score", "Boundaries",
                           "20 Nov 2026", "Signature", "<svg class=\"figure\"", "r_shoulder_flexion", "P95M"}) {
    EXPECT_NE(html.find(word), std::string::npos) << word;
  }
  EXPECT_NE(html.find("&quot;OP30&quot; &lt;cover&gt;"), std::string::npos) << "text is escaped";
  EXPECT_NE(html.find("url(#band0) #8FB4D6"), std::string::npos) << "a colour where patterns are not known";
  EXPECT_NE(html.find("@media print"), std::string::npos);
  EXPECT_EQ(html.find("<td>vl5_flexion"), std::string::npos)
      << "joint angles are running text, or it takes three pages";
}

TEST(Report, FrenchHasNoEnglishHeadings) {
  PostureReportInput french = inputFor(Language::kFrench), english = inputFor(Language::kEnglish);
  french.task = english.task = workTaskPresets()[5];  // With a lift.
  for (const bool of_task : {false, true}) {
    const Report report = of_task ? taskReport(french) : postureReport(french);
    const Report other = of_task ? taskReport(english) : postureReport(english);
    EXPECT_NE(report.title, other.title);
    EXPECT_EQ(report.language, "fr");
    ASSERT_EQ(report.blocks.size(), other.blocks.size());
    for (std::size_t i = 0; i < report.blocks.size(); ++i) {
      EXPECT_NE(report.blocks[i].heading, other.blocks[i].heading);
      for (const std::string& column : report.blocks[i].columns) {
        for (const char* word : {"Nearest", "Driven", "Method", "Reach", "Force", "Level", "Limit "})
          EXPECT_EQ(column.find(word), std::string::npos) << column;
      }
    }
  }
}

TEST(Report, EveryMethodHasItsDriversItsNearestPostureAndItsPlace) {
  PostureReportInput input = inputFor(Language::kEnglish);
  input.task = workTaskPresets()[5];
  const Report report = postureReport(input);
  const auto drives = std::find_if(report.blocks.begin(), report.blocks.end(),
                                   [](const ReportBlock& block) { return block.heading == "What drives the score"; });
  ASSERT_NE(drives, report.blocks.end());
  ASSERT_EQ(drives->rows.size(), 7u) << "six methods and the lift";
  int places = 0;
  for (const auto& row : drives->rows) {
    ASSERT_EQ(row.size(), 4u);
    places += row[3].text.find("mm") != std::string::npos ? 1 : 0;
    if (row[0].text == "OWAS") continue;  // 1321 is the least level.
    EXPECT_NE(row[1].text.find_first_of("0123456789"), std::string::npos) << row[0].text;
    EXPECT_GT(row[2].text.size(), 5u) << row[0].text;
  }
  EXPECT_GE(places, 1);
}

TEST(Report, TheScenesPictureIsInHtmlAndPdfAndComesBackFromPng) {
  PostureReportInput input = inputFor(Language::kEnglish);
  const std::string plain = reportHtml(postureReport(input));
  EXPECT_EQ(plain.find("data:image/png"), std::string::npos);
  input.scene = {3, 2, {0xFF102030u, 0xFF405060u, 0xFF708090u, 0xFFA0B0C0u, 0xFFD0E0F0u, 0xFF000000u}};
  EXPECT_NE(reportHtml(postureReport(input)).find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  const fs::path file = fs::temp_directory_path() / "hapticell_report_scene.png";
  std::ofstream(file, std::ios::binary) << pngOf(input.scene);
  const auto read = readPng(file);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->width, 3);
  EXPECT_EQ(read->pixels, input.scene.pixels);
  std::ofstream(file, std::ios::binary) << "no picture";
  EXPECT_FALSE(readPng(file));
  fs::remove(file);
  EXPECT_FALSE(readPng(file));
  EXPECT_GE(reportPages(postureReport(input)), 1);
}

TEST(Report, NamesTheCompanyAndShowsItsLogo) {
  PostureReportInput input = inputFor(Language::kEnglish);
  const std::string without = reportHtml(postureReport(input));
  EXPECT_EQ(without.find("class=\"logo\""), std::string::npos);
  input.company = "Ada & Sons";
  input.logo = {40, 20, std::vector<std::uint32_t>(800, 0xFFFF0000u)};
  const Report report = postureReport(input);
  const std::string html = reportHtml(report);
  EXPECT_NE(html.find("Ada &amp; Sons"), std::string::npos);
  EXPECT_NE(html.find("class=\"logo\" alt=\"\" src=\"data:image/png"), std::string::npos);
  EXPECT_NE(reportCsv(report).find("Ada & Sons"), std::string::npos);
  EXPECT_NE(reportJson(report).find("\"company\": \"Ada & Sons\""), std::string::npos);
  const ReportPicture page = drawReportPage(report, 1, 600);
  EXPECT_GT(std::count(page.pixels.begin(), page.pixels.end(), 0xFFFF0000u), 20) << "the red logo is drawn";
  EXPECT_EQ(reportPages(report), 1);
}

TEST(Report, TellsWhatASearchMovedAndTheWorstPhaseOfAMotion) {
  for (const Language language : {Language::kEnglish, Language::kFrench}) {
    PostureReportInput input = inputFor(language);
    input.workplace = WorkplaceFinding{{"Bench", "Vise"}, true, -0.08, 0.04, false, {3, 3, 4, 4}};
    input.phase = MotionPhase{"lifting", 1.2, 2.4, 1.8, 7};
    input.is_of_phase = true;
    const bool french = language == Language::kFrench;
    for (const Report& report : {postureReport(input), taskReport(input)}) {
      const std::string csv = reportCsv(report);
      EXPECT_NE(csv.find(french ? "1.20 s à 2.40 s (1.20 s), RULA 7" : "1.20 s to 2.40 s (1.20 s), RULA 7"),
                std::string::npos);
      EXPECT_NE(csv.find(french ? "lifting, Pire phase" : "lifting, Worst phase"), std::string::npos)
          << "the posture's source is the phase";
    }
    const std::string task = reportCsv(taskReport(input));
    EXPECT_NE(task.find("Bench, Vise"), std::string::npos);
    EXPECT_NE(task.find(french ? "-80 mm en hauteur" : "-80 mm up"), std::string::npos);
    input.workplace->is_found = false;
    EXPECT_NE(reportCsv(taskReport(input)).find(french ? "Aucune place" : "No place was found"), std::string::npos);
  }
}

TEST(Report, CsvQuotesAndJsonHoldsTheSame) {
  const Report report = taskReport(inputFor(Language::kEnglish));
  const std::string csv = reportCsv(report);
  EXPECT_NE(csv.find("\"Bench, \"\"OP30\"\" <cover>\""), std::string::npos);
  EXPECT_NE(reportJson(report).find("hapticell-ergonomics-report"), std::string::npos);
}

TEST(Report, PdfIsWrittenAndItsPagesAreDrawn) {
  const Report report = postureReport(inputFor(Language::kEnglish));
  const fs::path file = fs::temp_directory_path() / "hapticell_report_test.pdf";
  ASSERT_TRUE(writeReport(report, file));
  EXPECT_EQ(textOf(file).substr(0, 5), "%PDF-");
  fs::remove(file);
  EXPECT_EQ(reportPages(report), 1) << "one page a posture";
  EXPECT_EQ(reportPages(taskReport(inputFor(Language::kFrench))), 1) << "and one a task";
  const ReportPicture page = drawReportPage(report, 1, 600);
  ASSERT_EQ(page.pixels.size(), static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height));
  const auto inked = std::count_if(page.pixels.begin(), page.pixels.end(),
                                   [](std::uint32_t pixel) { return (pixel & 0xFFu) < 0x80u; });
  EXPECT_GT(inked, 2000);
  EXPECT_LT(static_cast<std::size_t>(inked), page.pixels.size() / 3);
}

TEST(Report, LongHeadingsOfATableStayInTheirColumns) {
  Report report;
  std::string words;
  for (int i = 0; i < 12; ++i) words += "heading ";
  ReportBlock table{"Table", {}, {words, words, words, words}};
  table.rows.push_back({{"a"}, {"b"}, {"c"}, {"d"}});
  report.blocks.push_back(table);
  for (const int width : {300, 1200}) {
    const ReportPicture page = drawReportPage(report, 1, width);
    const int column = page.width * 98 / 100;  // In the margin.
    for (int y = 0; y < page.height; ++y)
      EXPECT_GT(page.pixels[static_cast<std::size_t>(y * page.width + column)] & 0xFFu, 0xF0u) << y;
  }
}

TEST(Report, ATaskWithoutANameOfItsOwnIsCalledByTheReportsLanguage) {
  auto input = inputFor(Language::kFrench);
  input.task.name = WorkTask{}.name;
  EXPECT_EQ(reportCsv(postureReport(input)).find("Task"), std::string::npos);
}

TEST(Report, RefusesOtherEndingsAndFoldersThatAreNotThere) {
  const Report report = taskReport(inputFor(Language::kEnglish));
  const auto other = writeReport(report, "report.doc");
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().message().find(".pdf"), std::string::npos);
  for (const char* file : {"/nowhere/report.pdf", "/nowhere/report.html"})
    EXPECT_FALSE(writeReport(report, file)) << file;
}

TEST(Report, StripsJoinEqualNeighbours) {
  const auto strip = stripOf("x", {1, 1, 2, 2, 2, 0});
  ASSERT_EQ(strip.pieces.size(), 3u);
  EXPECT_NEAR(strip.pieces[1].first, 0.5, 1e-12);
  EXPECT_EQ(strip.pieces[1].second, 2);
}

}  // namespace
}  // namespace hapticell::ergonomics
