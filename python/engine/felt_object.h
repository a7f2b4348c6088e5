// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include "haptic/protocol/messages.h"

namespace hapticell::python {

/// hapticell.Felt of a state. Needs the interpreter's lock.
pybind11::object feltObject(const haptic::HapticState& state);

}  // namespace hapticell::python
