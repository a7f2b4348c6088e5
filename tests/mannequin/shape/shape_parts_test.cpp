// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/shapes/mass_properties.h"
#include "mannequin/posture/posture.h"
#include "mannequin/shape/blob_distance.h"
#include "mannequin/shape/body_sections.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_outline.h"
#include "mannequin/shape/hair_shape.h"
#include "mannequin/shape/section_tube.h"
#include "mannequin/shape/surface_nets.h"
#include "tests/mannequin/body/median_man.h"

namespace hapticell::mannequin {
namespace {

TEST(SectionTube, TheGirthOfACircleAndOfAnEllipse) {
  const TubeSection circle{.half_breadth = 0.1, .front = 0.1, .back = 0.1};
  EXPECT_NEAR(perimeterOf(circle), 2.0 * std::numbers::pi * 0.1, 2e-4);
  // Ramanujan's second formula.
  const double a = 0.2, b = 0.1, h = (a - b) * (a - b) / ((a + b) * (a + b));
  const double ellipse = std::numbers::pi * (a + b) * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
  EXPECT_NEAR(perimeterOf({.half_breadth = a, .front = b, .back = b}), ellipse, 5e-4);
  EXPECT_NEAR(perimeterOf({.half_breadth = 0.1, .front = 0.1, .back = 0.1, .roundness = 60.0}), 0.8, 0.02)
      << "nearly square";
}

TEST(SectionTube, ASectionTakesTheGirthThatItIsGiven) {
  const TubeSection start{.half_breadth = 0.15, .front = 0.12, .back = 0.08};
  for (const double girth : {0.7, 0.8, 0.9, 1.2}) {
    const TubeSection round = withGirth(start, girth);
    EXPECT_NEAR(perimeterOf(round), girth, 1e-4);
    EXPECT_GE(round.roundness, 1.9);
    EXPECT_LE(round.roundness, 3.6);
    EXPECT_NEAR(round.front / round.half_breadth, start.front / start.half_breadth, 1e-12) << "the proportions stay";
  }
  const TubeSection broad = asBroadAs(start, 0.75);
  EXPECT_NEAR(perimeterOf(broad), 0.75, 1e-4);
  EXPECT_EQ(broad.front, start.front);
  EXPECT_EQ(broad.roundness, start.roundness);
}

SectionTube cone() {
  return SectionTube({1.0, 2.0, 3.0}, {0, 0, 1}, {1, 0, 0},
                     {{.t = 0.0, .half_breadth = 0.1, .front = 0.1, .back = 0.1},
                      {.t = 0.5, .half_breadth = 0.1, .front = 0.1, .back = 0.1},
                      {.t = 1.0, .half_breadth = 0.05, .front = 0.05, .back = 0.05}});
}

TEST(SectionTube, SectionsAreMetAndBetweenThemNothingOvershoots) {
  const SectionTube tube = cone();
  EXPECT_EQ(tube.at(-1.0).half_breadth, 0.1);
  EXPECT_EQ(tube.at(9.0).half_breadth, 0.05);
  for (const TubeSection& section : tube.sections())
    EXPECT_NEAR(tube.at(section.t).half_breadth, section.half_breadth, 1e-12);
  double before = 0.1;
  for (double t = 0.0; t <= 1.0; t += 0.01) {
    const double now = tube.at(t).half_breadth;
    EXPECT_LE(now, before + 1e-12);
    EXPECT_LE(now, 0.1 + 1e-12);
    EXPECT_GE(now, 0.05 - 1e-12);
    before = now;
  }
}

TEST(SectionTube, TheDistanceIsThatOfACylinderBesideIt) {
  const SectionTube tube = cone();
  EXPECT_NEAR(tube.distance({1.15, 2.0, 3.25}), 0.05, 1e-9);
  EXPECT_NEAR(tube.distance({1.0, 2.08, 3.25}), -0.02, 1e-9);
  EXPECT_LT(tube.distance({1.0, 2.0, 3.25}), -0.05) << "on the axis";
  EXPECT_GT(tube.distance({1.0, 2.0, 4.2}), 0.0) << "beyond the round end";
  for (const double far : {0.5, 2.0}) {
    const double said = tube.distance({1.0 + far, 2.0, 3.25});
    EXPECT_GT(said, 0.08);
    EXPECT_LE(said, far - 0.1 + 1e-9) << "a bound below the distance";
  }
  EXPECT_LT(glm::distance(tube.place(0.5, 0.1, 0.2), dvec3(1.1, 2.2, 3.5)), 1e-12) << "u across, v = axis x u";
  const geometry::Bounds bounds = tube.bounds();
  for (double angle = 0.0; angle < 6.3; angle += 0.3) {
    const dvec3 on = tube.place(0.3, 0.1 * std::cos(angle), 0.1 * std::sin(angle));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(bounds.min, on)) && glm::all(glm::lessThanEqual(on, bounds.max)));
  }
}

