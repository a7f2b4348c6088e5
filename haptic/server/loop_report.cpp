// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/loop_report.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace hapticell::haptic {

namespace {

// Upper ends of the histogram's lines, seconds: 1, 2, 5 from the jitter of a real-time kernel to a stall. For reading
// only.
constexpr std::array kEdges = {20e-6, 50e-6, 100e-6, 200e-6, 500e-6, 1e-3, 2e-3, 5e-3, 10e-3, 20e-3, 50e-3, 100e-3};

template <typename... Values>
std::string print(const char* format, Values... values) {
  std::array<char, 200> line;
  const int length = std::snprintf(line.data(), line.size(), format, values...);
  return std::string(line.data(), static_cast<std::size_t>(std::max(0, length)));
}

std::string histogramLines(const DurationHistogram& lateness) {
  std::string lines;
  std::uint64_t below = 0;
  for (const double edge : kEdges) {
    const std::uint64_t until = lateness.countBelow(edge);
    if (until > below) {
      lines += print("  < %7.2f ms %10llu  %9.4f %%\n", 1e3 * edge, static_cast<unsigned long long>(until - below),
                     100.0 * static_cast<double>(until - below) / static_cast<double>(lateness.count()));
    }
    below = until;
  }
  if (lateness.count() > below)
    lines += print("   longer     %10llu\n", static_cast<unsigned long long>(lateness.count() - below));
  return lines;
}

}  // namespace

std::string loopReport(const LoopFigures& figures) {
  const DurationHistogram& late = figures.lateness;
  const std::uint64_t due = figures.ticks + figures.missed;
  const double missed_share = due > 0 ? 100.0 * static_cast<double>(figures.missed) / static_cast<double>(due) : 0.0;
  return print("Force loop: %llu ticks, %.1f Hz over the last second, %llu missed (%.4f %%).\n",
               static_cast<unsigned long long>(figures.ticks), figures.rate_hz,
               static_cast<unsigned long long>(figures.missed), missed_share) +
         print("Lateness in ms: p50 %.3f, p99 %.3f, p99.9 %.3f, max %.3f.\n", 1e3 * late.percentile(0.5),
               1e3 * late.percentile(0.99), 1e3 * late.percentile(0.999), 1e3 * late.max()) +
         histogramLines(late) +
         print(
             "Sets of contacts: age in ms p50 %.1f, p99 %.1f, last seconds; %llu late, %llu refused since the start.\n",
             1e3 * figures.recent_set_age.percentile(0.5), 1e3 * figures.recent_set_age.percentile(0.99),
             static_cast<unsigned long long>(figures.late_sets),
             static_cast<unsigned long long>(figures.refused_sets)) +
         (figures.dropped_sets == 0
              ? std::string()
              : print("Sets whose numbers made no proxy or force, dropped: %llu (a fault of the client).\n",
                      static_cast<unsigned long long>(figures.dropped_sets))) +
         (figures.refused_samples == 0
              ? std::string()
              : print("Samples of the stylus that no hand can have made, not answered: %llu (a cable or an encoder).\n",
                      static_cast<unsigned long long>(figures.refused_samples)));
}

}  // namespace hapticell::haptic
