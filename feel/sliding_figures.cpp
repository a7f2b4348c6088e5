// SPDX-License-Identifier: Apache-2.0
// M1 to M4 while sliding, M9 over a stall of the client, M14 on what moves or is seen through a scale, PLAN under the
// pull of a plan that changes ten times a second.
#include <cmath>
#include <cstdio>

#include "feel/figure_job.h"

namespace hapticell::feel {

namespace {

/// s: 40 sets at 10 Hz and six ways, each from both sides. Half: 20 sets, worst cases are missed; twice: the same
/// figures in twice the time.
constexpr double kSlide = 4.0;
/// N m of the six-axis device, as in config/devices/premium_6dof.toml. Half and twice: half and twice of what it has.
constexpr double kPeakTorque = 0.188;

/// What is asked of a scene; below 0: reported only.
struct Limits {
  double step = 0.10;         // N/ms.
  double penetration = 0.05;  // mm.
  double depth = 3.0;         // %.
  double depth_worst = 0.15;  // mm.
  double energy = -0.5;       // mJ.
  double direction = 3.0;     // degrees.
  double pull = -1.0;         // N/ms, of the pull alone.

  Limits times(double factor) const {
    return {step * factor,        penetration * factor, depth * factor,
            depth_worst * factor, energy * factor,      direction * factor, pull};
  }
};

struct Sliding {
  NamedScene scene;
  Limits limits{};
  double duration = kSlide;
  std::string id{};     // M14: all figures under this name.
  bool torque = false;  // On a device of six driven axes.
};

NamedScene plain(const std::string& name, std::unique_ptr<FeelScene> (*make)()) {
  return {name, [make]() -> Expected<std::unique_ptr<FeelScene>> { return make(); }};
}

template <typename Make>
NamedScene made(const std::string& name, Make make) {
  return {name, [make]() -> Expected<std::unique_ptr<FeelScene>> { return make(); }};
}

template <typename Make>
NamedScene rough(const std::string& name, Make make) {
  return made(name + ", friction 0.3", [make] {
    std::unique_ptr<FeelScene> scene = make();
    scene->friction = 0.3;
    return scene;
  });
}

std::vector<Sliding> slidings() {
  std::vector<Sliding> all;
  for (const NamedScene& scene : benchmarkScenes()) all.push_back({scene});
  Limits grip;
  grip.step = 0.13;
  all.push_back({rough("flat wall", planeScene), grip});
  all.push_back({rough("cylinder R10", [] { return cylinderScene(0.01); }), grip});
  all.push_back({rough("corner of three planes", cornerScene), grip});
  Limits facets;
  facets.step = 0.12;
  facets.direction = 5.0;
  all.push_back({made("cylinder R10 of 5 degree facets", [] { return facetScene(0.01, 5.0); }), facets});
  facets.direction = -1.0;
  all.push_back({made("cylinder R10 of 10 degree facets", [] { return facetScene(0.01, 10.0); }), facets});
  return all;
}

/// The obstacle on a conveyor, and motion scales; each within 1.5 times what is asked of what stands.
std::vector<Sliding> movedSlidings() {
  const Limits limits = Limits{}.times(1.5);
  Limits grip;
  grip.step = 0.13;
  std::vector<Sliding> all;
  const auto add = [&](const NamedScene& scene, const Limits& asked, double duration) {
    all.push_back({scene, asked, duration, "M14"});
  };
  add(made("conveyor 0.2 m/s, flat wall", [] { return driftingScene(planeScene(), {0.2, 0, 0}, 0.5); }), limits, 0.5);
  add(made("conveyor 0.2 m/s, flat wall, friction 0.3",
           [] {
             auto belt = planeScene();
             belt->friction = 0.3;
             return driftingScene(std::move(belt), {0.2, 0, 0}, 0.5);
           }),
      grip.times(1.5), 0.5);
  add(made("conveyor 0.2 m/s, cylinder R50",
           [] {
             return driftingScene(cylinderScene(0.05), {0.2, 0, 0}, 0.5);
           }),
      limits, 0.5);
  add(made("wall that comes at 0.1 m/s", [] { return driftingScene(planeScene(), {0, 0, 0.1}, 0.5); }), limits, 0.5);
  for (const NamedScene& scene : benchmarkScenes()) {
    if (scene.name.starts_with("peg") || scene.name.starts_with("robot")) {
      all.push_back({{scene.name + ", force and torque", scene.make}, limits, kSlide, "M14", true});
    }
  }
  all.push_back({made("box on flat wall, force and torque", boxScene), limits, kSlide, "M14", true});
  add(made("cylinder R500 at 10 m/m", [] { return scaledScene(cylinderScene(0.5), cylinderScene(0.05), 10.0); }),
      limits, kSlide);
  add(made("cylinder R5 at 0.1 m/m", [] { return scaledScene(cylinderScene(0.005), cylinderScene(0.05), 0.1); }),
      limits, kSlide);
  return all;
}

/// Under the pull of a changing plan, within what is asked without it.
std::vector<Sliding> plannedSlidings() {
  std::vector<Sliding> all;
  for (const char* name : {"flat wall", "cylinder R50", "bore R10", "corner of three planes", "hinge with stop"}) {
    for (const NamedScene& scene : benchmarkScenes()) {
      if (scene.name != name) continue;
      const auto make = [scene]() -> Expected<std::unique_ptr<FeelScene>> {
        auto plain = scene.make();
        HAPTICELL_TRY(plain);
        return plannedScene(std::move(*plain));
      };
      Limits limits;
      limits.pull = 0.05;
      all.push_back({{scene.name + ", changing plan", make}, limits, kSlide, "PLAN"});
    }
  }
  return all;
}

Expected<FeelFigures> slide(const Sliding& sliding, SessionSetup setup) {
  if (sliding.torque) setup.device.driven_axes = 6, setup.device.peak_torque = kPeakTorque;
  const auto scene = sliding.scene.make();
  HAPTICELL_TRY(scene);
  FeelSession session(**scene, setup);
  touchAndSlide(session, **scene, sliding.duration);
  FeelFigures figures = session.figures();
  if (figures.contact_ticks == 0) figures.step_n = std::nan("");  // Nothing was felt: nothing is proved.
  return figures;
}

void append(const Sliding& sliding, const std::string& rate, const FeelFigures& ours, const FeelFigures& classic,
            std::vector<Figure>& figures) {
  const Limits& limits = sliding.limits;
  const std::string prefix = sliding.id.empty() ? "" : sliding.id + ".";
  const auto add = [&](const std::string& id, const char* unit, double value, double limit, double classic_value) {
    Figure figure{prefix + id, sliding.scene.name, rate, unit, value};
    figure.at_least = id == "M3";
    if (figure.at_least || limit >= 0.0) figure.limit = limit;
    figure.classic = classic_value;
    figures.push_back(figure);
  };
  add("M1", "N/ms", ours.step_n, limits.step, classic.step_n);
  add("M2.penetration", "mm", 1e3 * ours.penetration, limits.penetration, 1e3 * classic.penetration);
  add("M2.depth_p95", "%", 100.0 * ours.depth_error_p95, limits.depth, 100.0 * classic.depth_error_p95);
  add("M2.depth_worst", "mm", 1e3 * ours.depth_error_max, limits.depth_worst, 1e3 * classic.depth_error_max);
  add("M3", "mJ", 1e3 * ours.energy_min, limits.energy, 1e3 * classic.energy_min);
  add("M4", "deg", ours.direction_p95_deg, limits.direction, classic.direction_p95_deg);
  if (limits.pull >= 0.0) add("pull", "N/ms", ours.pull_step_n, limits.pull, classic.pull_step_n);
}

Expected<std::vector<Figure>> slidingFigures(const Sliding& sliding) {
  SessionSetup old;
  old.rate = kRates[0];
  old.classic = true;
  const auto classic = slide(sliding, old);
  HAPTICELL_TRY(classic);
  std::vector<Figure> figures;
  for (const ClientRate& rate : kRates) {
    SessionSetup setup;
    setup.rate = rate;
    const auto ours = slide(sliding, setup);
    HAPTICELL_TRY(ours);
    append(sliding, rateName(rate), *ours, *classic, figures);
  }
  return figures;
}

struct StallOutcome {
  double step = 0.0;    // N/ms, stall included.
  double late = 0.0;    // mm of depth error once it must be true again.
  double inside = 0.0;  // mm.
};

/// Slides, the client stalls from 2.0 to 2.5 s of the session. True again: one latency after the first set, plus what
/// the offset then takes to fade at 0.05 mm/ms.
StallOutcome slideOverStall(const FeelScene& scene, const SessionSetup& setup) {
  FeelSession session(scene, setup);
  session.client().stall(2.0, 2.5);
  touchAndSlide(session, scene, 0.8);
  StallOutcome outcome;
  double truth = -1.0;
  const double press = pressDepth(session.hand());
  outcome.step = session.latest().step_n;
  for (int i = 0; i < 1000; ++i) {
    const bool was_back = session.client().backAt() >= 0.0;
    session.follow([&](double) { return scene.handAt(0.8 + 1e-3 * (i + 1), press); }, 1e-3);
    outcome.step = std::max(outcome.step, session.latest().step_n);
    outcome.inside = std::max(outcome.inside, 1e3 * session.latest().penetration);
    if (!was_back && session.client().backAt() >= 0.0) {
      truth = session.time() + setup.rate.latency + glm::length(session.last().offset_D) / 0.05;
    }
    if (truth > 0.0 && session.time() > truth) {
      outcome.late = std::max(outcome.late, 1e3 * session.latest().depth_error_max);
    } else {
      session.forgetFigures();
    }
  }
  return outcome;
}

/// The hand goes 0.3 m/s far out of a zone of 20 mm while the client stalls.
double insideBeyondZone(const FeelScene& scene, const SessionSetup& setup) {
  FeelSession session(scene, setup);
  session.client().setZone(0.02);
  session.client().stall(1.9, 2.4);
  const dvec3 from(-0.06, 0.004, 0.004), over(0.06, 0.004, -0.006);
  session.begin(from);
  session.follow([&](double t) { return glm::mix(from, dvec3(-0.06, 0.004, -0.006), std::min(1.0, t / 0.3)); }, 0.5);
  session.follow([&](double t) { return glm::mix(dvec3(-0.06, 0.004, -0.006), over, std::min(1.0, t / 0.4)); }, 1.2);
  return 1e3 * session.latest().penetration;
}

Expected<std::vector<Figure>> stallFigures(const NamedScene& named) {
  std::vector<Figure> figures;
  const auto scene = named.make();
  HAPTICELL_TRY(scene);
  SessionSetup old;
  old.rate = kRates[0];
  old.classic = true;
  const StallOutcome classic = slideOverStall(**scene, old);
  for (const ClientRate& rate : kRates) {
    SessionSetup setup;
    setup.rate = rate;
    const StallOutcome ours = slideOverStall(**scene, setup);
    const std::string at = rateName(rate);
    figures.push_back({"M9.step", named.name, at, "N/ms", ours.step, 0.10, false, classic.step});
    figures.push_back({"M9.true_again", named.name, at, "mm", ours.late, 0.15, false, classic.late});
    figures.push_back({"M9.inside", named.name, at, "mm", ours.inside, 0.05, false, classic.inside});
  }
  return figures;
}

Expected<std::vector<Figure>> beyondFigures() {
  std::vector<Figure> figures;
  const auto scene = plateScene();
  SessionSetup setup;
  setup.rate = kRates[0];
  setup.classic = true;
  const double classic = insideBeyondZone(*scene, setup);
  setup.classic = false;
  for (const ClientRate& rate : kRates) {
    setup.rate = rate;
    figures.push_back(
        {"M9.beyond_zone", "thin wall", rateName(rate), "mm", insideBeyondZone(*scene, setup), 0.0, false, classic});
  }
  return figures;
}

}  // namespace

std::vector<NamedScene> benchmarkScenes() {
  return {plain("flat wall", planeScene),
          made("cylinder R50", [] { return cylinderScene(0.05); }),
          made("cylinder R10", [] { return cylinderScene(0.01); }),
          made("bore R10", [] { return boreScene(0.01); }),
          plain("edge", edgeScene),
          plain("corner of three planes", cornerScene),
          plain("thin wall", plateScene),
          plain("peg in hole 0.05 mm", pegScene),
          {"robot joint limit", jointLimitScene},
          {"robot link contact", linkContactScene},
          plain("hinge with stop", hingeScene)};
}

std::string rateName(const ClientRate& rate) {
  char text[64];
  std::snprintf(text, sizeof text, "%.0f Hz + %.0f ms", rate.rate_hz, 1e3 * rate.latency);
  return text;
}

void addSlidingJobs(const BenchmarkOptions&, std::vector<FigureJob>& jobs) {
  for (const Sliding& sliding : slidings()) {
    jobs.push_back({{"M1", "M2", "M3", "M4"}, sliding.scene.name, [sliding] { return slidingFigures(sliding); }});
  }
  for (const char* name : {"flat wall", "cylinder R50", "bore R10", "corner of three planes"}) {
    for (const NamedScene& scene : benchmarkScenes()) {
      if (scene.name == name) jobs.push_back({{"M9"}, scene.name, [scene] { return stallFigures(scene); }});
    }
  }
  jobs.push_back({{"M9"}, "thin wall", beyondFigures});
  for (const Sliding& sliding : movedSlidings()) {
    jobs.push_back({{"M14"}, sliding.scene.name, [sliding] { return slidingFigures(sliding); }});
  }
  for (const Sliding& sliding : plannedSlidings()) {
    jobs.push_back({{"PLAN"}, sliding.scene.name, [sliding] { return slidingFigures(sliding); }});
  }
}

}  // namespace hapticell::feel
