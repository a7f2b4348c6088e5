// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "xacro/value.h"

namespace hapticell::xacro {

/// The value of a YAML file (YAML 1.1, as PyYAML reads it, so that both give the same robot: yes is true, 010 is eight,
/// 1e3 is a text), named as an include is. Tags !degrees, !radians, !meters, !millimeters, !foot and !inches evaluate
/// an expression and bring it to radians or metres; other tags are a Fault, as are what is no YAML, keys that are lists
/// and what the budget does not allow. Faults name the file and its line.
Value loadYaml(const std::string& reference, Interpreter& interpreter);

}  // namespace hapticell::xacro
