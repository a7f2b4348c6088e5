// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/built_in_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <string>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/topology.h"
#include "workcell/document/document.h"
#include "workcell/document/part_resize.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

using testing::HasSubstr;

Entity made(const std::string& what, double scale = 1.0) {
  auto entity = makeBuiltInPart(what, scale);
  EXPECT_TRUE(entity) << what << ": " << (entity ? "" : entity.error().message());
  return entity ? std::move(*entity) : Entity{};
}

TEST(BuiltInParts, EveryOneIsClosedAndStandsWhereItsOriginSays) {
  for (const BuiltInPart& part : builtInParts()) {
    const std::string what = std::string(part.scheme) + ":";
    const Entity entity = made(what);
    ASSERT_TRUE(entity.mesh()) << what;
    EXPECT_TRUE(geometry::isClosed(*entity.mesh())) << what;
    EXPECT_GT(geometry::massProperties(*entity.mesh()).volume, 0.0) << what << " faces outwards";
    const geometry::Bounds bounds = entity.mesh()->bounds();
    EXPECT_NEAR(bounds.min.x + bounds.max.x, 0.0, 1e-9) << what;
    EXPECT_NEAR(bounds.min.y + bounds.max.y, 0.0, 1e-9) << what;
    if (part.origin == BuiltInPart::Origin::kMiddle) {
      EXPECT_NEAR(bounds.min.z + bounds.max.z, 0.0, 1e-9) << what;
    } else {
      EXPECT_NEAR(bounds.min.z, 0.0, 1e-9) << what;
    }
    EXPECT_TRUE(isBuiltIn(what));
    EXPECT_EQ(entity.source.path, what);
    EXPECT_EQ(entity.color, part.color);
  }
}

