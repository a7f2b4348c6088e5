// SPDX-License-Identifier: Apache-2.0
// The steps between two bodies and the rows of their contacts, one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "collision/contacts/crossing_rods.h"
#include "collision/contacts/direction_choice.h"
#include "collision/contacts/facet_query.h"
#include "collision/contacts/group_reduction.h"
#include "collision/contacts/placed_part.h"
#include "collision/contacts/ring_fit.h"
#include "collision/contacts/surface_query.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::collision {
namespace {

TEST(PlacedPart, BoxesGrowAndOverlapTouchingCounts) {
  const geometry::Bounds unit{dvec3(0.0), dvec3(1.0)};
  EXPECT_EQ(grown(unit, 0.5).min, dvec3(-0.5));
  EXPECT_EQ(grown(unit, 0.5).max, dvec3(1.5));
  EXPECT_TRUE(overlap(unit, {dvec3(1.0, 0.0, 0.0), dvec3(2.0)}));
  EXPECT_FALSE(overlap(unit, {dvec3(1.0 + 1e-12, 0.0, 0.0), dvec3(2.0)}));
  EXPECT_TRUE(overlap(unit, {dvec3(0.4), dvec3(0.5)})) << "one holds the other";
}

TEST(PlacedPart, PiecesArePlacedOnceAndFoundNearABox) {
  const auto pieces = ConvexPieces::build(geometry::makePipe(0.05, 0.03, 0.1, 16));
  const Pose X_W{{1.0, 2.0, 3.0}, glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, 3)))};
  PlacedPart part({.pieces = pieces.get(), .X_W = X_W});
  EXPECT_FALSE(part.isOnDemand());
  EXPECT_FALSE(part.isLarge());
  EXPECT_EQ(&part.piece(3), &part.piece(3));
  const auto& hull = pieces->pieces()[3].hull;
  for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
    EXPECT_LT(glm::distance(part.piece(3).vertices_W[i], X_W * hull.vertices[i]), 1e-12);
  }
  EXPECT_EQ(part.near(part.bounds()).size(), pieces->pieces().size());
  EXPECT_TRUE(part.near({dvec3(9.0), dvec3(10.0)}).empty());
  const dvec3 corner = X_W * hull.vertices[0];
  const auto found = part.near({corner - dvec3(1e-4), corner + dvec3(1e-4)});
  EXPECT_NE(std::find(found.begin(), found.end(), 3u), found.end());
  EXPECT_LT(found.size(), pieces->pieces().size());
  std::vector<std::uint32_t> of_label;
  part.appendPieces(5, of_label);
  EXPECT_EQ(of_label, (std::vector<std::uint32_t>{5}));
  EXPECT_EQ(part.labelled().labels, pieces->pieces().size());
}

/// A body's upright edge that points out along +x, and an obstacle's edge along y that points out along -x.
class CrossedEdges : public testing::Test {
 protected:
  BodyRod upright_{.a_M = {0, 0, -0.1},
                   .b_M = {0, 0, 0.1},
                   .n1_M = glm::normalize(dvec3(1, 1, 0)),
                   .n2_M = glm::normalize(dvec3(1, -1, 0))};
  BodyRod level_{.a_M = {0, -0.1, 0},
                 .b_M = {0, 0.1, 0},
                 .n1_M = glm::normalize(dvec3(-1, 0, 1)),
                 .n2_M = glm::normalize(dvec3(-1, 0, -1))};
  std::vector<ContactGroup> groupsAt(const dvec3& p_WM, double reach = 0.05) const {
    std::vector<ContactGroup> groups;
    appendCrossing(placed(upright_, Pose::translation(p_WM)), placed(level_, {}), reach, ContactGroup{}, groups);
    return groups;
  }
};

TEST_F(CrossedEdges, AreHeldApartAlongTheirCommonNormal) {
  const auto groups = groupsAt({-0.01, 0.02, 0.03});
  ASSERT_EQ(groups.size(), 1u);
  const ContactRow& row = groups[0].rows[0];
  EXPECT_NEAR(row.gap, 0.01, 1e-12);
  EXPECT_LT(glm::distance(row.nhat_W, dvec3(-1, 0, 0)), 1e-12) << "the way in which the moving one gets free";
  EXPECT_LT(glm::distance(row.p_W, dvec3(-0.01, 0.02, 0.0)), 1e-12);
  EXPECT_TRUE(row.isPlane());
}

TEST_F(CrossedEdges, PastTheOtherOnesEndIsAnAlternative) {
  const auto groups = groupsAt({-0.01, 0.09, 0.0});
  ASSERT_EQ(groups.size(), 1u);
  bool is_there = false;
  for (const ContactRow& row : groups[0].rows) {
    if (row.kind == 0) continue;
    is_there = is_there || (row.nhat_W.y > 0.99 && std::abs(row.gap + 0.01) < 1e-12);
    EXPECT_LT(row.gap, 0.0);
  }
  EXPECT_TRUE(is_there) << "10 mm along y and it is free";
}

