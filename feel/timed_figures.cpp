// SPDX-License-Identifier: Apache-2.0
// What only a clock on the wall can tell. M7: stylus motion to constraint over a loopback connection. M11: one tick.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "feel/figure_job.h"
#include "feel/rendering_way.h"
#include "geometry/shapes/shapes.h"
#include "geometry/system/percentile.h"
#include "manipulation/session/local_server.h"
#include "manipulation/session/server_session.h"
#include "manipulation/session/session.h"

namespace hapticell::feel {

namespace {

using Clock = std::chrono::steady_clock;

/// 196 balls of 5040 triangles: the cell of a million that M7 asks for. Half: a quarter of it; twice: four times.
constexpr int kBallsOnSide = 14;
/// Segments of a ball: 5040 triangles, so that 14 x 14 of them are a million. Half: a quarter of the triangles; twice:
/// four times.
constexpr int kBallSegments = 72;
/// s of hand, some 4 of them in contact: 4000 latencies. Half: p99 of 2000; twice: longer for the same figure.
constexpr double kHandTime = 6.0;
constexpr int kTicksOfASet = 17;  // 60 Hz.
/// Equal walks of which the least time of each tick counts. Half: the system's own pauses show in p99.9; twice: twice
/// the time.
constexpr int kWalks = 3;

workcell::Entity solid(workcell::EntityId id, const std::string& name,
                       std::shared_ptr<const geometry::TriangleMesh> mesh, const dvec3& p_WE) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = name;
  entity.X_WE = Pose::translation(p_WE);
  entity.body = workcell::Solid{std::move(mesh)};
  return entity;
}

/// A box over a table among a million triangles of balls.
std::vector<workcell::Entity> crowdedCell() {
  const auto box = std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.06)));
  const auto table = std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({3.0, 3.0, 0.1}));
  const auto ball = std::make_shared<const geometry::TriangleMesh>(geometry::makeSphere(0.04, kBallSegments));
  std::vector<workcell::Entity> entities{solid(1, "table", table, {0, 0, -0.05}), solid(2, "box", box, {0, 0, 0.035})};
  for (int i = 0; i < kBallsOnSide * kBallsOnSide; ++i) {
    const int column = i % kBallsOnSide, row = i / kBallsOnSide;
    const dvec3 p(0.2 * column - 1.3, 0.2 * row - 1.3, 0.04);
    entities.push_back(solid(static_cast<workcell::EntityId>(i) + 3, "ball " + std::to_string(i + 1), ball, p));
  }
  return entities;
}

haptic::HandPath slidingHand() {
  std::vector<haptic::HandSample> samples;
  for (int i = 0; i <= static_cast<int>(100.0 * kHandTime); ++i) {
    const double t = 0.01 * i, down = std::clamp(t - 1.5, 0.0, 1.0) * 0.012;
    const dvec3 p(0.025 * std::sin(2.0 * t), 0.025 * std::sin(3.1 * t), -down);
    samples.push_back({t, Pose::translation(p), t >= 0.05 && t < 0.15 ? 1U : 0U});
  }
  return haptic::HandPath(std::move(samples));
}

Expected<std::vector<Figure>> latencyFigures() {
  manipulation::SessionOptions options;
  options.entities = crowdedCell();
  options.entity = "box";
  options.hand = slidingHand();
  auto server = manipulation::LocalServer::start(options.device, options.configuration);
  HAPTICELL_TRY(server);
  const auto report = manipulation::runSessionOnServer(options, "127.0.0.1", (*server)->port());
  HAPTICELL_TRY(report);
  options.configuration.manipulation.rate_hz = kRates[0].rate_hz;
  const auto classic = manipulation::runSessionOnServer(options, "127.0.0.1", (*server)->port());
  HAPTICELL_TRY(classic);
  const char* scene = "box among a million triangles, loopback";
  return std::vector<Figure>{
      {"M7.p50", scene, "", "ms", report->delays.latency_p50_ms, 2.0, false, classic->delays.latency_p50_ms},
      {"M7.p99", scene, "", "ms", report->delays.latency_p99_ms, 10.0, false, classic->delays.latency_p99_ms}};
}

haptic::Vector6 direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  haptic::Vector6 v{};
  double sum = 0.0;
  for (double& number : v) {
    number = normal(random);
    sum += number * number;
  }
  for (double& number : v) number /= std::sqrt(sum);
  return v;
}

