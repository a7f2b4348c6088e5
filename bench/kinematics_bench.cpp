// SPDX-License-Identifier: Apache-2.0
// How long the inverse models take; docs/dev/performance.md, "Kinematics", quotes the figures.
//
// usage: kinematics_bench [PART] [POSES]; PART: closed, all, seven, numeric, path (default: every one)
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/kinematics_figures.h"

int main(int argc, char** argv) {
  const std::string part = argc > 1 ? argv[1] : "";
  const int poses = argc > 2 ? std::atoi(argv[2]) : 10000;
  if (poses < 100) {
    std::fprintf(stderr, "usage: kinematics_bench [closed|all|seven|numeric|path] [POSES, 100 or more]\n");
    return 2;
  }
  if (part.empty() || part == "closed") hapticell::bench::closedForms(poses);
  if (part.empty() || part == "all") hapticell::bench::allSolutions(poses);
  if (part.empty() || part == "seven") hapticell::bench::sevenAxisLists(poses);
  if (part.empty() || part == "numeric") hapticell::bench::numericInverse(poses);
  if (part.empty() || part == "path") hapticell::bench::paths(poses);
  return 0;
}
