// SPDX-License-Identifier: Apache-2.0
// What the import panel says, and its picture, without a display.
#include "app/import/import_choices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "app/import/change_page.h"
#include "app/import/import_facts.h"
#include "app/import/import_report_text.h"
#include "app/import/preview_picture.h"
#include "app/import/remark_lines.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::app {
namespace {

TEST(ImportChoices, FinerIsMoreAndCoarserIsLess) {
  const ImportEstimate known{0.0002, 100000.0, 4.0};
  const ImportEstimate fine = estimate(known, MeshQuality::kMedium, MeshQuality::kFine);
  const ImportEstimate coarse = estimate(known, MeshQuality::kMedium, MeshQuality::kCoarse);
  EXPECT_GT(fine.triangles, known.triangles);
  EXPECT_GT(fine.seconds, known.seconds);
  EXPECT_LT(coarse.triangles, known.triangles);
  EXPECT_NEAR(fine.chord, 0.0002 * 6e-5 / 2.5e-4, 1e-12);
  const ImportEstimate back = estimate(fine, MeshQuality::kFine, MeshQuality::kMedium);
  EXPECT_NEAR(back.triangles, known.triangles, 1e-6);
  EXPECT_DOUBLE_EQ(estimate(known, MeshQuality::kFine, MeshQuality::kFine).triangles, known.triangles);
}

TEST(ImportChoices, TheEstimateIsWithinAFactorOfTwoOfRealParts) {
  // Triangles and seconds of processor as measured (hapticell-cli inspect --chord --angle): coarse, medium, fine.
  const struct {
    const char* part;
    double triangles[3], seconds[3];
  } measured[] = {{"as1-oc-214", {5156, 7580, 14344}, {0.24, 0.22, 0.29}},
                  {"linkrods", {5846, 19716, 57424}, {0.56, 0.75, 1.48}},
                  {"pulley", {948, 1716, 3708}, {0.25, 0.25, 0.29}},
                  {"NIST_MBE_PMI_2", {19550, 45242, 192744}, {1.91, 2.34, 3.95}}};
  const MeshQuality qualities[] = {MeshQuality::kCoarse, MeshQuality::kMedium, MeshQuality::kFine};
  for (const auto& part : measured) {
    for (const std::size_t to : {0u, 2u}) {
      const ImportEstimate told =
          estimate({1e-4, part.triangles[1], part.seconds[1]}, MeshQuality::kMedium, qualities[to]);
      EXPECT_LT(std::abs(std::log2(told.triangles / part.triangles[to])), 1.0) << part.part << to;
      EXPECT_LT(std::abs(std::log2(told.seconds / part.seconds[to])), 1.0) << part.part << to;
    }
  }
}

TEST(ImportChoices, TheOptionsSayWhatWasChosen) {
  ImportChoices choices;
  choices.metres_per_unit = 0.0254;
  choices.up_axis = workcell::UpAxis::kY;
  choices.quality = MeshQuality::kCoarse;
  choices.merge = true;
  const workcell::ImportOptions options = optionsOf(choices);
  EXPECT_EQ(options.metres_per_unit, 0.0254);
  EXPECT_EQ(options.up_axis, workcell::UpAxis::kY);
  EXPECT_DOUBLE_EQ(options.relative_chord, 1e-3);
  EXPECT_TRUE(options.merge);
}

TEST(ImportChoices, NumbersReadWell) {
  const QChar thin(0x202F);
  EXPECT_EQ(countText(7), "7");
  EXPECT_EQ(countText(184000), QStringLiteral("184") + thin + "000");
  EXPECT_EQ(countText(5005448), QStringLiteral("5") + thin + "005" + thin + "448");
  EXPECT_EQ(durationText(0.2), "under 1 s");
  EXPECT_EQ(durationText(6.4), "6 s");
  EXPECT_EQ(durationText(120), "2 min");
  EXPECT_EQ(unitText(0.0254), "inch");
  EXPECT_EQ(unitText(0.32), "0.32 m");
}

TEST(ImportChoices, TheReportNamesWhatWasRepairedAndDropped) {
  workcell::ImportReport report;
  report.parts = 3;
  report.triangles = 1200;
  report.metres_per_unit = 0.001;
  report.degenerate_triangles = 4;
  const QString text = reportText(report);
  EXPECT_TRUE(text.contains("3 parts")) << text.toStdString();
  EXPECT_TRUE(text.contains("one millimetre, from the file"));
  EXPECT_TRUE(text.contains("Removed: 4 zero-area triangles."));
  EXPECT_FALSE(text.contains("duplicate"));
}

workcell::Entity block(const dvec3& size, const dvec3& place, const std::array<float, 3>& color) {
  workcell::Entity entity;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(size))};
  entity.X_WE = Pose::translation(place);
  entity.color = color;
  return entity;
}

