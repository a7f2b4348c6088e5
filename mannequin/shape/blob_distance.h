// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/shape/body_shape.h"

namespace hapticell::mannequin {

/// About the distance (m) of a point to a blob, in its frame.
double distanceTo(const Blob& blob, const dvec3& p);

}  // namespace hapticell::mannequin
