// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/hand_path_units.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hapticell::haptic {

namespace {

/// s before a path begins that is meant so: more and it is a clock's time. Half: a path that waits 0.6 s loses its
/// wait; twice: a recording cut out at 1.5 s waits that long.
constexpr double kLongestWait = 1.0;
/// Rows: nobody writes so many by hand at whole seconds. Half: a hand-made path may be taken for milliseconds; twice:
/// short recordings in milliseconds are played a thousand times too slowly.
constexpr std::size_t kRowsOfARecording = 100;
/// s between two rows that no recording has; the least step of a clock in whole milliseconds. Half changes nothing, as
/// times are whole; twice: recordings at 1000 Hz are not recognised.
constexpr double kSecondsStep = 1.0;
constexpr double kMillimetre = 1e-3;

struct ClockUnit {
  double over;
  double seconds;
  const char* remark;
};
// What the time since 1970 is in each, from 1973 on. %1 is the first time.
constexpr ClockUnit kClockUnits[] = {HAPTICELL_TRANSLATED(
    {1e17, 1e-9, "times start at %1: clock times in nanoseconds are assumed; the first line is time 0"},
    {1e14, 1e-6, "times start at %1: clock times in microseconds are assumed; the first line is time 0"},
    {1e11, 1e-3, "times start at %1: clock times in milliseconds are assumed; the first line is time 0"})};

std::string digits(const char* format, double number) {
  char text[400];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

void countFromFirst(std::vector<HandSample>& samples, double seconds) {
  const double begin = samples.front().t;
  for (HandSample& sample : samples) sample.t = (sample.t - begin) * seconds;
}

/// Whole numbers, a second or more apart: nobody writes a hundred rows of a hand so.
bool isInMilliseconds(const std::vector<HandSample>& samples) {
  if (samples.size() < kRowsOfARecording) return false;
  std::vector<double> steps;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i].t != std::floor(samples[i].t)) return false;
    steps.push_back(samples[i].t - samples[i - 1].t);
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle >= kSecondsStep;
}

void recogniseTimes(std::vector<HandSample>& samples, std::vector<Text>& assumed) {
  const double begin = samples.front().t, length = samples.back().t - begin;
  const auto unit = std::find_if(std::begin(kClockUnits), std::end(kClockUnits),
                                 [&](const ClockUnit& one) { return begin > one.over; });
  if (unit != std::end(kClockUnits)) {
    countFromFirst(samples, unit->seconds);
    assumed.emplace_back(unit->remark, digits("%.0f", begin));
    return;
  }
  const bool milliseconds = isInMilliseconds(samples);
  if (begin < 0.0 || begin > std::max(kLongestWait, length)) {
    countFromFirst(samples, milliseconds ? 1e-3 : 1.0);
    assumed.push_back(Text("times start at %1: the first line is time 0", digits("%.3f", begin)));
  } else if (milliseconds) {
    for (HandSample& sample : samples) sample.t *= 1e-3;
  }
  if (milliseconds)
    assumed.push_back(
        Text("times are whole numbers up to %1: milliseconds are assumed", digits("%.0f", begin + length)));
}

double farthestOf(const std::vector<HandSample>& samples) {
  double farthest = 0.0;
  for (const HandSample& sample : samples) {
    const dvec3 away = glm::abs(sample.X_DH.p);
    farthest = std::max({farthest, away.x, away.y, away.z});
  }
  return farthest;
}

}  // namespace

Expected<std::vector<Text>> recogniseHandUnits(std::vector<HandSample>& samples, const std::string& name) {
  std::vector<Text> assumed;
  recogniseTimes(samples, assumed);
  const double farthest = farthestOf(samples);
  if (farthest <= kFarthestStylus) return assumed;
  if (farthest * kMillimetre > kFarthestStylus) {
    return makeError(
        {.file = name,
         .place = "columns x, y, z",
         .found = Text("a position %1 from the centre of the workspace", digits("%.6g", farthest)),
         .expected = Text("metres in the device frame, within %1 (or millimetres)", digits("%.1f", kFarthestStylus)),
         .fix = "Write the path in metres from the centre of the device's workspace."});
  }
  for (HandSample& sample : samples) sample.X_DH.p *= kMillimetre;
  assumed.push_back(Text("positions reach %1: millimetres are assumed", digits("%.6g", farthest)));
  return assumed;
}

}  // namespace hapticell::haptic
