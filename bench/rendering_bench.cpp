// SPDX-License-Identifier: Apache-2.0
// How long one tick of the force loop's work takes, beside a Gauss-Seidel solver as a peer in the same run.
//
// usage: rendering_bench [TICKS]     prints a table for docs/dev/performance.md
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "haptic/devices/simulated_device.h"
#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/force_renderer.h"
#include "haptic/rendering/safety_chain.h"

namespace hapticell::haptic {
namespace {

/// CPU time of this thread: what the work takes, without what other programs take from it.
double threadMicroseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

struct Percentiles {
  double p50 = 0.0, p99 = 0.0, p999 = 0.0, worst = 0.0;
};

class Samples {
 public:
  explicit Samples(std::size_t count) { microseconds_.reserve(count); }
  template <typename Work>
  void time(Work&& work) {
    const double begin = threadMicroseconds();
    work();
    microseconds_.push_back(threadMicroseconds() - begin);
  }
  void add(double microseconds) { microseconds_.push_back(microseconds); }
  Percentiles percentiles() {
    std::sort(microseconds_.begin(), microseconds_.end());
    const auto at = [&](double part) {
      return microseconds_[static_cast<std::size_t>(part * static_cast<double>(microseconds_.size() - 1))];
    };
    return {at(0.5), at(0.99), at(0.999), microseconds_.back()};
  }

 private:
  std::vector<double> microseconds_;
};

void print(const std::string& what, const Percentiles& p, const std::string& note = "") {
  std::printf("| %-46s | %6.2f | %6.2f | %6.2f | %7.1f | %s |\n", what.c_str(), p.p50, p.p99, p.p999, p.worst,
              note.c_str());
}

double dot(const Vector6& a, const Vector6& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}

/// The peer: projected Gauss-Seidel on the dual (Hildreth), a fixed number of sweeps.
Vector6 gaussSeidel(std::span<const SolverRow> rows, const Vector6& d0, int sweeps) {
  Vector6 d = d0;
  std::array<double, kMaxRows> multiplier{};
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double wanted = multiplier[i] - (dot(rows[i].normal, d) + rows[i].slack);
      const double step = std::max(0.0, wanted) - multiplier[i];
      multiplier[i] += step;
      for (std::size_t k = 0; k < 6; ++k) d[k] += step * rows[i].normal[k];
    }
  }
  return d;
}

double distance(const Vector6& a, const Vector6& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

Vector6 direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Vector6 v{};
  for (double& number : v) number = normal(random);
  const double length = std::sqrt(dot(v, v));
  for (double& number : v) number /= length;
  return v;
}

/// Obstacles all round a free core, each curved, each a group of its own (or four to a group).
ConstraintSet curvedSet(std::uint64_t sequence, std::size_t groups, const Pose& X_DR, std::mt19937_64& random) {
  std::uniform_real_distribution<double> gap(0.001, 0.004);
  ConstraintSet set;
  set.sequence = sequence;
  set.X_DR = X_DR;
  set.count = kMaxConstraints;
  for (std::size_t i = 0; i < set.count; ++i) {
    Constraint& c = set.constraints[i];
    const Vector6 n = direction(random);
    const double linear = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    c.group = static_cast<std::uint32_t>(i % groups);
    c.gap = gap(random);
    for (std::size_t k = 0; k < 3; ++k) c.gradient[k] = n[k] / linear;
    for (std::size_t k = 3; k < 6; ++k) c.gradient[k] = 0.05 * n[k];
    for (std::size_t k = 0; k < c.curvature.size(); ++k) c.curvature[k] = 0.5 * n[k % 6];
    c.curvature[0] += 20.0;
    c.curvature[6] += 20.0;
    c.curvature[11] += 20.0;
    c.friction = 0.2;
  }
  return set;
}

/// The same ticks each time: a stylus dragged through curved entries, a new set every 17 ticks.
class TickRun {
 public:
  explicit TickRun(std::size_t groups) {
    std::mt19937_64 random(5);
    sets_.resize(64);
    for (std::uint64_t i = 0; i < 64; ++i) sets_[i].prepare(curvedSet(i, groups, Pose::identity(), random));
    renderer_->reset(Pose::identity());
  }

  static bool takesSetOver(int tick) { return tick % 17 == 0; }
  double meanRows() const { return static_cast<double>(rows_) / ticks_; }

  /// Numbers that a tick does not count with are made before `work` is called.
  template <typename Around>
  void tick(Around&& around) {
    const int i = ticks_++;
    const double t = 1e-3 * i;
    const dvec3 p = 0.008 * dvec3(std::sin(7.0 * t), std::sin(11.0 * t + 1.0), std::sin(13.0 * t + 2.0));
    const Pose X_DS{p, quaternionFromRotationVector(0.1 * dvec3(std::sin(3.0 * t), std::cos(5.0 * t), 0.3))};
    GroupedSet& next = sets_[static_cast<std::size_t>(i / 17) % sets_.size()];
    next.sequence = static_cast<std::uint64_t>(ticks_);
    around([&] {
      if (takesSetOver(i)) renderer_->adopt(next, 0.0);
      const RenderResult result = renderer_->tick(X_DS, 1e-3);
      SafetyInput input;
      input.force_D = result.force_D;
      input.v_DS = result.v_DS;
      input.enabled = true;
      renderer_->noteApplied(chain_.tick(input).force_D);
      rows_ += result.active_rows;
    });
  }

 private:
  std::vector<GroupedSet> sets_;  ///< Prepared, as by the server's thread that receives them.
  std::unique_ptr<ForceRenderer> renderer_ = std::make_unique<ForceRenderer>();
  SafetyChain chain_;
  std::size_t rows_ = 0;
  int ticks_ = 0;
};

