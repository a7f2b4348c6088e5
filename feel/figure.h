// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace hapticell::feel {

/// One line of the benchmark.
struct Figure {
  std::string id;     ///< M1 .. M14; if a measurement has several values, with the value's name: "M2.penetration".
  std::string scene;  ///< "flat wall"
  std::string rate;   ///< "10 Hz + 50 ms"; empty where it does not depend on one.
  std::string unit;   ///< "N/ms", "mm", "%" ...
  double value = 0.0;
  std::optional<double> limit = {};    ///< None: only reported.
  bool at_least = false;               ///< The limit is a minimum, not a maximum.
  std::optional<double> classic = {};  ///< The same of a single moving plane at 10 Hz + 50 ms.

  /// A value that is no number never passes.
  bool pass() const {
    if (!limit) return value == value;
    return at_least ? value >= *limit : value <= *limit;
  }
};

}  // namespace hapticell::feel
