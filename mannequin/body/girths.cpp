// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/girths.h"

#include <algorithm>
#include <array>

namespace hapticell::mannequin {

namespace {

/// value = a + b * stature + c * mass (mm, kg) and the standard error.
struct Plane {
  double a, b, c, error;
};
struct GirthRow {
  const char* name;
  std::array<Plane, 2> of_sex;
};

// Computed from the raw file of ANSUR II (4,082 men, 1,986 women), as the dimensions were; see docs/dev/mannequin.md.
constexpr std::array<GirthRow, kGirthCount> kGirthRows = {{
    {"neckcircumference", {{{407.8, -0.0851, 1.629, 14.9}, {305.8, -0.0469, 1.480, 12.2}}}},
    {"chestcircumference", {{{1036.4, -0.2909, 6.235, 32.3}, {990.3, -0.3292, 7.269, 42.6}}}},
    {"waistcircumference", {{{1024.9, -0.4358, 7.962, 44.0}, {1014.1, -0.4717, 9.076, 48.5}}}},
    {"buttockcircumference", {{{808.4, -0.1401, 5.346, 26.3}, {846.9, -0.1784, 6.861, 29.5}}}},
    {"thighcircumference", {{{594.7, -0.1836, 4.125, 22.6}, {584.0, -0.1942, 5.142, 22.8}}}},
    {"lowerthighcircumference", {{{344.2, -0.0658, 2.112, 14.9}, {350.2, -0.0911, 2.936, 19.1}}}},
    {"calfcircumference", {{{351.0, -0.0684, 1.888, 16.1}, {305.9, -0.0514, 2.230, 17.0}}}},
    {"anklecircumference", {{{153.1, 0.0079, 0.729, 10.1}, {139.9, 0.0141, 0.782, 11.8}}}},
    {"bicepscircumferenceflexed", {{{380.3, -0.1223, 2.253, 18.8}, {341.4, -0.1399, 2.833, 14.0}}}},
    {"forearmcircumferenceflexed", {{{252.7, -0.0315, 1.317, 12.9}, {215.9, -0.0318, 1.477, 10.5}}}},
    {"wristcircumference", {{{97.5, 0.0252, 0.398, 6.0}, {80.9, 0.0279, 0.419, 5.3}}}},
    {"headcircumference", {{{475.9, 0.0319, 0.497, 13.7}, {446.9, 0.0494, 0.498, 17.8}}}},
    {"waistbreadth", {{{306.0, -0.1033, 2.359, 15.9}, {295.9, -0.1138, 2.793, 18.2}}}},
    {"waistdepth", {{{302.4, -0.1533, 2.392, 16.6}, {317.1, -0.1810, 2.815, 16.6}}}},
    {"buttockdepth", {{{259.0, -0.0981, 1.860, 11.1}, {263.6, -0.1113, 2.222, 11.5}}}},
    {"chestheight", {{{-90.9, 0.7862, 0.014, 18.1}, {-154.5, 0.8337, -0.464, 21.9}}}},
    {"axillaheight", {{{-156.0, 0.8499, -0.089, 14.7}, {-142.1, 0.8541, -0.144, 14.1}}}},
    {"buttockheight", {{{-181.9, 0.6169, -0.158, 28.1}, {-119.4, 0.5743, 0.265, 24.7}}}},
    {"waistheightomphalion", {{{-204.4, 0.7448, -0.551, 20.7}, {-223.6, 0.7652, -0.624, 20.1}}}},
}};

const Plane& planeOf(Sex sex, Girth girth) {
  return kGirthRows[static_cast<std::size_t>(girth)].of_sex[static_cast<std::size_t>(sex)];
}

}  // namespace

std::string_view nameOf(Girth girth) {
  return kGirthRows[static_cast<std::size_t>(girth)].name;
}

double girthOf(Sex sex, const BodyDimensions& body, Girth girth) {
  const Plane& plane = planeOf(sex, girth);
  // Beyond the shortest and the tallest person measured the proportions are theirs, as those of the dimensions.
  const auto [least, most] = measuredStatures(sex);
  const double stature = body[Dimension::kStature], known = std::clamp(stature, least, most), grown = stature / known;
  const double mass = body[Dimension::kMass] / (grown * grown);
  const double value = 0.001 * grown * (plane.a + plane.b * 1000.0 * known + plane.c * mass);
  // The plane is of persons of 0.7 to 1.5 times the likely mass; far lighter ones would be left without any flesh.
  return std::max(value, 0.45 * 0.001 * grown * (plane.a + plane.b * 1000.0 * known + plane.c * likelyMass(sex, known)));
}

double girthError(Sex sex, Girth girth) {
  return 0.001 * planeOf(sex, girth).error;
}

}  // namespace hapticell::mannequin
