// SPDX-License-Identifier: Apache-2.0
#define HAPTICELL_KERNELS kKernelsAvx512
#define HAPTICELL_KERNELS_NAME "avx512"
#define HAPTICELL_PACKED_LANES Float16
#define HAPTICELL_BOX_LANES Float8
#define HAPTICELL_EXACT_LANES Double8
#include "collision/trees/proximity_kernels_body.h"
