// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell {

/// What somebody asked of a result (a tolerance, a limit, a clearance), and what was measured on the result as it was
/// written, by code that shares nothing with the code that made it (docs/dev/reliability.md lists all of them).
struct Promise {
  std::string name;          ///< A word for reports: "position", "velocity"; of one result each once.
  double asked = 0.0;        ///< In the unit of `measured`.
  double measured = 0.0;     ///< SI, or a share of a limit.
  std::string unit{};        ///< "m", "rad", "s"; empty: a share, 1 is the limit.
  std::string place{};       ///< Where the worst is: "at 1.2 s, frame 30"; empty where nothing is off.
  bool is_at_least = false;  ///< `asked` is the least (a clearance), not the most.
  double rounding = 0.0;     ///< Of what is measured; by so much it may be passed.

  bool isKept() const;
};

/// All promises of one result.
struct Promises {
  std::vector<Promise> list;
  std::string help;  ///< What the user can do where one is missed; a whole sentence.

  bool areKept() const;
  /// Of those that are missed the one that is so by the largest share; nullptr where all are kept.
  const Promise* worst() const;
  /// "position 0.0137 m at 1.2 s, frame 30; expected at most 0.001 m. HELP" about `file`. @pre !areKept()
  Error missed(const std::string& file) const;
};

}  // namespace hapticell