void benchTick(std::size_t groups, int ticks) {
  Samples samples(static_cast<std::size_t>(ticks));
  TickRun run(groups);
  for (int i = 0; i < ticks; ++i) run.tick([&](auto&& work) { samples.time(work); });
  print("tick, 64 curved entries in " + std::to_string(groups) + " groups, sets at 60 Hz", samples.percentiles(),
        std::to_string(run.meanRows()).substr(0, 4) + " rows active");
}

/// Each tick by the clock, least of the same tick in seven runs: without what other programs take, and without the call
/// for the thread's time. By kind of tick.
void benchLeastTick(std::size_t groups, int ticks) {
  constexpr int kRuns = 7;
  std::vector<double> least(static_cast<std::size_t>(ticks), 1e9);
  for (int k = 0; k < kRuns; ++k) {
    TickRun run(groups);
    for (double& one : least) {
      run.tick([&](auto&& work) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - begin;
        one = std::min(one, passed.count());
      });
    }
  }
  Samples all(least.size()), takeovers(least.size()), others(least.size());
  for (int i = 0; i < ticks; ++i) {
    const double one = least[static_cast<std::size_t>(i)];
    all.add(one);
    (TickRun::takesSetOver(i) ? takeovers : others).add(one);
  }
  const std::string which = std::to_string(groups) + " groups, least of 7: ";
  print(which + "all ticks", all.percentiles());
  print(which + "takes a set over", takeovers.percentiles());
  print(which + "all others", others.percentiles());
}

struct Case {
  std::string name;
  std::function<std::vector<SolverRow>(std::mt19937_64&)> rows;
};

std::vector<SolverRow> randomRows(std::mt19937_64& random) {
  std::uniform_real_distribution<double> slack(0.0, 2e-3);
  std::vector<SolverRow> rows(64);
  for (SolverRow& row : rows) row = {direction(random), slack(random), false};
  return rows;
}

std::vector<SolverRow> boreRows(std::mt19937_64&) {
  std::vector<SolverRow> rows(64);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / 64.0;
    rows[i] = {{-std::cos(angle), -std::sin(angle), 0, 0, 0, 0}, 1e-3, false};
  }
  return rows;
}

std::vector<SolverRow> facetRows(std::mt19937_64& random) {
  std::uniform_real_distribution<double> tilt(-0.017, 0.017), slack(0.0, 1e-4);
  std::vector<SolverRow> rows(64);
  for (SolverRow& row : rows) {
    const dvec3 n = glm::normalize(dvec3(tilt(random), tilt(random), 1.0));
    row = {{n.x, n.y, n.z, 0, 0, 0}, slack(random), false};
  }
  return rows;
}

std::vector<SolverRow> infeasibleRows(std::mt19937_64& random) {
  std::vector<SolverRow> rows = facetRows(random);
  for (std::size_t i = 32; i < rows.size(); ++i) {
    for (double& number : rows[i].normal) number = -number;
    rows[i].slack = -1e-3;
  }
  return rows;
}

void benchSolver(const Case& which, int count) {
  std::mt19937_64 random(6);
  Samples ours(static_cast<std::size_t>(count)), peer(static_cast<std::size_t>(count));
  double peer_error = 0.0;
  int solved = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<SolverRow> rows = which.rows(random);
    Vector6 d0 = direction(random);
    for (double& number : d0) number *= 5e-3;
    SolverResult result;
    Vector6 other{};
    ours.time([&] { result = nearestFeasible(rows, d0); });
    peer.time([&] { other = gaussSeidel(rows, d0, 100); });
    if (result.status != SolverStatus::kSolved) continue;
    ++solved;
    peer_error = std::max(peer_error, distance(result.d, other));
  }
  print(which.name + ": active set", ours.percentiles());
  char note[64] = "no solution exists";
  if (solved > 0) std::snprintf(note, sizeof note, "wrong by up to %.3f mm", peer_error * 1e3);
  print(which.name + ": Gauss-Seidel, 100 sweeps", peer.percentiles(), note);
}

void benchDevice(int ticks) {
  SimulatedDevice device;
  if (!device.open()) return;
  Samples samples(static_cast<std::size_t>(ticks));
  for (int i = 0; i < ticks; ++i) {
    device.hand().hold(Pose::translation(0.03 * dvec3(std::sin(0.01 * i), std::cos(0.013 * i), 0.0)));
    samples.time([&] {
      device.advance(1e-3);
      DeviceReading reading;
      device.read(reading);
      device.write(dvec3(0, 0, 1), dvec3(0.0));
    });
  }
  print("simulated device, one tick (10 steps of 0.1 ms)", samples.percentiles());
}

}  // namespace
}  // namespace hapticell::haptic

int main(int argc, char** argv) {
  using namespace hapticell::haptic;
  const int ticks = argc > 1 ? std::max(1000, std::atoi(argv[1])) : 100000;
  std::printf("| %-46s | p50 us | p99 us | 99.9 us | worst us | |\n|---|---|---|---|---|---|\n", "what");
  benchTick(64, ticks);
  benchTick(16, ticks);
  benchLeastTick(64, ticks / 5);
  benchLeastTick(16, ticks / 5);
  if (argc > 2) return 0;
  benchDevice(ticks);
  for (const Case& which : {Case{"random half-spaces", randomRows}, Case{"64 tangents of a bore", boreRows},
                            Case{"facets within a degree", facetRows}, Case{"infeasible slot", infeasibleRows}}) {
    benchSolver(which, ticks / 5);
  }
  return 0;
}
