// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <string>

#include "workcell/text_cursor.h"

namespace hapticell::cli {

/// A number from `least` to `greatest`. CLI11's own Range lets "nan" through, since no comparison with it is true.
inline CLI::Validator numberRange(double least, double greatest) {
  char words[80];
  std::snprintf(words, sizeof words, "a number from %g to %g", least, greatest);
  return CLI::Validator(
      [=, expected = std::string(words)](std::string& text) {
        const auto value = workcell::parseNumber(text);
        const bool good = value && std::isfinite(*value) && *value >= least && *value <= greatest;
        return good ? std::string() : "'" + text + "' found, " + expected + " expected";
      },
      words);
}

}  // namespace hapticell::cli