/// Obstacles all round a free core, each curved and a group of its own. Every fifth is there twice, every seventh has
/// an opposite that contradicts it.
ConstraintSet crowdedSet(std::mt19937_64& random) {
  std::uniform_real_distribution<double> gap(0.001, 0.004);
  ConstraintSet set;
  set.count = haptic::kMaxConstraints;
  for (std::size_t i = 0; i < set.count; ++i) {
    Constraint& c = set.constraints[i];
    c.friction = 0.2;
    if (i % 5 == 4 || i % 7 == 6) {
      c = set.constraints[i - 1];
      if (i % 7 == 6) {
        for (double& number : c.gradient) number = -number;
        c.gap = -c.gap - 1e-4;
      }
    } else {
      const haptic::Vector6 n = direction(random);
      const double linear = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (std::size_t k = 0; k < 6; ++k) c.gradient[k] = k < 3 ? n[k] / linear : 0.05 * n[k];
      c.gap = gap(random);
      c.curvature[0] = c.curvature[6] = c.curvature[11] = 20.0;
    }
    c.group = static_cast<std::uint32_t>(i);
    c.id = i + 1;
  }
  return set;
}

/// Microseconds of each tick of one walk through the sets, reading the clock included.
std::vector<double> walk(RenderingWay& way, const std::vector<ConstraintSet>& sets, int ticks) {
  haptic::SafetyChain chain;
  way.reset(Pose::identity());
  std::vector<double> microseconds;
  microseconds.reserve(static_cast<std::size_t>(ticks));
  for (int i = 0; i < ticks; ++i) {
    const double t = 1e-3 * i;
    const dvec3 p = 0.008 * dvec3(std::sin(7.0 * t), std::sin(11.0 * t + 1.0), std::sin(13.0 * t + 2.0));
    const bool is_new = i % kTicksOfASet == 0;
    ConstraintSet set;
    if (is_new) set = way.sent(sets[static_cast<std::size_t>(i / kTicksOfASet) % sets.size()]);
    set.sequence = static_cast<std::uint64_t>(i) + 1;
    const Clock::time_point begin = Clock::now();
    if (is_new) way.offer(set, 0.0);
    const haptic::RenderResult result = way.tick(Pose::translation(p), 1e-3);
    haptic::SafetyInput input;
    input.force_D = result.force_D;
    input.v_DS = result.v_DS;
    input.enabled = true;
    way.noteApplied(chain.tick(input).force_D, dvec3(0.0));
    microseconds.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
  }
  return microseconds;
}

/// Each tick's time is the least of some equal walks: what the system takes for others is out, the loop's own peaks
/// stay in.
std::vector<double> leastOfWalks(RenderingWay& way, const std::vector<ConstraintSet>& sets, int ticks) {
  std::vector<double> least = walk(way, sets, ticks);
  for (int again = 1; again < kWalks; ++again) {
    const std::vector<double> times = walk(way, sets, ticks);
    for (std::size_t i = 0; i < times.size(); ++i) least[i] = std::min(least[i], times[i]);
  }
  return least;
}

std::vector<Figure> tickFigures(int ticks) {
  std::mt19937_64 random(5);
  // Random sets in turn: 544 ticks until one comes again. Half: fewer kinds of sets; twice: the same figures.
  constexpr std::size_t kSets = 32;
  std::vector<ConstraintSet> sets;
  sets.reserve(kSets);
  while (sets.size() < kSets) sets.push_back(crowdedSet(random));
  const auto proxy = std::make_unique<ProxyWay>(haptic::RendererOptions{});
  const auto plane = std::make_unique<ClassicWay>(haptic::RendererOptions{});
  std::vector<double> ours = leastOfWalks(*proxy, sets, ticks), classic = leastOfWalks(*plane, sets, ticks);
  const char* scene = "64 curved entries in 64 groups";
  return {{"M11.p99", scene, "", "us", percentile(ours, 0.99), 50.0, false, percentile(classic, 0.99)},
          {"M11.p999", scene, "", "us", percentile(ours, 0.999), 100.0, false, percentile(classic, 0.999)}};
}

}  // namespace

void addTimedJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs) {
  const int ticks = options.full ? 100000 : 20000;
  jobs.push_back({{"M7"}, "box among a million triangles, loopback", latencyFigures, true});
  jobs.push_back({{"M11"}, "64 curved entries in 64 groups", [ticks] { return tickFigures(ticks); }, true});
}

}  // namespace hapticell::feel
