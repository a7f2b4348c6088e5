// SPDX-License-Identifier: Apache-2.0
// M13: the same scenes as meshes through the proximity engine, beside exact geometry of the same run.
#include "feel/figure_job.h"
#include "feel/mesh_scenes.h"

namespace hapticell::feel {

namespace {

constexpr double kSlide = 3.0;  // s.

FeelFigures slide(const MeshCase& of, const ClientRate& rate, bool mesh) {
  SessionSetup setup;
  setup.rate = rate;
  if (mesh) setup.seen = of.mesh.get();
  FeelSession session(*of.exact, setup);
  touchAndSlide(session, *of.exact, kSlide);
  return session.figures();
}

std::vector<Figure> meshFigures(const std::string& name, const ClientRate& rate) {
  const MeshCase of = makeMeshCase(name);
  const FeelFigures mesh = slide(of, rate, true), exact = slide(of, rate, false);
  SessionSetup old;
  old.rate = kRates[0];
  old.classic = true;
  FeelSession session(*of.exact, old);
  touchAndSlide(session, *of.exact, kSlide);
  const FeelFigures classic = session.figures();
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

}  // namespace

void addMeshJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs) {
  for (const std::string& name : meshCaseNames()) {
    for (const ClientRate& rate : kRates) {
      if (rate.rate_hz > 100.0 && !options.full) continue;  // A thousand queries a second are not virtual.
      jobs.push_back({{"M13"}, name, [name, rate] { return meshFigures(name, rate); }});
    }
  }
}

}  // namespace hapticell::feel
