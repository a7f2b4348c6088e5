// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/figure.h"

#include <gtest/gtest.h>

#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::mannequin {
namespace {

using D = Dimension;

Figure figureOf(Sex sex, double percentile) {
  return *makeFigure({sex, *statureOfPercentile(sex, percentile)});
}

TEST(Anthropometry, PercentilesGiveTheSurveysOwnStatures) {
  EXPECT_NEAR(*statureOfPercentile(Sex::kMale, 5), 1.648, 1e-9);
  EXPECT_NEAR(*statureOfPercentile(Sex::kMale, 50), 1.755, 1e-9);
  EXPECT_NEAR(*statureOfPercentile(Sex::kMale, 95), 1.870, 1e-9);
  EXPECT_NEAR(*statureOfPercentile(Sex::kFemale, 5), 1.525, 1e-9);
  EXPECT_NEAR(*statureOfPercentile(Sex::kFemale, 50), 1.626, 1e-9);
  EXPECT_NEAR(*statureOfPercentile(Sex::kFemale, 95), 1.740, 1e-9);
  for (double p : {0.5, 5.0, 37.0, 50.0, 80.0, 99.5}) {
    EXPECT_NEAR(percentileOfStature(Sex::kFemale, *statureOfPercentile(Sex::kFemale, p)), p, 1e-6);
  }
  EXPECT_FALSE(statureOfPercentile(Sex::kMale, 0.0).has_value());
  EXPECT_FALSE(statureOfPercentile(Sex::kMale, 100.0).has_value());
  EXPECT_FALSE(statureOfPercentile(Sex::kMale, NAN).has_value());
}

struct Published {
  Sex sex;
  double percentile;
  const char* measure;
  double metres;
};

// ANSUR II, 5th and 95th percentiles of the dimension itself; a figure of that percentile of stature lies within one
// standard error of the regression of the value that the regression gives, checked here against the printed numbers of
// the 50th percentile, where both agree.
TEST(Figure, BuiltMeasuresAgreeWithAnsur) {
  const Published rows[] = {
      {Sex::kMale, 50, "acromial_height", 1.439},   {Sex::kFemale, 50, "acromial_height", 1.332},
      {Sex::kMale, 50, "trochanter_height", 0.899}, {Sex::kFemale, 50, "trochanter_height", 0.844},
      {Sex::kMale, 50, "knee_height", 0.491},       {Sex::kFemale, 50, "knee_height", 0.465},
      {Sex::kMale, 50, "eye_height", 1.640},        {Sex::kFemale, 50, "eye_height", 1.517},
      {Sex::kMale, 50, "hand_length", 0.193},       {Sex::kFemale, 50, "hand_length", 0.180},
      {Sex::kMale, 50, "foot_length", 0.271},       {Sex::kFemale, 50, "foot_length", 0.246},
      {Sex::kMale, 50, "biacromial_breadth", .415}, {Sex::kFemale, 50, "biacromial_breadth", .365},
      {Sex::kMale, 50, "wrist_height", 0.847},      {Sex::kFemale, 50, "wrist_height", 0.794},
      {Sex::kMale, 50, "sitting_height", 0.918},    {Sex::kFemale, 50, "sitting_height", 0.857},
  };
  for (const Published& row : rows) {
    const auto measures = measuresOf(figureOf(row.sex, row.percentile));
    EXPECT_NEAR(measures.at(row.measure), row.metres, 0.014) << row.measure;
  }
}

TEST(Figure, MeasuresStayWithinOneStandardErrorOfTheRegressionAtAllSizes) {
  const std::pair<const char*, D> same[] = {{"acromial_height", D::kAcromialHeight},
                                            {"trochanter_height", D::kTrochanterionHeight},
                                            {"knee_height", D::kLateralFemoralEpicondyleHeight},
                                            {"cervicale_height", D::kCervicaleHeight},
                                            {"upper_arm_length", D::kAcromionRadialeLength},
                                            {"forearm_length", D::kRadialeStylionLength},
                                            {"hand_length", D::kHandLength},
                                            {"foot_length", D::kFootLength},
                                            {"sitting_height", D::kSittingHeight},
                                            {"biacromial_breadth", D::kBiacromialBreadth}};
  for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
    for (const double percentile : {5.0, 50.0, 95.0}) {
      const double stature = *statureOfPercentile(sex, percentile);
      const auto measures = measuresOf(*makeFigure({sex, stature}));
      EXPECT_NEAR(measures.at("stature"), stature, 1e-3);
      for (const auto& [name, dimension] : same) {
        const Regression r = regressionOf(sex, dimension);
        EXPECT_NEAR(measures.at(name), r.a + r.b * stature, r.standard_error) << name << " P" << percentile;
      }
    }
  }
}

