// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/contact_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <random>

#include "geometry/shapes/shapes.h"
#include "tests/collision/contacts/zone_scenes.h"

namespace hapticell::test {
namespace {

using collision::ContactFinder;

/// A mesh ready for both ways.
struct Body {
  explicit Body(const geometry::TriangleMesh& mesh)
      : pieces(collision::ConvexPieces::build(mesh)), surfaces(collision::SurfaceModel::build(mesh)) {}
  collision::ZonePart at(const Pose& X_W, std::uint64_t key) const {
    return {pieces.get(), X_W, key, 0.0, surfaces.get()};
  }
  std::shared_ptr<const collision::ConvexPieces> pieces;
  std::shared_ptr<const collision::SurfaceModel> surfaces;
};

geometry::TriangleMesh bumpy() {
  geometry::TriangleMesh mesh = geometry::makeSphere(0.02, 12);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.97, 1.03);
  for (dvec3& p : mesh.vertices) p *= uniform(random);
  return mesh;
}

bool isRound(const collision::ZoneContacts& set) {
  return std::any_of(set.contacts.begin(), set.contacts.end(), [](const auto& c) { return c.M_W != dmat3(0.0); });
}

TEST(ContactFinder, AgreesWithExactGeometryInSimpleScenes) {
  for (const ZoneScene& scene : simpleZoneScenes()) {
    ZoneBench bench(scene, ZoneBench::Ways::kBest);
    const ZoneReport report = bench.compare(400, 0.3);
    std::puts(line(report).c_str());
    EXPECT_TRUE(report.complete) << scene.name;
    EXPECT_LE(report.entries, 64u) << scene.name;
    EXPECT_EQ(report.holes, 0) << scene.name;
    EXPECT_LE(report.turned_holes, 0.01 * report.turned) << scene.name;
    if (scene.name == "sphere on box") continue;  // A ball meets the mitre of a box's corner.
    EXPECT_LE(report.false_walls, 0.01 * report.free) << scene.name;
  }
}

TEST(ContactFinder, TellsAPegBySurfacesAndAFreeFormByFacets) {
  const Body peg(geometry::makeCylinder(0.00995, 0.05, 64)), pipe(geometry::makePipe(0.03, 0.01, 0.05, 64));
  const Body box(geometry::makeBox(dvec3(0.02))), stone(bumpy());
  collision::ZoneOptions options;
  options.radius = 0.02;
  options.max_rotation = 0.05;
  ContactFinder finder;
  collision::ZoneContacts in_bore, on_stone;
  for (int i = 0; i < 30; ++i) {
    const auto held = peg.at(Pose::translation({0, 0, 0.02}), 1), fixed = pipe.at(Pose::identity(), 2);
    in_bore = finder.find({&held, 1}, {&fixed, 1}, options);
  }
  EXPECT_TRUE(in_bore.complete);
  EXPECT_FALSE(in_bore.facets);
  EXPECT_TRUE(isRound(in_bore));
  ContactFinder other;
  for (int i = 0; i < 30; ++i) {
    const auto held = box.at(Pose::translation({0, 0, 0.0325}), 1), fixed = stone.at(Pose::identity(), 2);
    on_stone = other.find({&held, 1}, {&fixed, 1}, options);
  }
  EXPECT_TRUE(on_stone.complete);
  EXPECT_TRUE(on_stone.facets);
  EXPECT_FALSE(isRound(on_stone));
}

TEST(ContactFinder, JoinsBothWaysInOneSetWithoutGapsInTheGroups) {
  const Body peg(geometry::makeCylinder(0.00995, 0.05, 64)), pipe(geometry::makePipe(0.03, 0.01, 0.05, 64));
  const Body stone(bumpy());
  const std::vector<collision::ZonePart> fixed{pipe.at(Pose::identity(), 2),
                                               stone.at(Pose::translation({0, 0, 0.0665}), 3)};
  collision::ZoneOptions options;
  options.radius = 0.005;
  options.max_rotation = 0.02;
  ContactFinder finder;
  collision::ZoneContacts set;
  for (int i = 0; i < 30; ++i) {
    const auto held = peg.at(Pose::translation({0, 0, 0.02}), 1);
    set = finder.find({&held, 1}, fixed, options);
  }
  ASSERT_TRUE(set.complete);
  EXPECT_LE(set.contacts.size(), options.max_entries);
  std::uint32_t expected = 0;
  bool of_pipe = false, of_stone = false;
  for (const auto& contact : set.contacts) {
    EXPECT_TRUE(contact.group == expected || contact.group == expected + 1);
    expected = contact.group;
    of_pipe = of_pipe || contact.environment_part == 0;
    of_stone = of_stone || contact.environment_part == 1;
  }
  EXPECT_EQ(set.groups, expected + 1);
  EXPECT_TRUE(of_pipe);
  EXPECT_TRUE(of_stone);
}

TEST(ContactFinder, TheSameQueriesGiveTheSameAnswers) {
  const Body beam(geometry::makeCylinder(0.006, 0.06, 32)), stone(bumpy());
  collision::ZoneOptions options;
  options.radius = 0.02;
  options.max_rotation = 0.1;
  ContactFinder one, two;
  for (int i = 0; i < 40; ++i) {
    const Pose X{dvec3(0.0005 * i - 0.01, 0.0, 0.028), quaternionFromRotationVector({1.57, 0.002 * i, 0.0})};
    const auto held = beam.at(X, 1), fixed = stone.at(Pose::identity(), 2);
    const auto a = one.find({&held, 1}, {&fixed, 1}, options), b = two.find({&held, 1}, {&fixed, 1}, options);
    ASSERT_EQ(a.contacts.size(), b.contacts.size());
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.work, b.work);
    for (std::size_t k = 0; k < a.contacts.size(); ++k) {
      EXPECT_EQ(a.contacts[k].id, b.contacts[k].id);
      EXPECT_EQ(a.contacts[k].gap, b.contacts[k].gap);
    }
  }
}

