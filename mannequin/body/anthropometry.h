// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::mannequin {

enum class Sex : std::uint8_t { kMale, kFemale };

/// The body dimensions that a figure is built from: those of ANSUR II (definitions there), SI.
enum class Dimension : std::uint8_t {
  kStature,
  kCervicaleHeight,
  kAcromialHeight,
  kSuprasternaleHeight,
  kTenthRibHeight,
  kIliocristaleHeight,
  kTrochanterionHeight,
  kCrotchHeight,
  kLateralFemoralEpicondyleHeight,
  kLateralMalleolusHeight,
  kSittingHeight,
  kEyeHeightSitting,
  kAcromionRadialeLength,
  kRadialeStylionLength,
  kHandLength,
  kPalmLength,
  kHandBreadth,
  kBiacromialBreadth,
  kBideltoidBreadth,
  kBicristalBreadth,
  kHipBreadth,
  kChestDepth,
  kAbdominalDepth,
  kThighClearance,
  kFootLength,
  kBallOfFootLength,
  kFootBreadth,
  kHeadLength,
  kHeadBreadth,
  kTragionToTopOfHead,
  kMass,
};
inline constexpr std::size_t kDimensionCount = 31;

/// One value for each Dimension: metres, kg for the mass.
struct BodyDimensions {
  std::array<double, kDimensionCount> values{};
  double operator[](Dimension dimension) const { return values[static_cast<std::size_t>(dimension)]; }
  double& operator[](Dimension dimension) { return values[static_cast<std::size_t>(dimension)]; }
};

/// The regression of a dimension on the stature: value = a + b * stature, with the standard error of the estimate. SI.
struct Regression {
  double a = 0.0;
  double b = 0.0;
  double standard_error = 0.0;
};

/// Name in files and on the command line: the ANSUR II name without spaces, "acromialheight".
std::string_view nameOf(Dimension dimension);
std::optional<Dimension> findDimension(std::string_view name);

/// Regression on the stature, computed from the ANSUR II raw data (4,082 men, 1,986 women; public domain).
Regression regressionOf(Sex sex, Dimension dimension);

/// The smallest and the largest stature (m) of a figure; beyond, the regressions are not valid. Our choice, 0.2 to 0.3
/// m around the measured range. Wider: odd proportions; narrower: rare but real persons are refused.
inline constexpr double kLeastStature = 1.2;
inline constexpr double kMostStature = 2.3;
/// m: statures are shown in mm, rounded by half of one and 0.1. Half: rounded ones count as another body; twice: two
/// bodies 1 mm apart count as one.
inline constexpr double kSameStature = 0.0006;

/// Stature (m) of a percentile of the sex. The 5th, 50th and 95th are those of ANSUR II to the millimetre; between and
/// beyond them, a normal distribution with their skew. Refused outside 0.1 to 99.9.
Expected<double> statureOfPercentile(Sex sex, double percentile);
/// The inverse of statureOfPercentile().
double percentileOfStature(Sex sex, double stature);

/// A request for a body: a stature and, if known, a mass (kg). Dimensions in `own` (by Dimension) override all others.
struct BodyRequest {
  Sex sex = Sex::kMale;
  double stature = 1.755;
  std::optional<double> mass = {};
  std::array<std::optional<double>, kDimensionCount> own = {};
};

/// The most likely dimensions of a person of that sex and stature (and mass): each by its own regression, so that they
/// add up to the stature, which percentiles of segments do not. Widths and depths use the regression on stature and
/// mass if a mass is given. Refused, with the reason: a stature outside 1.2 to 2.3 m, a mass outside 0.4 to 3 times the
/// value expected for the stature, an own dimension more than 40 % from its expected value.
Expected<BodyDimensions> bodyDimensions(const BodyRequest& request);

}  // namespace hapticell::mannequin
