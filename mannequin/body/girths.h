// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "mannequin/body/anthropometry.h"

namespace hapticell::mannequin {

/// Measures that shape the surface of a body in addition to its Dimensions: girths, breadths and depths of ANSUR II
/// (definitions there; arm and forearm are measured flexed), SI.
enum class Girth : std::uint8_t {
  kNeck,
  kChest,
  kWaist,
  kButtock,
  kThigh,
  kLowerThigh,
  kCalf,
  kAnkle,
  kBicepsFlexed,
  kForearmFlexed,
  kWrist,
  kHead,
  kWaistBreadth,
  kWaistDepth,
  kButtockDepth,
  kChestHeight,
  kAxillaHeight,
  kButtockHeight,
  kWaistHeight,
};
inline constexpr std::size_t kGirthCount = 19;

/// Shortest and tallest stature (m) among the persons measured: beyond them, their proportions and body mass index are
/// used.
std::array<double, 2> measuredStatures(Sex sex);
/// The mass (kg) from the regression for a stature in that range.
double likelyMass(Sex sex, double stature);

/// The ANSUR II name without spaces: "chestcircumference".
std::string_view nameOf(Girth girth);

/// The most likely value (m) for a body, by the regression on stature and mass over the ANSUR II raw data.
double girthOf(Sex sex, const BodyDimensions& body, Girth girth);

/// Standard error of that estimate among the persons measured, m.
double girthError(Sex sex, Girth girth);

}  // namespace hapticell::mannequin