TEST(ContactFinder, AColdQueryEndsAndTheNextOnesFinishIt) {
  // Thousands of small facets about every place: more than one query may work out.
  const Body comb(geometry::makePipe(0.03, 0.0101, 0.05, 256)), peg(geometry::makeCylinder(0.01, 0.05, 256));
  const auto held = peg.at(Pose::translation({0, 0, 0.01}), 1), fixed = comb.at(Pose::identity(), 2);
  collision::ZoneOptions options;
  options.radius = 0.02;
  ContactFinder finder(ContactFinder::Ways::kSurfaces);
  std::size_t most_work = 0;
  collision::ZoneContacts set;
  for (int i = 0; i < 60; ++i) {
    set = finder.find({&held, 1}, {&fixed, 1}, options);
    most_work = std::max(most_work, set.work);
    EXPECT_FALSE(set.complete && set.pending);
  }
  EXPECT_TRUE(set.complete);
  EXPECT_LT(set.work, 2000u);
  EXPECT_LT(most_work, 40000u);  // about 20 ms, and what a last place costs beyond them
}

TEST(ContactFinder, ABallLargerThanTheZoneMeetsWhatIsUnderIt) {
  const Body ball(geometry::makeSphere(0.005, 42)), block(geometry::makeBox({0.025, 0.025, 0.01}));
  const auto fixed = block.at(Pose::translation({0, 0, -0.005}), 2);
  collision::ZoneOptions options;
  options.max_rotation = 0.02;
  for (const double zone : {0.0007, 0.002, 0.0045, 0.02}) {
    options.radius = zone;
    ContactFinder finder(ContactFinder::Ways::kSurfaces);
    collision::ZoneContacts set;
    const auto held = ball.at(Pose::translation({0.001, 0.002, 0.0051}), 1);
    for (int i = 0; i < 12; ++i) set = finder.find({&held, 1}, {&fixed, 1}, options);
    ASSERT_TRUE(set.complete) << zone;
    std::vector<double> of_group(set.groups, -1.0);  // The freest of each.
    for (const auto& contact : set.contacts) {
      const double gap = contact.has_trim ? std::min(contact.gap, contact.trim_gap) : contact.gap;
      of_group[contact.group] = std::max(of_group[contact.group], gap);
    }
    ASSERT_FALSE(of_group.empty()) << zone;
    const double least = *std::min_element(of_group.begin(), of_group.end());
    EXPECT_NEAR(least, 0.0001, 1e-6) << zone;
  }
}

