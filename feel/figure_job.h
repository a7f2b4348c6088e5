// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "feel/benchmark.h"
#include "feel/feel_session.h"
#include "feel/figure.h"

namespace hapticell::feel {

/// Some figures that are computed from the same sessions. Jobs share nothing and may run at the same time.
struct FigureJob {
  std::vector<std::string> ids;  ///< "M1", "M2" ...
  std::string scene;
  std::function<Expected<std::vector<Figure>>()> run;
  bool alone = false;  ///< Measured by the wall clock: nothing else may run.
};

using SceneMaker = std::function<Expected<std::unique_ptr<FeelScene>>()>;
struct NamedScene {
  std::string name;
  SceneMaker make;
};

/// The scenes of the benchmark's list, exact geometry without friction.
std::vector<NamedScene> benchmarkScenes();

/// "10 Hz + 50 ms"
std::string rateName(const ClientRate& rate);

void addSlidingJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs);    // M1..M4, M9, M14
void addEnergyJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs);     // M3 of taps, M6
void addStabilityJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs);  // M5, M10
void addWallJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs);       // M8, M12
void addMeshJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs);       // M13
void addNetworkJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs);    // NET: M1..M4 over a bad network
void addTimedJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs);      // M7, M11

}  // namespace hapticell::feel
