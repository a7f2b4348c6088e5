// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/figure_skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "mannequin/body/girths.h"
#include "tests/mannequin/posture/random_postures.h"

namespace hapticell::mannequin {
namespace {

const Figure& medianMan() {
  static const Figure figure = *makeFigure({Sex::kMale, 1.755});
  return figure;
}
const FigureSkin& skinOfMedianMan() {
  static const FigureSkin skin(medianMan());
  return skin;
}

struct Posed {
  std::vector<fvec3> places, normals;
  Posed(const FigureSkin& skin, const Posture& posture) { skin.pose(posture, places, normals); }
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Edges of a step's triangles that only one of them has.
std::set<Edge> borderOf(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<Edge, int> uses;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  std::set<Edge> border;
  for (const auto& [edge, count] : uses)
    if (count == 1) border.insert(edge);
  return border;
}

/// Vertices of different patches that stand in one place in the bind posture, on both patches' borders.
std::vector<std::pair<std::size_t, std::size_t>> seamsOf(const FigureSkin& skin) {
  const Posed bind(skin, bindPosture());
  std::map<std::array<float, 3>, std::vector<std::size_t>> at;
  for (const auto& patch : skin.patches()) {
    if (patch.face) continue;  // Lips and lids lie on the skin.
    std::set<std::uint32_t> rim;
    for (const auto& [a, b] : borderOf(patch.steps[0])) rim.insert({a, b});
    for (const std::uint32_t v : rim) {
      const fvec3& p = bind.places[patch.first + v];
      at[{p.x, p.y, p.z}].push_back(patch.first + v);
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> seams;
  for (const auto& [place, vertices] : at)
    for (std::size_t i = 1; i < vertices.size(); ++i) seams.emplace_back(vertices[0], vertices[i]);
  return seams;
}

TEST(FigureSkin, SeamsStayClosedAndSmoothInRandomPosturesWithinTheLimits) {
  const FigureSkin& skin = skinOfMedianMan();
  const auto seams = seamsOf(skin);
  ASSERT_GT(seams.size(), 2000u);
  std::mt19937_64 random(26);
  float gap = 0.0f, bend = 1.0f;
  for (int n = 0; n < 200; ++n) {
    Posture posture = randomPosture(random);
    posture.X_WR = Pose::identity();
    const Posed posed(skin, posture);
    for (const auto& [a, b] : seams) {
      gap = std::max(gap, glm::length(posed.places[a] - posed.places[b]));
      bend = std::min(bend, glm::dot(posed.normals[a], posed.normals[b]));
    }
  }
  EXPECT_LT(gap, 0.5e-3f) << "m between neighbours";
  EXPECT_GT(bend, std::cos(1.0f * float(std::numbers::pi) / 180.0f))
      << "normals of neighbours are the same within a degree";
}

TEST(FigureSkin, EveryStepOfDetailHasTheSameBorders) {
  const FigureSkin& skin = skinOfMedianMan();
  std::size_t before = 0, after = 0;
  for (const auto& patch : skin.patches()) {
    const auto border = borderOf(patch.steps[0]);
    for (const auto& step : patch.steps) EXPECT_TRUE(patch.face || borderOf(step) == border) << patch.body;
    before += patch.steps.front().size();
    after += patch.steps.back().size();
  }
  EXPECT_LT(after, before / 3) << "and the last is much coarser";
}

/// The tape about a surface in a plane: the hull of where rays from `centre` leave it.
template <typename Field>
double tapeAround(const Field& distance, const dvec3& centre, const dvec3& u, const dvec3& v) {
  constexpr int kRays = 180;
  std::vector<glm::dvec2> points;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRays, c = std::cos(angle), s = std::sin(angle);
    double inside = 0.0, outside = 0.005;
    while (distance(centre + outside * (c * u + s * v)) < 0.0 && outside < 0.5) outside += 0.005;
    inside = outside - 0.005;
    for (int k = 0; k < 20; ++k) {
      const double middle = 0.5 * (inside + outside);
      (distance(centre + middle * (c * u + s * v)) < 0.0 ? inside : outside) = middle;
    }
    points.push_back(outside * glm::dvec2(c, s));
  }
  std::sort(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  for (const int pass : {0, 1}) {
    const std::size_t start = hull.size() + 1;
    for (const glm::dvec2& p : points) {
      const auto turnsRight = [&] {
        const glm::dvec2 a = hull[hull.size() - 2], b = hull.back();
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) <= 0.0;
      };
      while (hull.size() > start && turnsRight()) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    if (pass == 0) std::reverse(points.begin(), points.end());
  }
  double length = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) length += glm::length(hull[(i + 1) % hull.size()] - hull[i]);
  return length;
}

TEST(Girths, AreThoseOfTheMeanSoldierAtItsStatureAndMass) {
  // Means of the raw file beside means of stature and mass: every regression goes through them.
  struct Mean {
    Girth girth;
    double man, woman;  // mm
  };
  constexpr Mean kMeans[] = {
      {Girth::kNeck, 397.6, 329.8},          {Girth::kChest, 1058.7, 946.9}, {Girth::kWaist, 940.6, 860.9},
      {Girth::kButtock, 1019.5, 1021.2},     {Girth::kThigh, 625.1, 616.1},  {Girth::kLowerThigh, 409.3, 400.7},
      {Girth::kCalf, 392.3, 373.3},          {Girth::kAnkle, 229.3, 215.7},  {Girth::kBicepsFlexed, 358.1, 305.6},
      {Girth::kForearmFlexed, 310.1, 264.1}, {Girth::kWrist, 175.9, 154.8},  {Girth::kHead, 574.4, 561.1}};
  for (const Mean& mean : kMeans) {
    const auto man = *bodyDimensions({Sex::kMale, 1.7562, 85.52}),
               woman = *bodyDimensions({Sex::kFemale, 1.6285, 67.76});
    EXPECT_NEAR(1000.0 * girthOf(Sex::kMale, man, mean.girth), mean.man, 1.0) << nameOf(mean.girth);
    EXPECT_NEAR(1000.0 * girthOf(Sex::kFemale, woman, mean.girth), mean.woman, 1.0) << nameOf(mean.girth);
  }
}

struct Built {
  const char* name;
  BodyRequest request;
};
std::vector<Built> bodies() {
  std::vector<Built> all;
  const auto at = [](Sex sex, double percentile) { return *statureOfPercentile(sex, percentile); };
  all.push_back({"P5F", {Sex::kFemale, at(Sex::kFemale, 5)}});
  all.push_back({"P50F", {Sex::kFemale, at(Sex::kFemale, 50)}});
  all.push_back({"P50F, 85 kg", {Sex::kFemale, at(Sex::kFemale, 50), 85.0}});
  all.push_back({"P50M", {Sex::kMale, at(Sex::kMale, 50)}});
  all.push_back({"P50M, 65 kg", {Sex::kMale, at(Sex::kMale, 50), 65.0}});
  all.push_back({"P50M, 110 kg", {Sex::kMale, at(Sex::kMale, 50), 110.0}});
  all.push_back({"P95M", {Sex::kMale, at(Sex::kMale, 95)}});
  return all;
}

TEST(SkinShape, GirthsOfTheBodyAreWithinAStandardErrorOfThePublishedTable) {
  for (const Built& built : bodies()) {
    const Figure figure = *makeFigure(built.request);
    const SkinShape shape(figure);
    const auto& b = figure.body;
    const auto of = [&](Girth girth) { return girthOf(figure.sex, b, girth); };
    const auto bare = [&](const dvec3& p) { return shape.body(p); };
    const auto check = [&](Girth girth, double measured) {
      EXPECT_NEAR(measured, of(girth), girthError(figure.sex, girth)) << built.name << " " << nameOf(girth);
    };
    const auto torso = [&](const dvec3& p) { return shape.torso(p); };
    const auto around = [&](double z) {
      return tapeAround(torso, {shape.trunk().at(z).v, 0.0, z}, {1, 0, 0}, {0, 1, 0});
    };
    check(Girth::kChest, around(of(Girth::kChestHeight)));
    check(Girth::kWaist, around(of(Girth::kWaistHeight)));
    // Along a limb the tape lies across it.
    const auto across = [&](Segment first, const SectionTube& tube, double t) {
      const SegmentPlace& place = shape.places()[indexOf(first)];
      const TubeSection section = tube.at(t);
      return tapeAround(bare, tube.place(t, section.u, section.v), place.R_WS[0], place.R_WS[1]);
    };
    const double thigh = figure.thighLength(), shank = figure.shankLength(), upper = figure.upperArmLength();
    const auto leg = [&](double t) { return across(Segment::kLeftThigh, shape.leg(Side::kLeft), t); };
    const auto arm = [&](double t) { return across(Segment::kLeftUpperArm, shape.arm(Side::kLeft), t); };
    check(Girth::kLowerThigh, leg(thigh - 0.06));
    check(Girth::kCalf, leg(thigh + 0.28 * shank));
    check(Girth::kAnkle, leg(thigh + 0.86 * shank));
    check(Girth::kWrist, arm(upper + 0.92 * figure.forearmLength()));
    // Measured flexed; hanging it has 0.97 and 0.93 of that.
    EXPECT_NEAR(arm(upper + 0.20 * figure.forearmLength()), 0.97 * of(Girth::kForearmFlexed),
                girthError(figure.sex, Girth::kForearmFlexed));
    EXPECT_NEAR(arm(0.55 * upper), 0.93 * of(Girth::kBicepsFlexed), girthError(figure.sex, Girth::kBicepsFlexed));
    const auto thighs = [&](const dvec3& p) { return shape.leg(Side::kLeft).distance(p); };
    const double t = figure.p_PS[0].z - b[Dimension::kCrotchHeight] + 0.015;
    const SegmentPlace& place = shape.places()[indexOf(Segment::kLeftThigh)];
    const TubeSection section = shape.leg(Side::kLeft).at(t);
    check(Girth::kThigh,
          tapeAround(thighs, shape.leg(Side::kLeft).place(t, section.u, section.v), place.R_WS[0], place.R_WS[1]));
  }
}

TEST(FigureSkin, HipsAndShouldersAreAsBroadAsTheTableSaysWhenItStands) {
  for (const Built& built : bodies()) {
    const Figure figure = *makeFigure(built.request);
    const FigureSkin skin(figure);
    Posture posture = *libraryPosture(figure, "zero");
    const Posed posed(skin, posture);
    float hips = 0.0f, shoulders = 0.0f, low = 1.0f, high = 0.0f;
    for (const auto& patch : skin.patches()) {
      const auto body = static_cast<Segment>(patch.body);
      for (std::size_t v = patch.first; v < patch.first + patch.count; ++v) {
        const fvec3& p = posed.places[v];
        if (body == Segment::kPelvis || body == Segment::kLeftThigh || body == Segment::kRightThigh)
          hips = std::max(hips, std::abs(p.y));
        if (body == Segment::kLeftUpperArm || body == Segment::kRightUpperArm)
          shoulders = std::max(shoulders, std::abs(p.y));
        low = std::min(low, p.z);
        high = std::max(high, p.z);
      }
    }
    EXPECT_NEAR(2.0f * hips, figure.body[Dimension::kHipBreadth], 0.030) << built.name;
    EXPECT_NEAR(2.0f * shoulders, figure.body[Dimension::kBideltoidBreadth], 0.045) << built.name;
    EXPECT_NEAR(low, 0.0f, 0.008f) << built.name << ": on the floor";
    EXPECT_NEAR(high, figure.body[Dimension::kStature], 0.020) << built.name << ": with its hair";
  }
}

/// How far a point is from what is felt of the figure: all bodies' flesh, placed.
class Felt {
 public:
  Felt(const Figure& figure, const Posture& posture) : flesh_(fleshOf(figure)), places_(kBodies) {
    const FigurePose pose = forwardKinematics(figure, posture);
    std::copy(pose.segments.begin(), pose.segments.end(), places_.begin());
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto fingers = phalanxPlaces(figure, posture, side, pose[armSegment(side, Segment::kLeftHand)]);
      for (std::size_t d = 0; d < kDigits; ++d)
        for (std::size_t k = 0; k < kPhalanges; ++k) places_[phalanxBody(side, d, k)] = fingers[d][k];
    }
  }
  double distance(const dvec3& p) const {
    double least = 1e9;
    for (std::size_t i = 0; i < kBodies; ++i)
      least = std::min(least, flesh_[i].distance(glm::transpose(places_[i].R_WS) * (p - places_[i].p_WS)));
    return least;
  }

 private:
  std::vector<Flesh> flesh_;
  std::vector<SegmentPlace> places_;
};

TEST(FigureSkin, IsWhereTheFigureIsFelt) {
  for (const NamedFigure& named : boundaryFigures()) {
    const FigureSkin skin(named.figure);
    for (const char* name : {"standing", "seated", "overhead", "both_hands_forward"}) {
      const Posture posture = *libraryPosture(named.figure, name);
      const Posed posed(skin, posture);
      const Felt felt(named.figure, posture);
      std::vector<double> off;
      double hands = 0.0;
      for (const auto& patch : skin.patches()) {
        if (patch.face) continue;
        const bool hand = patch.body >= kSegmentCount || patch.body == indexOf(Segment::kLeftHand) ||
                          patch.body == indexOf(Segment::kRightHand);
        for (std::size_t v = patch.first; v < patch.first + patch.count; v += 4) {
          off.push_back(std::abs(felt.distance(dvec3(posed.places[v]))));
          if (hand) hands = std::max(hands, off.back());
        }
      }
      std::sort(off.begin(), off.end());
      EXPECT_LT(off[off.size() / 2], 0.003) << named.name << " " << name;
      EXPECT_LT(off[off.size() * 95 / 100], 0.015) << named.name << " " << name;
      EXPECT_LT(off.back(), 0.050) << named.name << " " << name << ": in the folds of hips and shoulders";
      EXPECT_LT(hands, 0.012) << named.name << " " << name;
    }
  }
}

/// Whether a segment goes through a triangle.
bool pierces(const fvec3& from, const fvec3& to, const fvec3& a, const fvec3& b, const fvec3& c) {
  const fvec3 way = to - from, e = b - a, f = c - a, p = glm::cross(way, f);
  const float determinant = glm::dot(e, p);
  if (std::abs(determinant) < 1e-14f) return false;
  const fvec3 s = from - a, q = glm::cross(s, e);
  const float u = glm::dot(s, p) / determinant, v = glm::dot(way, q) / determinant, t = glm::dot(f, q) / determinant;
  return u > 0.0f && v > 0.0f && u + v < 1.0f && t > 0.0f && t < 1.0f;
}

TEST(FigureSkin, HandsAndFeetDoNotStandInTheRestOfTheBodyAtRest) {
  for (const NamedFigure& named : boundaryFigures()) {
    const FigureSkin skin(named.figure);
    const Posed posed(skin, *libraryPosture(named.figure, "standing"));
    const auto isOut = [](std::size_t body) {  // Hands, fingers, shanks and feet.
      using S = Segment;
      static const std::set<std::size_t> outer = {indexOf(S::kLeftHand),  indexOf(S::kRightHand),
                                                  indexOf(S::kLeftShank), indexOf(S::kRightShank),
                                                  indexOf(S::kLeftFoot),  indexOf(S::kRightFoot)};
      return body >= kSegmentCount || outer.contains(body);
    };
    const auto isTrunk = [](std::size_t body) { return body < indexOf(Segment::kLeftClavicle); };
    std::size_t crossings = 0;
    for (const auto& one : skin.patches()) {
      if (!isOut(one.body)) continue;
      for (const auto& other : skin.patches()) {
        const bool sides = one.body != other.body && isOut(other.body) && other.body < one.body &&
                           (one.body < kSegmentCount) == (other.body < kSegmentCount);
        const bool legs = sides && std::abs(posed.places[one.first].y - posed.places[other.first].y) > 0.1f;
        if (!isTrunk(other.body) && !legs) continue;
        fvec3 low(1e9f), high(-1e9f);
        for (std::size_t v = other.first; v < other.first + other.count; ++v) {
          low = glm::min(low, posed.places[v]);
          high = glm::max(high, posed.places[v]);
        }
        for (const auto& t : one.steps.back()) {
          for (std::size_t i = 0; i < 3; ++i) {
            const fvec3 &from = posed.places[one.first + t[i]], &to = posed.places[one.first + t[(i + 1) % 3]];
            if (glm::any(glm::lessThan(glm::max(from, to), low)) ||
                glm::any(glm::greaterThan(glm::min(from, to), high)))
              continue;
            for (const auto& u : other.steps.back())
              crossings += pierces(from, to, posed.places[other.first + u[0]], posed.places[other.first + u[1]],
                                   posed.places[other.first + u[2]])
                               ? 1
                               : 0;
          }
        }
      }
    }
    EXPECT_EQ(crossings, 0u) << named.name;
  }
}

TEST(FigureSkin, IsClothedAndHasAFaceWhoseIrisesGoWhereTheGazeGoes) {
  const FigureSkin& skin = skinOfMedianMan();
  std::set<std::array<float, 3>> clothes, face;
  const FigureSkin::Patch* iris = nullptr;
  for (const auto& patch : skin.patches()) {
    (patch.face ? face : clothes).insert(patch.color);
    if (patch.face && patch.color[0] > 0.2f && patch.color[0] < 0.4f && patch.color[2] > 0.15f) iris = &patch;
  }
  EXPECT_EQ(clothes.size(), 6u) << "shirt, trousers, belt, shoes, soles, skin";
  EXPECT_EQ(face.size(), 6u) << "hair and brows, lids, lips, whites, irises, pupils";
  ASSERT_NE(iris, nullptr);
  Posture posture;
  const auto middle = [&] {
    const Posed posed(skin, posture);
    fvec3 sum(0.0f);
    for (std::size_t v = iris->first; v < iris->first + iris->count; ++v) sum += posed.places[v];
    return sum / static_cast<float>(iris->count);
  };
  const fvec3 ahead = middle();
  posture.gaze = {0.3, 0.2};
  EXPECT_GT(middle().y, ahead.y + 0.002f) << "to the left";
  EXPECT_LT(middle().z, ahead.z - 0.001f) << "and down";
}

TEST(FigureSkin, RaisedArmsKeepTheirThickness) {
  const FigureSkin& skin = skinOfMedianMan();
  for (const double degrees : {0.0, 90.0, 150.0}) {
    Posture posture;
    posture[Dof::kLeftShoulderAbduction] = degrees * std::numbers::pi / 180.0;
    posture[Dof::kLeftClavicleElevation] = std::max(0.0, 0.22 * (degrees - 30.0)) * std::numbers::pi / 180.0;
    const Posed posed(skin, posture);
    const FigurePose pose = forwardKinematics(medianMan(), posture);
    const dvec3 shoulder = pose[Segment::kLeftUpperArm].p_WS, down = -pose[Segment::kLeftUpperArm].R_WS[2];
    // From the end of the armpit on it is neither swollen nor collapsed, m from its axis.
    for (const double share : {0.55, 0.7, 0.85}) {
      double most = 0.0, least = 1.0;
      for (const auto& patch : skin.patches()) {
        if (patch.body != indexOf(Segment::kLeftUpperArm)) continue;
        for (std::size_t v = patch.first; v < patch.first + patch.count; ++v) {
          const dvec3 off = dvec3(posed.places[v]) - shoulder;
          const double t = glm::dot(off, down);
          if (std::abs(t - share * medianMan().upperArmLength()) > 0.012) continue;
          const double r = glm::length(off - t * down);
          most = std::max(most, r);
          least = std::min(least, r);
        }
      }
      EXPECT_LT(most, 0.072) << degrees << " " << share;
      EXPECT_GT(least, 0.034) << degrees << " " << share;
    }
  }
}

}  // namespace
}  // namespace hapticell::mannequin