/// A block along y with a slot 10 mm wide and 13 mm deep.
geometry::TriangleMesh slottedBlock() {
  const double outline[8][2] = {{-15, -10}, {15, -10}, {15, 8}, {5, 8}, {5, -5}, {-5, -5}, {-5, 8}, {-15, 8}};
  geometry::TriangleMesh mesh;
  for (const double y : {-0.02, 0.02}) {
    for (const auto& p : outline) mesh.vertices.push_back({1e-3 * p[0], y, 1e-3 * p[1]});
  }
  for (const auto& [a, b, c] :
       {std::array{0u, 1u, 4u}, {0u, 4u, 5u}, {1u, 2u, 3u}, {1u, 3u, 4u}, {0u, 5u, 6u}, {0u, 6u, 7u}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a + 8, c + 8, b + 8});
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t j = (i + 1) % 8;
    mesh.triangles.push_back({i, i + 8, j});
    mesh.triangles.push_back({j, i + 8, j + 8});
  }
  return mesh;
}

TEST(ContactFinder, ABallThatJustFitsASlotIsHeldByBothItsWalls) {
  const Body ball(geometry::makeSphere(0.005, 42)), block(slottedBlock());
  const auto fixed = block.at(Pose::identity(), 2), held = ball.at(Pose::translation({0, 0.001, 0.0001}), 1);
  collision::ZoneOptions options;
  options.max_rotation = 0.02;
  for (const double zone : {0.002, 0.004, 0.015}) {
    options.radius = zone;
    ContactFinder finder(ContactFinder::Ways::kSurfaces);
    collision::ZoneContacts set;
    for (int i = 0; i < 12; ++i) set = finder.find({&held, 1}, {&fixed, 1}, options);
    ASSERT_TRUE(set.complete) << zone;
    for (const dvec3& way : {dvec3(1e-3, 0, 0), dvec3(-1e-3, 0, 0)}) {
      std::vector<double> of_group(set.groups, -1.0);
      for (const auto& contact : set.contacts) {
        double value = contact.gap + glm::dot(contact.nhat_W, way);
        if (contact.has_trim) value = std::min(value, contact.trim_gap + glm::dot(contact.trim_nhat_W, way));
        of_group[contact.group] = std::max(of_group[contact.group], value);
      }
      ASSERT_FALSE(of_group.empty());
      EXPECT_LT(*std::min_element(of_group.begin(), of_group.end()), -0.5e-3) << zone << ' ' << way.x;
    }
  }
}

/// The zone (m) that is told at the `count` places after 30 queries where little of it can be told.
std::vector<double> zonesAfterACrowd(double needed_radius, int count) {
  const Body beam(geometry::makeCylinder(0.006, 0.06, 32)), stone(bumpy());
  const auto fixed = stone.at(Pose::identity(), 2);
  collision::ZoneOptions options;
  options.radius = 0.04;
  options.max_rotation = 0.02;
  options.needed_radius = needed_radius;
  ContactFinder finder;
  std::vector<double> zones;
  for (int i = 0; i < 30 + count; ++i) {
    const auto held = beam.at({dvec3(0.0, 0.0, i < 30 ? 0.0272 : 0.033), dquat(0.7, 0.1, 0.7, 0.1)}, 1);
    const collision::ZoneContacts set = finder.find({&held, 1}, {&fixed, 1}, options);
    EXPECT_TRUE(set.complete);
    EXPECT_LE(set.contacts.size(), options.max_entries);
    if (i >= 30) zones.push_back(set.radius);
  }
  return zones;
}

TEST(ContactFinder, WidensAtOnceForAHandThatMayRunIntoTheZonesEdge) {
  const std::vector<double> calm = zonesAfterACrowd(0.0, 12), hurried = zonesAfterACrowd(0.03, 12);
  for (std::size_t i = 0; i < calm.size(); ++i) {
    EXPECT_GE(hurried[i], calm[i] - 1e-12) << i;
  }
  EXPECT_LT(calm.front(), calm.back()) << "the second place has room for more";
  EXPECT_GT(std::accumulate(hurried.begin(), hurried.end(), 0.0), std::accumulate(calm.begin(), calm.end(), 0.0));
}

}  // namespace
}  // namespace hapticell::test