TEST_F(CrossedEdges, ThoseThatPointAwayOrAreFarCannotTouch) {
  EXPECT_TRUE(groupsAt({-0.06, 0.0, 0.0}).empty()) << "beyond the reach";
  EXPECT_TRUE(groupsAt({-0.01, 0.2, 0.0}).empty()) << "past the end by more than the reach";
  std::vector<ContactGroup> groups;
  BodyRod turned = upright_;
  turned.n1_M.x = turned.n2_M.x = -turned.n1_M.x;
  appendCrossing(placed(turned, Pose::translation({-0.01, 0, 0})), placed(level_, {}), 0.05, ContactGroup{}, groups);
  EXPECT_TRUE(groups.empty()) << "it points away: other features touch first";
}

TEST_F(CrossedEdges, ParallelCylindersAreHeldByTheirRadii) {
  const BodyRod axis{.a_M = {0, 0, -0.1}, .b_M = {0, 0, 0.1}, .radius = 0.02, .n1_M = {1, 0, 0}, .cosine = -1.0};
  std::vector<ContactGroup> groups;
  appendCrossing(placed(axis, Pose::translation({0.05, 0.0, 0.04})), placed(axis, {}), 0.05, ContactGroup{}, groups);
  ASSERT_EQ(groups.size(), 2u) << "one for either end of where they lie along each other";
  for (const ContactGroup& group : groups) {
    const ContactRow& row = group.rows[0];
    EXPECT_NEAR(row.gap, 0.01, 1e-12);
    EXPECT_LT(glm::distance(row.nhat_W, dvec3(1, 0, 0)), 1e-12);
    EXPECT_NEAR(row.bend, 1.0 / 0.04, 1e-9);
    // Round the other one's axis the distance stays as it is: gap = |e| - r with e = (gap + r) n + d.
    const dvec3 d(-0.05 * (1.0 - std::cos(0.3)), 0.05 * std::sin(0.3), 0.0);
    const dvec3 e = row.gap * row.nhat_W + d;
    EXPECT_NEAR(glm::dot(row.nhat_W, e) + 0.5 * glm::dot(e, row.M_W * e), 0.01, 2e-3);
  }
  EXPECT_NE(groups[0].id, groups[1].id);
}

/// A cube in the corner between a floor and a wall: groups of pieces as a facet query makes them.
class CornerGroups : public testing::Test {
 protected:
  CornerGroups() {
    for (const auto& [piece, at] : {std::pair{&floor_, dvec3(0, 0, -0.5)}, {&wall_, dvec3(-0.5, 0, 0)}}) {
      const PlacedPiece moving = placed(cube_->pieces()[0], Pose::translation({0.06, 0.0, 0.07}));
      PieceGroup group;
      group.environment_piece = static_cast<std::uint32_t>(groups_.size());
      group.directions = separatingDirections(moving, placed((*piece)->pieces()[0], Pose::translation(at)), limits_);
      for (SeparatingDirection& direction : group.directions) {
        completeSupports(direction, moving, placed((*piece)->pieces()[0], Pose::translation(at)), limits_);
      }
      groups_.push_back(group);
    }
  }
  static double byHand(const PieceGroup& group, const dvec3& d) {
    double most = -1e300;
    for (const SeparatingDirection& direction : group.directions) {
      most = std::max(most, direction.gap + glm::dot(direction.nhat_W, d));
    }
    return most;
  }
  static double chosenAt(const PieceGroup& group, const dvec3& d) {
    double most = -1e300;
    for (const std::uint32_t i : group.chosen) {
      const SeparatingDirection& direction = group.directions[i];
      most = std::max(most, direction.gap - direction.tightened + glm::dot(direction.nhat_W, d));
    }
    return most;
  }
  dvec3 shift() {
    std::uniform_real_distribution<double> uniform(-0.05, 0.05);
    return {uniform(random_), uniform(random_), uniform(random_)};
  }
  DirectionLimits limits_{.reach = 0.06, .max_rotation = 0.1};
  std::shared_ptr<const ConvexPieces> cube_ = ConvexPieces::build(geometry::makeBox(dvec3(0.1)));
  std::shared_ptr<const ConvexPieces> floor_ = ConvexPieces::build(geometry::makeBox(dvec3(2.0, 2.0, 1.0)));
  std::shared_ptr<const ConvexPieces> wall_ = ConvexPieces::build(geometry::makeBox(dvec3(1.0, 2.0, 2.0)));
  std::vector<PieceGroup> groups_;
  std::mt19937 random_{3};
};

