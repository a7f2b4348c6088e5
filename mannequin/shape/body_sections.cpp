// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/body_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mannequin/body/girths.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;
using D = Dimension;

/// Measures from which the sections are made.
class SkinSizes {
 public:
  explicit SkinSizes(const Figure& figure) : figure_(figure), k(figure.body[D::kStature] / 1.755) {}
  double girth(Girth g) const { return girthOf(figure_.sex, figure_.body, g); }
  double of(D dimension) const { return figure_.body[dimension]; }
  bool female() const { return figure_.sex == Sex::kFemale; }

 private:
  const Figure& figure_;

 public:
  const double k;
};

}  // namespace

std::vector<TubeSection> trunkSections(const Figure& figure) {
  const SkinSizes size(figure);
  const double k = size.k, hip = 0.5 * size.of(D::kHipBreadth), shoulder = 0.5 * size.of(D::kBiacromialBreadth);
  const double chest = size.of(D::kChestDepth), waist = size.girth(Girth::kWaistDepth),
               seat = size.girth(Girth::kButtockDepth);
  const double z_crotch = size.of(D::kCrotchHeight), z_seat = size.girth(Girth::kButtockHeight),
               z_waist = size.girth(Girth::kWaistHeight), z_rib = size.of(D::kTenthRibHeight),
               z_chest = size.girth(Girth::kChestHeight), z_axilla = size.girth(Girth::kAxillaHeight),
               z_acromion = size.of(D::kAcromialHeight), z_neck = size.of(D::kCervicaleHeight);
  const double bust = size.female() ? 0.86 : 1.0;  // The rest of a woman's chest depth are breasts.
  // The tops of the legs are the outside of the seat, the trunk lies a little within.
  // m that the trunk is within the seat's measures; our choice, girths are tested within a standard error
  // (docs/dev/mannequin.md). Half, twice: hips too broad or with a step.
  constexpr double kWithin = 0.010;
  TubeSection at_seat =
      withGirth({z_seat, 0.0, 0.0, 0.985 * hip, 0.45 * seat, 0.55 * seat, 2.2}, size.girth(Girth::kButtock));
  at_seat.half_breadth -= kWithin * k;
  at_seat.front -= kWithin * k;
  at_seat.back -= kWithin * k;
  const TubeSection at_waist =
      withGirth({z_waist, 0.0, 0.012 * k, 0.5 * size.girth(Girth::kWaistBreadth), 0.55 * waist, 0.45 * waist, 2.2},
                size.girth(Girth::kWaist));
  const TubeSection at_chest =
      asBroadAs({z_chest, 0.0, 0.012 * k, 0.0, (bust - 0.46) * chest, 0.46 * chest, size.female() ? 2.5 : 2.75},
                (size.female() ? 0.945 : 0.985) * size.girth(Girth::kChest));
  const auto between = [](const TubeSection& a, const TubeSection& b, double s) {
    TubeSection section = a;
    section.t = a.t + s * (b.t - a.t);
    section.v = a.v + s * (b.v - a.v);
    section.half_breadth = a.half_breadth + s * (b.half_breadth - a.half_breadth);
    section.front = a.front + s * (b.front - a.front);
    section.back = a.back + s * (b.back - a.back);
    section.roundness = a.roundness + s * (b.roundness - a.roundness);
    return section;
  };
  TubeSection hips = between(at_seat, at_waist, 0.45);
  hips.half_breadth = std::max(hips.half_breadth, 0.985 * hip - 0.010 * k);
  TubeSection ribs = between(at_waist, at_chest, std::clamp((z_rib - z_waist) / (z_chest - z_waist), 0.2, 0.5));
  ribs.back *= 0.97;
  ribs.half_breadth *= size.female() ? 0.97 : 0.985;
  const double c = at_chest.half_breadth;
  const TubeSection crotch{z_crotch + 0.004 * k, 0.0, -0.006 * k, 0.40 * hip, 0.36 * seat, 0.45 * seat, 2.0};
  const TubeSection axilla{z_axilla + 0.012 * k,  0.0, 0.008 * k, 0.97 * c, 0.98 * at_chest.front,
                           0.985 * at_chest.back, 2.55};
  const double z_top = z_acromion;
  const TubeSection upper{z_axilla + 0.55 * (z_top - z_axilla),
                          0.0,
                          0.006 * k,
                          std::min(0.90 * c, 0.86 * shoulder),
                          0.84 * at_chest.front,
                          0.92 * at_chest.back,
                          2.35};
  const TubeSection top{z_top - 0.006 * k,    0.0, 0.000, 0.70 * shoulder, 0.49 * at_chest.front,
                        0.78 * at_chest.back, 2.2};
  const TubeSection nape{z_neck - 0.018 * k,   0.0, 0.000, 0.27 * shoulder, 0.30 * at_chest.front,
                         0.46 * at_chest.back, 2.1};
  return {crotch, at_seat, hips, at_waist, ribs, at_chest, axilla, upper, top, nape};
}

