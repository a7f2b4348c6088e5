// SPDX-License-Identifier: Apache-2.0
// M13: the same scenes as meshes through the proximity engine, beside exact geometry of the same run.
#include <memory>
#include <string>
#include <vector>

#include "feel/figure_job.h"
#include "feel/mesh_scenes.h"
#include "feel/part_scenes.h"

namespace hapticell::feel {

namespace {

// s: the way of the scenes (0.6 s) five times, so that each place is met from both sides. Half: fewer sets; twice:
// twice the time for the same figures.
constexpr double kMeshSlide = 3.0;
// mm that the drawn ball may be inside the drawn part: kMostRelief, by which hollows are sunk to be as wide as they are
// round. Half fails where a hollow is coarse; twice would hide what is entered.
constexpr double kDrawn =
    0.1;  // mm that the drawn ball may be inside the drawn part: a hollow is as wide as it is round.

FeelFigures slide(const MeshCase& of, const ClientRate& rate, bool mesh) {
  SessionSetup setup;
  setup.rate = rate;
  if (mesh) setup.seen = of.mesh.get();
  FeelSession session(*of.exact, setup);
  touchAndSlide(session, *of.exact, kMeshSlide);
  return session.figures();
}

FeelFigures slideClassic(const MeshCase& of, const FeelScene* seen) {
  SessionSetup old;
  old.rate = kRates[0];
  old.classic = true;
  old.seen = seen;
  FeelSession session(*of.exact, old);
  touchAndSlide(session, *of.exact, kMeshSlide);
  return session.figures();
}

std::vector<Figure> meshFigures(const std::string& name, const ClientRate& rate) {
  const MeshCase of = makeMeshCase(name);
  const FeelFigures mesh = slide(of, rate, true), exact = slide(of, rate, false);
  const FeelFigures classic = slideClassic(of, nullptr);
  const std::string at = rateName(rate);
  std::vector<Figure> figures;
  const auto add = [&](const char* id, const char* unit, double value, double limit, double classic_value) {
    Figure figure{id, name, at, unit, value, limit, false, classic_value};
    figure.at_least = std::string(id) == "M13.energy";
    figures.push_back(figure);
  };
  add("M13.step", "N/ms", mesh.step_n, exact.step_n + 0.015, classic.step_n);
  add("M13.depth_p95", "%", 100.0 * mesh.depth_error_p95, 100.0 * exact.depth_error_p95 + 1.0,
      100.0 * classic.depth_error_p95);
  add("M13.direction", "deg", mesh.direction_p95_deg, exact.direction_p95_deg + 1.0, classic.direction_p95_deg);
  add("M13.energy", "mJ", 1e3 * mesh.energy_min, -0.5, 1e3 * classic.energy_min);
  add("M13.penetration", "mm", 1e3 * mesh.penetration, 0.05, 1e3 * classic.penetration);
  return figures;
}

/// Nothing exact is known beside these: the force's steps are told, and nothing may be entered or made.
std::vector<Figure> partFigures(const Part& part, const ClientRate& rate) {
  const MeshCase of = makePartCase(part);
  const FeelFigures ours = slide(of, rate, true), classic = slideClassic(of, of.mesh.get());
  const std::string at = rateName(rate);
  Figure step{"M13.step", part.name, at, "N/ms", ours.step_n}, energy{"M13.energy", part.name, at, "mJ"};
  Figure inside{"M13.penetration", part.name, at, "mm", 1e3 * ours.penetration, kDrawn};
  Figure round{"M13.round_ball", part.name, at, "mm", 1e3 * ours.round_penetration};
  energy.value = 1e3 * ours.energy_min;
  energy.limit = -0.5;
  energy.at_least = true;
  step.classic = classic.step_n;
  energy.classic = 1e3 * classic.energy_min;
  inside.classic = 1e3 * classic.penetration;
  round.classic = 1e3 * classic.round_penetration;
  return {step, energy, inside, round};
}

}  // namespace

void addMeshJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs) {
  for (const std::string& name : meshCaseNames()) {
    for (const ClientRate& rate : kRates) {
      if (rate.rate_hz > 100.0 && !options.full) continue;  // A thousand queries a second are not virtual.
      jobs.push_back({{"M13"}, name, [name, rate] { return meshFigures(name, rate); }});
    }
  }
  std::vector<Part> parts = freeFormParts();
  parts.insert(parts.end(), options.parts.begin(), options.parts.end());
  for (const Part& given : parts) {
    const auto part = std::make_shared<const Part>(given);  // Jobs are copied.
    for (const ClientRate& rate : kRates) {
      if (rate.rate_hz > 100.0 && !options.full) continue;
      jobs.push_back({{"M13"}, part->name, [part, rate] { return partFigures(*part, rate); }});
    }
  }
}

}  // namespace hapticell::feel