TEST(Figure, CentreOfMassOfAStandingFigureLiesWhereTheBooksSay) {
  for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
    for (const double percentile : {5.0, 50.0, 95.0}) {
      const Figure figure = figureOf(sex, percentile);
      const Posture standing = *libraryPosture(figure, "standing");
      const dvec3 c = centerOfMass(figure, forwardKinematics(figure, standing));
      const double share = c.z / figure.body[D::kStature];
      EXPECT_GE(share, 0.55) << percentile;
      EXPECT_LE(share, 0.57) << percentile;
      EXPECT_NEAR(c.y, 0.0, 1e-9);
      EXPECT_GT(c.x, -0.02);
      EXPECT_LT(c.x, 0.06);
    }
  }
}

TEST(Figure, BeyondThePersonsMeasuredTheProportionsAreHeld) {
  for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
    for (const double stature : {1.2, 1.3, 1.4, 2.0, 2.15, 2.3}) {
      const Figure figure = *makeFigure({sex, stature});
      const dvec3 c = centerOfMass(figure, forwardKinematics(figure, *libraryPosture(figure, "standing")));
      EXPECT_GE(c.z / stature, 0.55) << stature;
      EXPECT_LE(c.z / stature, 0.57) << stature;
    }
    for (const double end : {1.2, 2.3}) {  // A tenth farther is everything a tenth larger, the mass by its square.
      const double inner = end < 2.0 ? 1.1 * end : end / 1.1, larger = end < 2.0 ? 1.1 : 1.0 / 1.1;
      const BodyDimensions near = *bodyDimensions({sex, inner}), far = *bodyDimensions({sex, end});
      const BodyDimensions heavy = *bodyDimensions({sex, end, 90.0});
      const BodyDimensions as_heavy = *bodyDimensions({sex, inner, 90.0 * larger * larger});
      for (std::size_t i = 0; i < kDimensionCount; ++i) {
        const auto dimension = static_cast<D>(i);
        const double by = dimension == D::kMass ? larger * larger : larger;
        EXPECT_NEAR(near[dimension], by * far[dimension], 1e-9) << nameOf(dimension);
        EXPECT_NEAR(as_heavy[dimension], by * heavy[dimension], 1e-9) << nameOf(dimension);
      }
    }
  }
}

TEST(Figure, MassesAddUpAndAMassIsKept) {
  const Figure figure = *makeFigure({Sex::kFemale, 1.626, 80.0});
  double sum = 0.0;
  for (const double m : figure.mass) sum += m;
  EXPECT_NEAR(sum, 80.0, 1e-9);
  EXPECT_GT(figure.body[D::kHipBreadth], makeFigure({Sex::kFemale, 1.626})->body[D::kHipBreadth]);
}

TEST(Figure, RefusesWhatIsNoGrownPersonAndSaysWhy) {
  for (const double stature : {1.19, 2.31, -1.0, std::nan("")}) {
    const auto figure = makeFigure({Sex::kMale, stature});
    ASSERT_FALSE(figure.has_value());
    EXPECT_NE(figure.error().message().find("1.2 to 2.3 m"), std::string::npos);
  }
  for (const double stature : {1.2, 1.5, 2.0, 2.3}) {
    for (const Sex sex : {Sex::kMale, Sex::kFemale}) {
      const auto figure = makeFigure({sex, stature});
      ASSERT_TRUE(figure.has_value()) << stature;
      for (const double m : figure->mass) EXPECT_GT(m, 0.0);
    }
  }
  EXPECT_FALSE(makeFigure({Sex::kMale, 1.75, 10.0}).has_value());
  BodyRequest request{Sex::kMale, 1.75};
  request.own[static_cast<std::size_t>(D::kHandLength)] = 0.21;
  EXPECT_NEAR(measuresOf(*makeFigure(request)).at("hand_length"), 0.21, 1e-12);
  request.own[static_cast<std::size_t>(D::kHandLength)] = 0.5;
  EXPECT_FALSE(makeFigure(request).has_value());
}

TEST(Figure, BoundaryFiguresGrow) {
  const auto figures = boundaryFigures();
  ASSERT_EQ(figures.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_GT(figures[i].figure.body[D::kStature], figures[i - 1].figure.body[D::kStature]);
  }
}

}  // namespace
}  // namespace hapticell::mannequin