TEST_F(CornerGroups, SeparationIsTheLargestOverTheDirections) {
  for (int i = 0; i < 200; ++i) {
    const dvec3 d = shift();
    for (const PieceGroup& group : groups_) EXPECT_NEAR(separationAt(group, d), byHand(group, d), 1e-12);
  }
  EXPECT_NEAR(separationAt(groups_[0], dvec3(0.0)), 0.02, 1e-12);
  EXPECT_NEAR(separationAt(groups_[1], dvec3(0.0)), 0.01, 1e-12);
}

TEST_F(CornerGroups, TheChosenDirectionsCallNothingFreeThatIsNot) {
  chooseDirections(groups_, limits_);
  int free = 0;
  for (const PieceGroup& group : groups_) {
    ASSERT_FALSE(group.chosen.empty());
    const auto best = std::max_element(group.directions.begin(), group.directions.end(),
                                       [](const auto& a, const auto& b) { return a.gap < b.gap; });
    EXPECT_NEAR(group.directions[group.chosen[0]].gap, best->gap, 1e-12) << "the best comes first";
    for (int i = 0; i < 300; ++i) {
      const dvec3 d = shift();
      if (chosenAt(group, d) <= 0.0) continue;
      ++free;
      EXPECT_GT(separationAt(group, d), 0.0);
    }
  }
  EXPECT_GT(free, 100);
}

TEST_F(CornerGroups, AGroupThatIsImpliedGoesAndNothingGetsFreer) {
  PieceGroup beside = groups_[0];  // the same floor once more, a hair deeper
  beside.environment_piece = 7;
  for (SeparatingDirection& direction : beside.directions) direction.gap += 5e-7;
  std::vector<PieceGroup> groups = groups_;
  groups.push_back(beside);
  chooseDirections(groups, limits_);
  const std::vector<PieceGroup> before = groups;
  reduceGroups(groups, limits_, {0.06, 0.0, 0.07}, {.absolute = 1e-6});
  EXPECT_EQ(groups.size(), 2u);
  for (int i = 0; i < 500; ++i) {
    const dvec3 d = shift();
    double least_before = 1e300, least_after = 1e300;
    for (const PieceGroup& group : before) least_before = std::min(least_before, chosenAt(group, d));
    for (const PieceGroup& group : groups) least_after = std::min(least_after, chosenAt(group, d));
    EXPECT_LE(least_after, least_before + 1e-9);
    EXPECT_GE(least_after, least_before - 2e-6) << "by the tolerance at most";
  }
}

/// A cube over a plate, both with facets and surfaces.
class CubeOverPlate : public testing::Test {
 protected:
  ZonePart moving(const Pose& X_W) const {
    return {.pieces = cube_.get(), .X_W = X_W, .key = 1, .surfaces = cube_model_.get()};
  }
  ZonePart plate() const {
    return {.pieces = plate_.get(), .X_W = Pose::translation({0, 0, -0.05}), .key = 2, .surfaces = plate_model_.get()};
  }
  geometry::TriangleMesh cube_mesh_ = geometry::makeBox(dvec3(0.1)),
                         plate_mesh_ = geometry::makeBox(dvec3(1.0, 1.0, 0.1));
  std::shared_ptr<const ConvexPieces> cube_ = ConvexPieces::build(cube_mesh_),
                                      plate_ = ConvexPieces::build(plate_mesh_);
  std::shared_ptr<const SurfaceModel> cube_model_ = SurfaceModel::build(cube_mesh_),
                                      plate_model_ = SurfaceModel::build(plate_mesh_);
};

/// min over groups of max over entries, after a translation of the moving part.
double clearanceAfter(const ZoneContacts& set, const dvec3& d) {
  double least = 1e300;
  for (std::uint32_t group = 0; group < set.groups; ++group) {
    double most = -1e300;
    for (const ZoneContact& contact : set.contacts) {
      if (contact.group != group) continue;
      const dvec3 e = contact.gap * contact.nhat_W + d;
      double value = glm::dot(contact.nhat_W, e) + 0.5 * glm::dot(e, contact.M_W * e);
      if (contact.has_trim) value = std::min(value, contact.trim_gap + glm::dot(contact.trim_nhat_W, d));
      most = std::max(most, value);
    }
    least = std::min(least, most);
  }
  return least;
}

