// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "xacro/scope.h"

namespace hapticell::xacro {

/// Puts into `scope` what expressions may name besides properties: Python's list, dict, map, len, str, float, int,
/// min, max, round, sorted, range; all of its module math, also as math.NAME; python.NAME with abs, all, any, divmod,
/// enumerate, filter, ord, repr, reversed, sum, tuple, zip besides; xacro.load_yaml, arg, abs_filename, dotify,
/// tokenize, message, warning, error, fatal, print_location.
void addBuiltIns(Scope& scope, Scopes& scopes);

/// The two parts of it: of built_ins.cpp and of math_functions.cpp.
void addMathFunctions(Scope& scope, Scope& name_space);

}  // namespace hapticell::xacro
