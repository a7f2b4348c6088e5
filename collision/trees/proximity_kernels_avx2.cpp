// SPDX-License-Identifier: Apache-2.0
#define HAPTICELL_KERNELS kKernelsAvx2
#define HAPTICELL_KERNELS_NAME "avx2"
#define HAPTICELL_PACKED_LANES Float8
#define HAPTICELL_BOX_LANES Float8
#define HAPTICELL_EXACT_LANES Double4
#include "collision/trees/proximity_kernels_body.h"