GridField ballField(double radius, double cell) {
  return {.bounds = {dvec3(-radius), dvec3(radius)},
          .cell = cell,
          .evaluate = [radius](const dvec3&, double, const std::vector<dvec3>& points, std::vector<double>& values) {
            values.resize(points.size());
            for (std::size_t i = 0; i < points.size(); ++i)
              values[i] = glm::length(points[i] - dvec3(0.003, -0.002, 0.001)) - 0.9 * radius;
          }};
}

TEST(SurfaceNets, ABallIsAClosedMeshOfItsVolumeFacingOutward) {
  const geometry::TriangleMesh coarse = surfaceOf(ballField(0.1, 0.02)), fine = surfaceOf(ballField(0.1, 0.005));
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(0.09, 3);
  for (const geometry::TriangleMesh* mesh : {&coarse, &fine}) {
    EXPECT_TRUE(geometry::isClosed(*mesh));
    EXPECT_GT(geometry::massProperties(*mesh).volume, 0.0) << "outward";
  }
  EXPECT_NEAR(geometry::massProperties(fine).volume, volume, 0.02 * volume);
  EXPECT_NEAR(geometry::massProperties(coarse).volume, volume, 0.15 * volume);
  for (const dvec3& v : fine.vertices) EXPECT_NEAR(glm::length(v - dvec3(0.003, -0.002, 0.001)), 0.09, 0.0025);
  geometry::TriangleMesh smooth = coarse;
  smoothSkin(smooth);
  EXPECT_EQ(smooth.triangles, coarse.triangles);
  EXPECT_NEAR(geometry::massProperties(smooth).volume, geometry::massProperties(coarse).volume, 0.08 * volume)
      << "without shrinking";
}

TEST(SurfaceNets, AFieldThatIsNowhereZeroHasNoSurface) {
  GridField nothing = ballField(0.1, 0.02);
  nothing.evaluate = [](const dvec3&, double, const std::vector<dvec3>& points, std::vector<double>& values) {
    values.assign(points.size(), 1.0);
  };
  EXPECT_TRUE(surfaceOf(nothing).triangles.empty());
}

TEST(BlobDistance, OfACapsuleIsExactAndASignTellsTheInside) {
  const Blob capsule{.a = {0, 0, 0}, .b = {0, 0, 0.3}, .ra = 0.05, .rb = 0.05};
  EXPECT_NEAR(distanceTo(capsule, {0.1, 0.0, 0.1}), 0.05, 1e-9);
  EXPECT_NEAR(distanceTo(capsule, {0.0, 0.0, 0.4}), 0.05, 1e-9);
  EXPECT_NEAR(distanceTo(capsule, {0.0, 0.0, 0.1}), -0.05, 1e-9);
  const Blob ball{.a = {0.1, 0, 0}, .b = {0.1, 0, 0}, .ra = 0.02, .rb = 0.02};
  EXPECT_NEAR(distanceTo(ball, {0.1, 0.05, 0.0}), 0.03, 1e-9);
}

