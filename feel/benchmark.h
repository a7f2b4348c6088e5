// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "feel/figure.h"
#include "feel/part_scenes.h"
#include "geometry/system/error.h"

namespace hapticell::feel {

struct BenchmarkOptions {
  std::string only;              ///< A figure ("M4"), or part of a scene's name; empty: all. Case does not matter.
  bool full = false;             ///< The counts of docs/dev/feel.md instead of reduced ones.
  bool timing = false;           ///< Also what is measured by the wall clock: M7, M11.
  std::vector<Part> parts = {};  ///< Also felt, for M13: steps are only reported; energy and penetration have limits.
  std::function<void(const std::string& what)> progress = {};  ///< Called by one thread at a time.
  const std::atomic<bool>* stop = nullptr;  ///< Once true, it ends within a moment. Null: never.
};

/// Runs the benchmark of docs/dev/feel.md, in virtual time but for `timing`; the same build gives the same figures.
/// Runs on two threads. Errors: `only` matches no figure or scene, a shipped file is missing, stopped.
Expected<std::vector<Figure>> runBenchmark(const BenchmarkOptions& options);

}  // namespace hapticell::feel