TEST(BuiltInParts, TheirSizesAreWrittenWithAPointWhateverTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"C", "de_DE.UTF-8", "fr_FR.UTF-8"}) {
    std::setlocale(LC_ALL, locale);  // some of them may not be installed
    EXPECT_EQ(partSource(*findBuiltInPart("box"), {0.5, 1.25, 3.0}), "box:0.5,1.25,3") << locale;
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(BuiltInParts, AreAsLargeAsTheirSizesSay) {
  const std::pair<const char*, dvec3> cases[] = {
      {"table:1.4,0.7,0.8", {1.4, 0.7, 0.8}},    {"shelf:1,0.4,2", {1.0, 0.4, 2.0}},
      {"cabinet:0.9,0.5,1.2", {0.9, 0.5, 1.2}},  {"fence:4,2.2", {4.0, 0.05, 2.2}},
      {"conveyor:3,0.6,0.95", {3.0, 0.6, 0.95}}, {"pallet:1.2,0.8", {1.2, 0.8, 0.144}},
      {"cone:0.2,0.5", {0.4, 0.4, 0.5}},         {"pipe:0.2,0.1,0.5", {0.4, 0.4, 0.5}},
  };
  for (const auto& [what, size] : cases) {
    const geometry::Bounds bounds = made(what).mesh()->bounds();
    EXPECT_LT(glm::length(bounds.max - bounds.min - size), 1e-9) << what;
  }
  EXPECT_NEAR(made("stool:0.65").mesh()->bounds().max.z, 0.65, 1e-12);
  EXPECT_NEAR(made("table:1400,700,800", 0.001).mesh()->bounds().max.x, 0.7, 1e-12) << "in millimetres";
  // The volume by hand: a top of 30 mm and four legs of 60 x 60 mm.
  EXPECT_NEAR(geometry::massProperties(*made("table:1,1,1").mesh()).volume, 0.03 + 4 * 0.06 * 0.06 * 0.97, 1e-9);
}

TEST(BuiltInParts, TheBenchIsAdjustableAndItsSizesComeBackFromItsSource) {
  const Entity bench = made("bench:1400,700,1050", 0.001);
  const geometry::Bounds bounds = bench.mesh()->bounds();
  EXPECT_LT(glm::length(bounds.max - bounds.min - dvec3(1.4, 0.7, 1.05)), 1e-9);
  const std::vector<double> sizes = partSizes(bench.source);
  ASSERT_EQ(sizes.size(), 3u);
  EXPECT_LT(glm::length(dvec3(sizes[0], sizes[1], sizes[2]) - dvec3(1.4, 0.7, 1.05)), 1e-12);
  EXPECT_EQ(partSizes(made("stool:").source), std::vector<double>{0.6});
  EXPECT_TRUE(partSizes({"table.stl", 1.0}).empty());
  EXPECT_EQ(partSource(*findBuiltInPart("bench"), {1.4, 0.7, 1.05}), "bench:1.4,0.7,1.05");
}

TEST(BuiltInParts, AResizedBenchLiftsWhatIsAttachedToIt) {
  Document document;
  Entity bench = made("bench:1.2,0.8,0.9"), vise = made("box:0.1,0.1,0.1"), free = made("box:0.1,0.1,0.1");
  bench.name = "Bench", vise.name = "Vise", free.name = "Free";
  vise.X_WE.p = free.X_WE.p = {0.2, 0.0, 0.95};
  const auto id = document.execute(AddEntity{bench});
  const auto vise_id = document.execute(AddEntity{vise}), free_id = document.execute(AddEntity{free});
  ASSERT_TRUE(id && vise_id && free_id);
  ASSERT_TRUE(document.execute(Attach{*vise_id, *id, {}}));
  const auto commands = resizePart(document.state(), *id, {1.2, 0.8, 1.05});
  ASSERT_TRUE(commands) << commands.error().message();
  for (const Command& command : *commands) ASSERT_TRUE(document.execute(command));
  EXPECT_NEAR(document.find(*id)->mesh()->bounds().max.z, 1.05, 1e-12);
  EXPECT_EQ(document.find(*id)->source.path, "bench:1.2,0.8,1.05");
  EXPECT_NEAR(document.find(*vise_id)->X_WE.p.z, 1.10, 1e-12);
  EXPECT_NEAR(document.find(*free_id)->X_WE.p.z, 0.95, 1e-12);
  const auto low = resizePart(document.state(), *id, {1.2, 0.8, 0.2});
  ASSERT_FALSE(low);
  EXPECT_THAT(low.error().message(), HasSubstr("height (0.6 m or more)"));
  EXPECT_FALSE(resizePart(document.state(), 99, {1.0}));
}

TEST(BuiltInParts, ThePalletIsAsHeavyAsTheOneItIsDrawnAfter) {
  // 0.8 x 1.2 m, dry spruce of some 450 kg/m3: the standard's pallet weighs 20 to 24 kg.
  const double mass = 450.0 * geometry::massProperties(*made("pallet:1.2,0.8").mesh()).volume;
  EXPECT_GT(mass, 17.0);
  EXPECT_LT(mass, 27.0);
}

TEST(BuiltInParts, NoFingerReachesThroughTheFence) {
  // ISO 13857, table 4: openings of more than 120 mm let an arm through; the bars leave less than that.
  for (const double length : {0.3, 1.0, 1.55, 3.0, 7.3}) {
    const Entity fence = made("fence:" + std::to_string(length) + ",2");
    std::vector<double> at;  // Where bars and posts cross half the height.
    for (const dvec3& vertex : fence.mesh()->vertices)
      if (vertex.z < 0.2 || vertex.z > 1.9) at.push_back(vertex.x);
    std::sort(at.begin(), at.end());
    for (std::size_t i = 1; i < at.size(); ++i) EXPECT_LT(at[i] - at[i - 1], 0.12) << length;
  }
}

TEST(BuiltInParts, SizesThatCannotBeUsedAreRefusedAndTheSentenceSaysWhichCan) {
  for (const char* what : {"box:1,2", "box:1,2,3,4", "box:0,1,1", "box:1,1,x", "table:1,1,0.01", "pipe:0.1,0.2,1",
                           "sphere:-1", "sphere:nan", "sphere:1e300", "fence:1"}) {
    const auto refused = makeBuiltInPart(what, 1.0);
    ASSERT_FALSE(refused) << what;
    EXPECT_THAT(refused.error().message(), HasSubstr(what));
    EXPECT_THAT(refused.error().message(), HasSubstr("invalid dimensions"));
  }
  EXPECT_THAT(makeBuiltInPart("table:1", 1.0).error().message(), HasSubstr("width (0.2 m or more), depth"));
  EXPECT_FALSE(isBuiltIn("fence.stl"));
  EXPECT_FALSE(isBuiltIn("wardrobe:1"));
}

}  // namespace
}  // namespace hapticell::workcell
