// SPDX-License-Identifier: Apache-2.0
#define HAPTICELL_KERNELS kKernelsPortable
#define HAPTICELL_KERNELS_NAME "portable"
#define HAPTICELL_PACKED_LANES Float4
#define HAPTICELL_BOX_LANES Float4
#define HAPTICELL_EXACT_LANES Double2
#include "collision/trees/proximity_kernels_body.h"
