// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "xacro/value.h"

namespace hapticell::xacro {

/// The method `value.name` of a text, list or dictionary. The supported methods read the value and return a new one.
/// Empty for all other names.
std::optional<Value> methodOf(const Value& value, const std::string& name);

}  // namespace hapticell::xacro
