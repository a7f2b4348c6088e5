// SPDX-License-Identifier: Apache-2.0
#pragma once

// The gizmo lives with the viewport now, since solids have it too.
#include "app/viewport/gizmo.h"  // IWYU pragma: export
