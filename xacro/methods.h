// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "xacro/value.h"

namespace hapticell::xacro {

/// The function that `value.name` is, of those that texts, lists and dictionaries have here: they read the value and
/// make a new one. Nothing for all other names.
std::optional<Value> methodOf(const Value& value, const std::string& name);

}  // namespace hapticell::xacro
