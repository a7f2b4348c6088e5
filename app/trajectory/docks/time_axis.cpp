// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/time_axis.h"

#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

constexpr double kNamedApart = 60.0;  // Pixels.
// s: the shortest stretch that can be zoomed to, a frame of 100 Hz. Half, twice: farther in, or less.
constexpr double kShortest = 0.01;

}  // namespace

std::vector<TimeAxis::Tick> TimeAxis::ticks() const {
  std::vector<Tick> ticks;
  if (!(end > begin) || !(right > left)) return ticks;
  // 1, 2 or 5 times a power of ten.
  const double wanted = kNamedApart / pixelsPerSecond();
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= wanted) {
      step = factor * power;
      break;
    }
  const int parts = 5;
  const auto first = static_cast<long>(std::ceil((begin - 1e-9) / step * parts));
  const auto last = static_cast<long>(std::floor((end + 1e-9) / step * parts));
  for (long i = first; i <= last; ++i) ticks.push_back({static_cast<double>(i) * step / parts, i % parts == 0});
  return ticks;
}

TimeAxis TimeAxis::zoomed(double factor, double t) const {
  TimeAxis axis = *this;
  const double length = std::max(kShortest, (end - begin) / factor);
  const double share = (t - begin) / (end - begin);
  axis.begin = t - share * length;
  axis.end = axis.begin + length;
  return axis;
}

}  // namespace hapticell::app
