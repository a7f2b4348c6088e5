// SPDX-License-Identifier: Apache-2.0
// A long run of random work, watched: memory, invariants, latency. See docs/dev/reliability.md.
#include <malloc.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/endurance/shift.h"
#include "manipulation/session/local_server.h"

namespace {

using hapticell::endurance::Day;
using hapticell::endurance::ShiftReport;

struct Words {
  double virtual_hours = 0.0, real_minutes = 0.0;
  double shift_s = 30.0;
  std::uint64_t seed = 1;
  std::string log, only, keep;
};

volatile std::sig_atomic_t asked_to_end = 0;  // Ctrl+C: the figures so far are told.

double residentMegabytes() {
  malloc_trim(0);
  std::ifstream in("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  in >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// What the program holds of it: when this is flat and residentMegabytes() is not, pages are scattered, nothing leaks.
double allocatedMegabytes() {
  const auto told = mallinfo2();
  return static_cast<double>(told.uordblks + told.hblkhd) / 1e6;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// The middle of the second and of the last quarter: the first quarter fills caches.
struct Trend {
  double begin = 0.0, end = 0.0;
  double growth() const { return begin > 0.0 ? end / begin - 1.0 : 0.0; }
};
Trend trendOf(const std::vector<double>& values) {
  const auto quarter = static_cast<std::ptrdiff_t>(values.size() / 4);
  return {median({values.begin() + quarter, values.begin() + 2 * quarter}),
          median({values.end() - quarter, values.end()})};
}

struct Totals {
  double hand_s = 0.0;
  std::size_t shifts = 0, imports = 0;
  std::uint64_t frames = 0;
  double force = 0.0, force_step = 0.0, penetration = 0.0, energy = 0.0;
  std::string most_energy;
  std::vector<double> memory, allocated, step_median, step_p99;
  std::vector<std::string> broken;

  void add(const ShiftReport& report) {
    hand_s += report.hand_s;
    ++shifts;
    if (report.left_out) return;
    imports += report.imported ? 1 : 0;
    frames += report.frames;
    force = std::max(force, report.force_max_n);
    force_step = std::max(force_step, report.force_step_n_per_ms);
    penetration = std::max(penetration, report.penetration_m);
    if (report.energy_j < energy) {
      energy = report.energy_j;
      most_energy = report.what;
    }
    memory.push_back(residentMegabytes());
    allocated.push_back(allocatedMegabytes());
    step_median.push_back(report.step_median_ms);
    step_p99.push_back(report.step_p99_ms);
    for (const std::string& sentence : report.broken) {
      broken.push_back("shift " + std::to_string(shifts) + ": " + sentence);
      std::fprintf(stderr, "%s\n", broken.back().c_str());
    }
  }
};

void print(const Totals& totals, double seconds) {
  const Trend memory = trendOf(totals.memory), allocated = trendOf(totals.allocated),
              median_step = trendOf(totals.step_median), p99 = trendOf(totals.step_p99);
  std::printf("hand                 %.2f h in %zu shifts, %.1f min of the clock on the wall\n", totals.hand_s / 3600.0,
              totals.shifts, seconds / 60.0);
  std::printf("recorded, imported   %llu frames, %zu STEP files\n", static_cast<unsigned long long>(totals.frames),
              totals.imports);
  std::printf("resident memory      %.1f -> %.1f MB (%+.2f %%)\n", memory.begin, memory.end, 100.0 * memory.growth());
  std::printf("of it allocated      %.2f -> %.2f MB (%+.2f %%)\n", allocated.begin, allocated.end,
              100.0 * allocated.growth());
  std::printf("step, median         %.3f -> %.3f ms\n", median_step.begin, median_step.end);
  std::printf("step, p99            %.3f -> %.3f ms\n", p99.begin, p99.end);
  std::printf("force                %.3f N at most, %.4f N in a millisecond\n", totals.force, totals.force_step);
  std::printf("entered              %.4f mm at most\n", 1e3 * totals.penetration);
  std::printf("energy               %.3f mJ in the worst second (%s)\n", 1e3 * totals.energy,
              totals.most_energy.c_str());
  std::printf("invariants broken    %zu\n", totals.broken.size());
}

int run(const Words& words) {
  std::string pattern = (std::filesystem::temp_directory_path() / "hapticell-endurance-XXXXXX").string();
  if (!mkdtemp(pattern.data())) return 2;
  const std::filesystem::path folder = pattern;
  const bool real = words.real_minutes > 0.0;
  std::unique_ptr<hapticell::manipulation::LocalServer> server;
  if (real) {
    const auto configuration = hapticell::config::loadConfiguration();
    const auto profile =
        hapticell::config::readDeviceProfile(*hapticell::config::findShippedFile("devices/touch.toml"));
    auto started = hapticell::manipulation::LocalServer::start(*profile, *configuration);
    if (!started) {
      std::fprintf(stderr, "%s\n", started.error().message().c_str());
      return 2;
    }
    server = std::move(*started);
  }
  auto day = Day::begin(words.seed, folder, server ? server->port() : 0);
  if (!day) {
    std::fprintf(stderr, "%s\n", day.error().message().c_str());
    return 2;
  }
  day->workOnlyIn(words.only);
  day->keepWorst(words.keep);
  const double asked = real ? 60.0 * words.real_minutes : 3600.0 * words.virtual_hours;
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  Totals totals;
  std::ofstream log;
  if (!words.log.empty()) {
    log.open(words.log);
    log << "shift,seconds,resident_mb,allocated_mb,step_median_ms,step_p99_ms,energy_mj,what\n";
  }
  std::signal(SIGINT, [](int) { asked_to_end = 1; });
  while ((real ? elapsed() : totals.hand_s) < asked && totals.broken.size() < 100 && asked_to_end == 0) {
    const ShiftReport report = day->work(words.shift_s);
    totals.add(report);
    if (log.is_open() && !report.left_out) {
      log << totals.shifts << ',' << elapsed() << ',' << totals.memory.back() << ',' << totals.allocated.back() << ','
          << report.step_median_ms << ',' << report.step_p99_ms << ',' << 1e3 * report.energy_j << ',' << report.what
          << std::endl;
    }
    if (totals.shifts % 50 == 0) {
      std::fprintf(stderr, "%.2f h, %.1f MB, %zu broken\n", totals.hand_s / 3600.0, totals.memory.back(),
                   totals.broken.size());
    }
  }
  print(totals, elapsed());
  std::filesystem::remove_all(folder);
  return totals.broken.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  mallopt(M_ARENA_MAX, 1);  // One heap: what threads leave scattered over several would hide a leak of its size.
  CLI::App app{"Works at random in three cells for hours, and watches memory, invariants and latency"};
  Words words;
  app.add_option("--virtual-hours", words.virtual_hours, "Hours of the hand, in virtual time");
  app.add_option("--real-minutes", words.real_minutes, "Minutes in real time, through a haptic server over TCP");
  app.add_option("--shift", words.shift_s, "Seconds of one session")->check(CLI::Range(1.0, 600.0));
  app.add_option("--seed", words.seed, "Another seed, another day");
  app.add_option("--log", words.log, "CSV, a line a session: seconds, memory, steps, what was taken");
  app.add_option("--only", words.only, "Sessions of one cell: demo, workbench or car_door; the others are left out")
      ->check(CLI::IsMember({"demo", "workbench", "car_door"}));
  app.add_option("--keep", words.keep, "Folder for the session of the worst energy, to be run again by itself");
  CLI11_PARSE(app, argc, argv);
  if (words.virtual_hours <= 0.0 && words.real_minutes <= 0.0) {
    std::fprintf(stderr, "nothing to do: give --virtual-hours or --real-minutes\n");
    return 2;
  }
  return run(words);
}
