// SPDX-License-Identifier: Apache-2.0
#include "tests/app/style/colour_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::app {
namespace {

double linear(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::array<double, 3> labOf(const std::array<double, 3>& rgb) {
  const double x = (0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047;
  const double y = 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2];
  const double z = (0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883;
  const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
  return {116.0 * f(y) - 16.0, 500.0 * (f(x) - f(y)), 200.0 * (f(y) - f(z))};
}

double hue(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  const double h = std::atan2(b, a);
  return h < 0.0 ? h + 2.0 * std::numbers::pi : h;
}

double luminance(const QColor& color) {
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

}  // namespace

std::array<double, 3> linearSeenBy(Vision vision, const QColor& color) {
  const std::array<double, 3> c{linear(color.redF()), linear(color.greenF()), linear(color.blueF())};
  static constexpr double kProtan[3][3]{
      {0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
  static constexpr double kDeutan[3][3]{
      {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
  if (vision == Vision::kNormal) return c;
  const auto& m = vision == Vision::kProtan ? kProtan : kDeutan;
  std::array<double, 3> seen{};
  for (std::size_t i = 0; i < 3; ++i) seen[i] = std::clamp(m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2], 0.0, 1.0);
  return seen;
}

double ciede2000(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return ciede2000Lab(labOf(a), labOf(b));
}

double ciede2000Lab(const std::array<double, 3>& p, const std::array<double, 3>& q) {
  const double mean_c = 0.5 * (std::hypot(p[1], p[2]) + std::hypot(q[1], q[2]));
  const double c7 = std::pow(mean_c, 7.0);
  const double g = 0.5 * (1.0 - std::sqrt(c7 / (c7 + std::pow(25.0, 7.0))));
  const double a1 = (1.0 + g) * p[1], a2 = (1.0 + g) * q[1];
  const double c1 = std::hypot(a1, p[2]), c2 = std::hypot(a2, q[2]);
  const double h1 = hue(a1, p[2]), h2 = hue(a2, q[2]);
  double dh = 0.0, mean_h = h1 + h2;
  if (c1 * c2 > 0.0) {
    dh = h2 - h1;
    if (dh > std::numbers::pi) dh -= 2.0 * std::numbers::pi;
    if (dh < -std::numbers::pi) dh += 2.0 * std::numbers::pi;
    mean_h = 0.5 * (h1 + h2);
    if (std::abs(h1 - h2) > std::numbers::pi)
      mean_h += h1 + h2 < 2.0 * std::numbers::pi ? std::numbers::pi : -std::numbers::pi;
  }
  const double dl = q[0] - p[0], dc = c2 - c1, dhh = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * dh);
  const double l = 0.5 * (p[0] + q[0]), c = 0.5 * (c1 + c2), deg = std::numbers::pi / 180.0;
  const double t = 1.0 - 0.17 * std::cos(mean_h - 30.0 * deg) + 0.24 * std::cos(2.0 * mean_h) +
                   0.32 * std::cos(3.0 * mean_h + 6.0 * deg) - 0.20 * std::cos(4.0 * mean_h - 63.0 * deg);
  const double turn = 30.0 * deg * std::exp(-std::pow((mean_h / deg - 275.0) / 25.0, 2.0));
  const double cc7 = std::pow(c, 7.0);
  const double rt = -2.0 * std::sqrt(cc7 / (cc7 + std::pow(25.0, 7.0))) * std::sin(2.0 * turn);
  const double sl = 1.0 + 0.015 * (l - 50.0) * (l - 50.0) / std::sqrt(20.0 + (l - 50.0) * (l - 50.0));
  const double sc = 1.0 + 0.045 * c, sh = 1.0 + 0.015 * c * t;
  return std::sqrt(std::pow(dl / sl, 2.0) + std::pow(dc / sc, 2.0) + std::pow(dhh / sh, 2.0) + rt * dc / sc * dhh / sh);
}

double contrast(const QColor& a, const QColor& b) {
  const double bright = std::max(luminance(a), luminance(b)), dark = std::min(luminance(a), luminance(b));
  return (bright + 0.05) / (dark + 0.05);
}

}  // namespace hapticell::app