std::vector<TubeSection> armSections(const Figure& figure, double out) {
  const SkinSizes size(figure);
  const double k = size.k, upper = figure.upperArmLength(), fore = figure.forearmLength();
  // Arms are measured flexed; at rest a biceps has 0.93 of that and a forearm 0.97 (our choice).
  const double biceps = 0.93 * size.girth(Girth::kBicepsFlexed), forearm = 0.97 * size.girth(Girth::kForearmFlexed);
  const double wrist = size.girth(Girth::kWrist), low = std::min(biceps, 1.02 * forearm);
  // `out`: which way of v is outwards.
  const auto section = [&](double t, double girth, double flat, double u, double outwards) {
    const double r = girth / (2.0 * std::numbers::pi);
    return TubeSection{t, u, out * outwards, r * std::sqrt(flat), r / std::sqrt(flat), r / std::sqrt(flat), 2.0};
  };
  return {section(-0.050 * k, 0.86 * biceps, 1.00, 0.000, -0.004 * k),
          section(-0.010 * k, 1.04 * biceps, 1.06, 0.000, 0.002 * k),
          section(0.18 * upper, 1.14 * biceps, 1.10, 0.000, 0.005 * k),
          section(0.34 * upper, 1.07 * biceps, 1.12, 0.000, 0.004 * k),
          section(0.55 * upper, biceps, 1.12, 0.003 * k, 0.001 * k),
          section(0.80 * upper, 0.92 * low, 1.04, 0.002 * k, 0.000),
          section(upper, 0.90 * low, 1.02, -0.001 * k, 0.000),
          section(upper + 0.20 * fore, forearm, 1.06, 0.001 * k, 0.000),
          section(upper + 0.34 * fore, 0.975 * forearm, 1.08, 0.002 * k, 0.000),
          section(upper + 0.64 * fore, 0.70 * forearm + 0.12 * wrist, 1.12, 0.000, 0.000),
          section(upper + 0.90 * fore, wrist, 1.34, 0.000, 0.000),
          section(upper + 1.00 * fore, 1.02 * wrist, 1.42, 0.000, 0.000),
          section(upper + fore + 0.030 * k, 1.00 * wrist, 1.95, 0.000, 0.000),
          section(upper + fore + 0.066 * k, 0.84 * wrist, 3.60, -0.001 * k, 0.000)};
}