TEST(PreviewPicture, ShowsWhatIsInFrontOnATransparentGround) {
  // A dark plate stands before (nearer to -y) a bright one of the same size.
  const auto dark = block({1, 0.1, 1}, {0, -1, 0}, {0.1f, 0.1f, 0.1f});
  const auto bright = block({1, 0.1, 1}, {0, 0, 0}, {0.9f, 0.9f, 0.9f});
  const QSize size(200, 120);
  const QImage picture = previewPicture({bright, dark}, size);
  ASSERT_EQ(picture.size(), size);
  EXPECT_EQ(qAlpha(picture.pixel(0, 0)), 0);
  EXPECT_EQ(picture, previewPicture({dark, bright}, size)) << "the order has no say";
  const QImage alone = previewPicture({dark}, size);
  EXPECT_LT(qGray(alone.pixel(100, 60)), 80);
  EXPECT_TRUE(previewPicture({}, size).isNull());
}

TEST(ImportFacts, SizeAndLikelyUnitOfAFileThatNamesNone) {
  workcell::ImportResult result;
  result.entities.push_back(block({200, 100, 50}, {0, 0, 0}, {0.5f, 0.5f, 0.5f}));
  result.report.format = "stl";
  result.report.unit_is_stated = false;
  const ImportFacts facts = factsOf(result, "part.stl", QSize(80, 60));
  EXPECT_EQ(facts.format, "STL");
  EXPECT_NEAR(facts.size.x, 200.0, 1e-9);
  EXPECT_DOUBLE_EQ(facts.likely_metres_per_unit, 0.001);
  EXPECT_FALSE(facts.can_be_cut_finer);
}

TEST(RemarkLines, AreGroupedByKindAndKnowTheirParts) {
  workcell::Entity arm, clamp;
  arm.name = "arm";
  clamp.name = "it's clamped";
  auto robot = std::make_shared<kinematics::RobotModel>();
  robot->links.emplace_back().name = "boom";
  arm.body = workcell::Robot{{.model = robot}};
  NamedParts parts;
  addNames(arm, 3, parts);
  addNames(clamp, 5, parts);
  const auto lost = [](int line, const char* link, const char* file) {
    return Text("%1: %2", Text("line %1", line), Text("link '%1': its mesh %2 is not there", link, file));
  };
  const auto lines = remarkLines({lost(4, "boom", "a/b.stl"), "the file names no unit", lost(17, "foot", "c.dae"),
                                  Text("no color for %1", Text("%1 and %2 more", "'a', 'boom'", 3)),
                                  Text("no color for %1", "'arm'"), std::string("said by a library")},
                                 parts);
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0].kind, lines[1].kind);
  EXPECT_EQ(lines[0].kind, "line …: link '…': its mesh … is not there");
  EXPECT_EQ(lines[1].text, "line 17: link 'foot': its mesh c.dae is not there");
  EXPECT_EQ(lines[0].parts, std::vector<workcell::EntityId>{3}) << "a link is selected by its robot";
  EXPECT_TRUE(lines[1].parts.empty()) << "there is no such link";
  EXPECT_EQ(lines[2].kind, "the file names no unit");
  EXPECT_EQ(lines[3].kind, lines[4].kind) << "a list of names is no kind of its own";
  EXPECT_NE(lines[2].kind, lines[3].kind);
  EXPECT_EQ(lines[3].parts, std::vector<workcell::EntityId>{3});
  EXPECT_EQ(lines[4].parts, std::vector<workcell::EntityId>{3});
  EXPECT_EQ(lines[5].kind, lines[5].text) << "plain words have no kind but themselves";
  EXPECT_TRUE(remarkLines({}, parts).empty());
}

TEST(ChangePage, TellsMillimetresAndDegrees) {
  workcell::EntityChange moved;
  moved.name = "arm <1>";
  moved.entity_kind = "solid";
  moved.kind = workcell::EntityChange::Kind::kMoved;
  moved.X_WAfter = Pose::translation({0.1, 0, -0.0000001});
  moved.distance = 0.1;
  const QString page = changesAsHtml({moved}, "cell", "saved");
  EXPECT_TRUE(page.contains("arm &lt;1&gt;"));
  EXPECT_TRUE(page.contains("100.000"));
  EXPECT_FALSE(page.contains("-0.000")) << "a minus zero is never shown";
  EXPECT_TRUE(page.contains("1 moved, 0 added, 0 removed"));
}

}  // namespace
}  // namespace hapticell::app
