// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/anthropometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mannequin/body/girths.h"

namespace hapticell::mannequin {

namespace {

/// a + b * stature (mm; kg for the mass) and the standard error, men and women.
struct Row {
  const char* name;
  std::array<Regression, 2> of_sex;
};

// Computed from the raw file of ANSUR II; see docs/dev/mannequin.md.
constexpr std::array<Row, kDimensionCount> kRows = {{
    {"stature", {{{0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}}},
    {"cervicaleheight", {{{-78.1, 0.9084, 11.2}, {-90.4, 0.9126, 10.5}}}},
    {"acromialheight", {{{-126.9, 0.8926, 16.2}, {-96.9, 0.8793, 13.7}}}},
    {"suprasternaleheight", {{{-101.4, 0.8769, 11.7}, {-93.6, 0.8740, 11.0}}}},
    {"tenthribheight", {{{-150.2, 0.7236, 20.3}, {-134.8, 0.7314, 17.2}}}},
    {"iliocristaleheight", {{{-150.4, 0.6901, 21.6}, {-158.0, 0.7085, 20.0}}}},
    {"trochanterionheight", {{{-169.9, 0.6098, 25.9}, {-126.9, 0.5970, 23.0}}}},
    {"crotchheight", {{{-176.3, 0.5821, 23.9}, {-179.1, 0.5904, 23.6}}}},
    {"lateralfemoralepicondyleheight", {{{-93.1, 0.3330, 13.6}, {-84.4, 0.3379, 16.3}}}},
    {"lateralmalleolusheight", {{{5.0, 0.0387, 5.0}, {6.0, 0.0348, 4.6}}}},
    {"sittingheight", {{{205.8, 0.4057, 22.4}, {215.8, 0.3935, 21.3}}}},
    {"eyeheightsitting", {{{158.0, 0.3681, 21.5}, {181.1, 0.3479, 20.6}}}},
    {"acromionradialelength", {{{-20.9, 0.2028, 10.6}, {-34.0, 0.2120, 10.5}}}},
    {"radialestylionlength", {{{-14.4, 0.1608, 10.8}, {-24.5, 0.1632, 11.1}}}},
    {"handlength", {{{21.7, 0.0977, 7.4}, {16.2, 0.1012, 7.7}}}},
    {"palmlength", {{{22.6, 0.0534, 5.0}, {19.1, 0.0550, 4.8}}}},
    {"handbreadth", {{{35.8, 0.0298, 3.9}, {32.1, 0.0283, 3.4}}}},
    {"biacromialbreadth", {{{154.6, 0.1486, 16.2}, {102.8, 0.1612, 15.1}}}},
    {"bideltoidbreadth", {{{249.8, 0.1484, 30.9}, {189.1, 0.1604, 26.8}}}},
    {"bicristalbreadth", {{{47.9, 0.1295, 15.1}, {55.7, 0.1336, 20.5}}}},
    {"hipbreadth", {{{108.3, 0.1352, 22.3}, {91.9, 0.1608, 24.6}}}},
    {"chestdepth", {{{105.8, 0.0843, 25.6}, {88.0, 0.0979, 26.6}}}},
    {"abdominalextensiondepthsitting", {{{116.7, 0.0786, 36.9}, {90.5, 0.0855, 31.0}}}},
    {"thighclearance", {{{80.6, 0.0569, 15.1}, {52.9, 0.0706, 13.3}}}},
    {"footlength", {{{30.1, 0.1373, 9.1}, {18.5, 0.1399, 8.6}}}},
    {"balloffootlength", {{{22.3, 0.1017, 7.8}, {13.7, 0.1034, 7.0}}}},
    {"footbreadthhorizontal", {{{41.5, 0.0344, 4.7}, {42.8, 0.0307, 4.4}}}},
    {"headlength", {{{133.1, 0.0378, 6.5}, {122.2, 0.0415, 7.0}}}},
    {"headbreadth", {{{143.7, 0.0061, 5.5}, {127.2, 0.0126, 5.1}}}},
    {"tragiontopofhead", {{{99.8, 0.0178, 6.0}, {90.2, 0.0223, 6.4}}}},
    {"weightkg", {{{-85.3, 0.0973, 12.6}, {-80.9, 0.0913, 9.3}}}},
}};

/// value = a + b * stature + c * mass (mm, kg), men and women.
struct MassRow {
  Dimension dimension;
  std::array<std::array<double, 3>, 2> of_sex;
};
constexpr std::array<MassRow, 6> kMassRows = {{
    {Dimension::kBideltoidBreadth, {{{433.5, -0.0610, 2.153}, {386.8, -0.0627, 2.444}}}},
    {Dimension::kBiacromialBreadth, {{{204.6, 0.0917, 0.586}, {132.0, 0.1283, 0.361}}}},
    {Dimension::kHipBreadth, {{{232.6, -0.0065, 1.456}, {262.4, -0.0316, 2.108}}}},
    {Dimension::kChestDepth, {{{258.1, -0.0894, 1.785}, {277.8, -0.1163, 2.347}}}},
    {Dimension::kAbdominalDepth, {{{335.3, -0.1707, 2.563}, {316.6, -0.1697, 2.796}}}},
    {Dimension::kThighClearance, {{{165.9, -0.0404, 1.000}, {148.3, -0.0371, 1.179}}}},
}};

/// Stature of the 5th, 50th and 95th percentile, m.
constexpr std::array<std::array<double, 3>, 2> kStatures = {{{1.648, 1.755, 1.870}, {1.525, 1.626, 1.740}}};
constexpr double kNormal95 = 1.6448536269514722;

/// Least and greatest stature (m) among the persons measured: beyond them the lines' intercepts would make ever odder
/// proportions (a man of 1.2 m with his centre of mass at 0.53 of the stature).
constexpr std::array<std::array<double, 2>, 2> kMeasured = {{{1.491, 1.993}, {1.409, 1.829}}};

std::size_t indexOf(Sex sex) {
  return static_cast<std::size_t>(sex);
}

/// stature(z) = median + slope z + skew z^2 through the three known percentiles.
struct StatureCurve {
  double median, slope, skew;
};
StatureCurve statureCurve(Sex sex) {
  const auto& s = kStatures[indexOf(sex)];
  return {s[1], (s[2] - s[0]) / (2.0 * kNormal95), (0.5 * (s[0] + s[2]) - s[1]) / (kNormal95 * kNormal95)};
}

double normalDistribution(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

/// Bisection: exact to rounding, and not in any inner loop.
double normalQuantile(double p) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (normalDistribution(middle) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::string inWords(const char* format, double value) {
  char text[96];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

Expected<void> checkOwn(Dimension dimension, double value, double expectation) {
  if (std::isfinite(value) && value > 0.6 * expectation && value < 1.4 * expectation) return {};
  return makeError({.place = Text("measure '%1'", nameOf(dimension)),
                    .found = inWords("%.4g", value),
                    .expected = Text("%1 to %2 (the expected value ± 40 %)", inWords("%.4g", 0.6 * expectation),
                                     inWords("%.4g", 1.4 * expectation))});
}

}  // namespace

std::string_view nameOf(Dimension dimension) {
  return kRows[static_cast<std::size_t>(dimension)].name;
}

std::optional<Dimension> findDimension(std::string_view name) {
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    if (name == kRows[i].name) return static_cast<Dimension>(i);
  }
  return std::nullopt;
}

Regression regressionOf(Sex sex, Dimension dimension) {
  Regression regression = kRows[static_cast<std::size_t>(dimension)].of_sex[indexOf(sex)];
  if (dimension == Dimension::kMass) {
    regression.b *= 1000.0;
    return regression;
  }
  regression.a *= 0.001;
  regression.standard_error *= 0.001;
  return regression;
}

std::array<double, 2> measuredStatures(Sex sex) {
  return kMeasured[indexOf(sex)];
}

double likelyMass(Sex sex, double stature) {
  const Regression regression = regressionOf(sex, Dimension::kMass);
  return regression.a + regression.b * stature;
}

Expected<double> statureOfPercentile(Sex sex, double percentile) {
  if (!(percentile >= 0.1 && percentile <= 99.9)) {
    return makeError({.place = "percentile",
                      .found = inWords("%g", percentile),
                      .expected = "0.1 to 99.9",
                      .fix = "Ask for a stature instead."});
  }
  const StatureCurve curve = statureCurve(sex);
  const double z = normalQuantile(0.01 * percentile);
  return curve.median + curve.slope * z + curve.skew * z * z;
}

double percentileOfStature(Sex sex, double stature) {
  const StatureCurve curve = statureCurve(sex);
  // The root that grows with the stature; below the curve's lowest point everybody is taller.
  const double discriminant = curve.slope * curve.slope + 4.0 * curve.skew * (stature - curve.median);
  if (discriminant <= 0.0) return 0.0;
  return 100.0 * normalDistribution(2.0 * (stature - curve.median) / (curve.slope + std::sqrt(discriminant)));
}

Expected<BodyDimensions> bodyDimensions(const BodyRequest& request) {
  if (!(request.stature >= kLeastStature && request.stature <= kMostStature)) {
    return makeError({.place = "stature",
                      .found = inWords("%g m", request.stature),
                      .expected = "1.2 to 2.3 m",
                      .fix = "The body measures are of adults; outside this range, the regressions are not valid."});
  }
  const auto& measured = kMeasured[indexOf(request.sex)];
  const double known = std::clamp(request.stature, measured[0], measured[1]), grown = request.stature / known;
  BodyDimensions body;
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    const Regression regression = regressionOf(request.sex, static_cast<Dimension>(i));
    body.values[i] = grown * (regression.a + regression.b * known);
  }
  body[Dimension::kMass] *= grown;  // The body mass index is held.
  if (request.mass) {
    const double likely = body[Dimension::kMass];
    if (!(*request.mass >= 0.4 * likely && *request.mass <= 3.0 * likely)) {
      return makeError({.place = "mass",
                        .found = inWords("%g kg", *request.mass),
                        .expected = Text("%1 to %2 kg at this stature", inWords("%.0f", std::ceil(0.4 * likely)),
                                         inWords("%.0f", 3.0 * likely))});
    }
    body[Dimension::kMass] = *request.mass;
    for (const MassRow& row : kMassRows) {
      const auto& c = row.of_sex[indexOf(request.sex)];
      body[row.dimension] = 0.001 * grown * (c[0] + c[1] * 1000.0 * known + c[2] * *request.mass / (grown * grown));
    }
  }
  for (std::size_t i = 1; i < kDimensionCount; ++i) {
    if (!request.own[i]) continue;
    const auto checked = checkOwn(static_cast<Dimension>(i), *request.own[i], body.values[i]);
    HAPTICELL_TRY(checked);
    body.values[i] = *request.own[i];
  }
  return body;
}

}  // namespace hapticell::mannequin
