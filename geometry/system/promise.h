// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell {

/// A requirement on a result (a tolerance, a limit, a clearance) and the value measured on the result as written. The
/// measuring code shares nothing with the code that made the result (docs/dev/reliability.md lists all promises).
struct Promise {
  std::string name;          ///< For reports: "position", "velocity"; unique within one result.
  double asked = 0.0;        ///< In the unit of `measured`.
  double measured = 0.0;     ///< SI, or a share of a limit.
  std::string unit{};        ///< "m", "rad", "s"; empty: a share of the limit.
  Text place{};              ///< Where the worst value is: "at 1.2 s, frame 30"; empty if there is no deviation.
  bool is_at_least = false;  ///< `asked` is a minimum (a clearance), not a maximum.
  double rounding = 0.0;     ///< Rounding error of `measured`; it may exceed the limit by this much.
  /// Said instead of the numbers if it is missed: "link_4 touches wall", "no contact". Empty: the numbers.
  Text found{}, expected{};

  bool isKept() const;
};

/// All promises of one result.
struct Promises {
  std::vector<Promise> list;
  Text help;  ///< What the user can do if a promise is missed; a whole sentence.
  bool can_be_forced = true;  ///< What makes the file has --allow-miss.

  bool areKept() const;
  /// The promise that is missed by the largest share; nullptr if all are kept.
  const Promise* worst() const;
  /// "position 0.0137 m at 1.2 s, frame 30; expected at most 0.001 m. HELP" about `file`. @pre !areKept()
  Error missed(const std::string& file) const;
};

}  // namespace hapticell
