// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/shape/body_shape.h"

namespace hapticell::mannequin {

/// Approximate distance (m) of a point to a blob, in the blob's frame.
double distanceTo(const Blob& blob, const dvec3& p);

}  // namespace hapticell::mannequin