TEST_F(CubeOverPlate, FacetsAndSurfacesTellTheSameClearance) {
  const ZonePart part[] = {moving(Pose::translation({0.1, 0.0, 0.07}))}, obstacle[] = {plate()};
  ZoneOptions options;
  options.radius = 0.06;
  FacetQuery facets(part, obstacle, options);
  const auto by_facets = facets.attempt(0.06, FacetQuery::Detail::kAny, 64);
  SignatureCaches caches;
  SurfaceQuery surfaces(caches, part, obstacle, options);
  const auto by_surfaces = surfaces.attempt(0.06, 64);
  ASSERT_TRUE(by_facets && by_surfaces);
  EXPECT_FALSE(surfaces.isRough() || surfaces.isCold());
  EXPECT_GT(facets.work(), 0u);
  for (const double z : {-0.04, -0.03, -0.02, -0.01, 0.0, 0.02}) {
    EXPECT_NEAR(clearanceAfter(*by_facets, {0.01, -0.01, z}), 0.02 + z, 1e-9) << z;
    EXPECT_NEAR(clearanceAfter(*by_surfaces, {0.01, -0.01, z}), 0.02 + z, 1e-9) << z;
  }
}

TEST_F(CubeOverPlate, TooManyEntriesMakeAnAttemptFailAndTheNearestStillStand) {
  const ZonePart part[] = {moving(Pose::translation({0.1, 0.0, 0.07}))}, obstacle[] = {plate()};
  FacetQuery facets(part, obstacle, {});
  EXPECT_FALSE(facets.attempt(0.06, FacetQuery::Detail::kTurning, 0));
  const ZoneContacts nearest = facets.nearestOnly(0.06, 4);
  ASSERT_GE(nearest.contacts.size(), 1u);
  EXPECT_LE(nearest.contacts.size(), 4u);
  EXPECT_NEAR(nearest.contacts[0].gap, 0.02, 1e-9);
  SignatureCaches caches;
  SurfaceQuery surfaces(caches, part, obstacle, {});
  EXPECT_FALSE(surfaces.attempt(0.06, 0));
  ASSERT_EQ(surfaces.weights().size(), 1u);
  EXPECT_GT(surfaces.weights()[0], 0u) << "what the pair would have taken";
}

TEST_F(CubeOverPlate, AMaskedPairAndAFarOneAreNotThere) {
  const ZonePart part[] = {moving(Pose::translation({0.1, 0.0, 0.07}))}, obstacle[] = {plate()};
  const std::uint8_t none[] = {0};
  FacetQuery facets(part, obstacle, {});
  facets.setMask(none);
  EXPECT_TRUE(facets.attempt(0.06, FacetQuery::Detail::kAny, 64)->contacts.empty());
  SignatureCaches caches;
  SurfaceQuery surfaces(caches, part, obstacle, {});
  surfaces.setMask(none);
  EXPECT_TRUE(surfaces.attempt(0.06, 64)->contacts.empty());
  const ZonePart far[] = {moving(Pose::translation({0.1, 0.0, 3.0}))};
  EXPECT_TRUE(SurfaceQuery(caches, far, obstacle, {}).attempt(0.06, 64)->contacts.empty());
  EXPECT_TRUE(FacetQuery(far, obstacle, {}).attempt(0.06, FacetQuery::Detail::kAny, 64)->contacts.empty());
}

BallQuery ballAt(const SurfaceModel& model, const dvec3& p_M, double reach) {
  return {.model = model, .X_WM = {}, .p_M = p_M, .reach = reach};
}

TEST(RingFit, TheQuadricIsExactAtTheFootAndWorseFartherOff) {
  const auto model = SurfaceModel::build(geometry::makeTorus(0.1, 0.02, 48, 24));
  ASSERT_FALSE(model->elements().empty());
  const auto ring = std::find_if(model->elements().begin(), model->elements().end(),
                                 [](const SurfaceElement& e) { return e.shape.type == SurfaceType::kTorus; });
  ASSERT_NE(ring, model->elements().end());
  const dvec3 p_M(0.125, 0.0, 0.0);
  const SurfaceView view = viewFrom(ring->shape, p_M);
  EXPECT_NEAR(view.value, 0.005, 1e-7);
  const dvec3 t2 = glm::cross(view.nhat_M, view.t1_M);
  // At the foot, as rows are: the surface's curvatures across the normal.
  const dmat3 row = view.k1 * glm::outerProduct(view.t1_M, view.t1_M) + view.k2 * glm::outerProduct(t2, t2);
  double before = 0.0;
  EXPECT_EQ(ringDeviation(ballAt(*model, p_M, 0.004), *ring, row), 0.0) << "the ring is beyond";
  for (const double reach : {0.006, 0.01, 0.02, 0.04}) {
    const double off = ringDeviation(ballAt(*model, p_M, reach), *ring, row);
    EXPECT_GE(off, before - 1e-6);
    before = off;
  }
  EXPECT_LT(ringDeviation(ballAt(*model, p_M, 0.006), *ring, row), 5e-4);
  EXPECT_GT(before, 1e-3) << "round the tube it bends the other way";
}

}  // namespace
}  // namespace hapticell::collision