std::vector<TubeSection> legSections(const Figure& figure, double out) {
  const SkinSizes size(figure);
  const double k = size.k, thigh = figure.thighLength(), shank = figure.shankLength();
  const double top = size.girth(Girth::kThigh), low = size.girth(Girth::kLowerThigh), calf = size.girth(Girth::kCalf),
               ankle = size.girth(Girth::kAnkle);
  const double hip = figure.p_PS[0].z, crotch = hip - size.of(D::kCrotchHeight);
  // v is ahead; u is to the left.
  const auto section = [&](double t, double girth, double flat, double outwards, double v) {
    const double r = girth / (2.0 * std::numbers::pi);
    return TubeSection{t, out * outwards, v, r * std::sqrt(flat), r / std::sqrt(flat), r / std::sqrt(flat), 2.0};
  };
  const double t0 = crotch + 0.010 * k;
  // Where the thighs touch they are deeper than broad: both are as broad as the hips.
  const double r_top = top / (2.0 * std::numbers::pi), hips = 0.5 * size.of(D::kHipBreadth);
  const double flat_top = std::pow(std::clamp(0.480 * hips / r_top, 0.84, 0.97), 2.0);
  const double out_top = 0.985 * hips - r_top * std::sqrt(flat_top) - figure.p_PS[indexOf(S::kLeftThigh)].y;
  const auto along = [&](double s) { return t0 + s * (thigh - t0); };
  return {section(-0.085 * k, 0.74 * top, 0.86, out_top - 0.012 * k, -0.008 * k),
          section(-0.025 * k, 0.93 * top, 0.84, out_top - 0.004 * k, -0.013 * k),
          section(0.5 * t0, 1.00 * top, flat_top + 0.02, out_top, -0.013 * k),
          section(t0, top, flat_top, out_top, -0.008 * k),
          section(along(0.34), 0.93 * top, 0.5 * (flat_top + 0.92), 0.6 * out_top, 0.002 * k),
          section(along(0.62), 0.45 * top + 0.50 * low, 0.94, 0.001 * k, 0.006 * k),
          section(along(0.84), low, 1.00, 0.000, 0.004 * k),
          section(thigh, 0.95 * low, 0.96, 0.000, 0.004 * k),
          section(thigh + 0.09 * shank, 0.90 * low, 0.96, 0.000, -0.002 * k),
          section(thigh + 0.28 * shank, calf, 0.98, 0.001 * k, -0.016 * k),
          section(thigh + 0.40 * shank, 0.955 * calf, 0.98, 0.001 * k, -0.017 * k),
          section(thigh + 0.66 * shank, 0.5 * calf + 0.30 * ankle, 0.95, 0.000, -0.012 * k),
          section(thigh + 0.86 * shank, ankle, 0.86, 0.000, -0.010 * k),
          section(thigh + 1.00 * shank, 1.10 * ankle, 0.90, 0.000, -0.012 * k)};
}

std::vector<TubeSection> trouserSections(const Figure& figure) {
  const SkinSizes size(figure);
  const double k = size.k, thigh = figure.thighLength(), shank = figure.shankLength();
  const double calf = size.girth(Girth::kCalf), low = size.girth(Girth::kLowerThigh);
  const auto section = [&](double t, double girth, double v) {
    const double r = girth / (2.0 * std::numbers::pi);
    return TubeSection{t, 0.0, v, 0.97 * r, 1.03 * r, 1.03 * r, 2.0};
  };
  return {section(0.80 * thigh, 0.93 * low, 0.003 * k), section(thigh, 0.97 * low, 0.000),
          section(thigh + 0.30 * shank, 1.02 * calf, -0.012 * k),
          section(thigh + 0.65 * shank, 0.93 * calf, -0.011 * k),
          section(thigh + 1.04 * shank, 0.90 * calf, -0.008 * k)};
}

std::vector<TubeSection> neckSections(const Figure& figure, double length) {
  const SkinSizes size(figure);
  const double k = size.k, girth = size.girth(Girth::kNeck), r = girth / (2.0 * std::numbers::pi);
  const auto section = [&](double t, double share, double flat, double u) {
    return TubeSection{t, u, 0.0, share * r * flat, share * r / flat, share * r / flat, 2.0};
  };
  // u is to the left, v ahead.
  return {section(-0.060 * k, 1.16, 0.96, 0.0), section(0.000, 1.10, 0.97, 0.0),
          section(0.45 * length, 1.00, 0.97, 0.0), section(length, 0.98, 0.96, 0.0)};
}

}  // namespace hapticell::mannequin