TEST(BlobDistance, ATaperedOneIsWithinItsEnds) {
  const Blob cone_blob{.a = {0, 0, 0}, .b = {0, 0, 0.2}, .ra = 0.06, .rb = 0.02};
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  for (int i = 0; i < 500; ++i) {
    const dvec3 p(uniform(random), uniform(random), uniform(random));
    double least = 1e9;  // of the balls along it
    for (int k = 0; k <= 400; ++k) {
      const double s = k / 400.0;
      least = std::min(least, glm::distance(p, dvec3(0, 0, 0.2 * s)) - (0.06 - 0.04 * s));
    }
    EXPECT_NEAR(distanceTo(cone_blob, p), least, 0.02);
  }
}

TEST(BodySections, RiseAlongTheirAxisAndHaveTheSizesOfABody) {
  const Figure man = medianMan();
  const auto is_rising = [](const std::vector<TubeSection>& sections) {
    return sections.size() >= 2 &&
           std::is_sorted(sections.begin(), sections.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  };
  const auto trunk = trunkSections(man), arm = armSections(man, 1.0), leg = legSections(man, 1.0),
             neck = neckSections(man, 0.1);
  for (const auto& sections : {trunk, arm, leg, neck, trouserSections(man)}) {
    EXPECT_TRUE(is_rising(sections));
    for (const TubeSection& section : sections) {
      EXPECT_GT(section.half_breadth, 0.005);
      EXPECT_LT(section.half_breadth, 0.3);
      EXPECT_GT(section.front + section.back, 0.01);
    }
  }
  double waist = 1e9, chest = 0.0;
  for (const TubeSection& section : trunk) {
    waist = std::min(waist, perimeterOf(section));
    chest = std::max(chest, perimeterOf(section));
  }
  EXPECT_GT(chest, 0.85);
  EXPECT_LT(chest, 1.35) << "the girth of a median man's chest is about a metre";
  const auto other = armSections(man, -1.0);
  ASSERT_EQ(other.size(), arm.size());
  for (std::size_t i = 0; i < arm.size(); ++i)
    EXPECT_NEAR(perimeterOf(arm[i]), perimeterOf(other[i]), 1e-9) << "the mirrored arm";
}

TEST(HairShape, IsAClosedCapAboutTheSkull) {
  for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
    const Figure figure = *makeFigure({sex, 1.7});
    const geometry::TriangleMesh hair = hairMesh(figure, 0.008);
    ASSERT_FALSE(hair.triangles.empty());
    EXPECT_TRUE(geometry::isClosed(hair));
    const geometry::Bounds bounds = hair.bounds();
    EXPECT_GT(bounds.max.z, figure.p_HeadVertex.z - 0.01) << "over the top of the head";
    EXPECT_LT(bounds.max.z, figure.p_HeadVertex.z + 0.03);
    EXPECT_LT(bounds.size().y, 0.25);
  }
}

TEST(FigureOutline, ShowsEachBodyFromTheEyeTheFurthestFirst) {
  const Figure man = medianMan();
  const std::vector<Flesh> flesh = fleshOf(man);
  const Posture posture = *libraryPosture(man, "zero");
  const OutlineView view = OutlineView::besides(posture);
  EXPECT_NEAR(glm::length(view.right_W), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(view.right_W, view.up_W), 0.0, 1e-12);
  const auto parts = outlineOf(man, posture, flesh, view);
  ASSERT_GT(parts.size(), 10u);
  EXPECT_TRUE(
      std::is_sorted(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.depth < b.depth; }));
  double low = 1e9, high = -1e9;
  for (const OutlinePart& part : parts) {
    EXPECT_LT(part.body, kSegmentCount) << "fingers are left out";
    for (const auto& shape : part.shapes) {
      for (const glm::dvec2& p : shape) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
      }
    }
  }
  EXPECT_NEAR(high - low, man.body[Dimension::kStature], 0.06) << "as tall as the figure";
}

}  // namespace
}  // namespace hapticell::mannequin
