// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Four doubles that are worked on together. These headers are compiled twice, for AVX2 and for the plain machine, so
// everything in them has internal linkage: nothing of one build may ever be linked into the other.
namespace hapticell::kinematics::kernels {
namespace {

#if defined(__AVX2__)

using Half = double __attribute__((vector_size(32)));
using HalfMask = long long __attribute__((vector_size(32)));
constexpr int kHalves = 1;
#else
// GCC lowers 32-byte compares and selects to scalar code on plain x86-64; two native halves stay in registers.
using Half = double __attribute__((vector_size(16)));
using HalfMask = long long __attribute__((vector_size(16)));
constexpr int kHalves = 2;
#endif
constexpr int kHalfWidth = 4 / kHalves;

struct Lanes {
  Half half[kHalves];

  Lanes() = default;
  Lanes(double value) {  // NOLINT: a number stands for four of it
    for (Half& h : half) h = Half{} + value;
  }
  Lanes(double a, double b, double c, double d) {
    const double values[4] = {a, b, c, d};
    __builtin_memcpy(half, values, sizeof values);
  }
  double operator[](int lane) const { return half[lane / kHalfWidth][lane % kHalfWidth]; }
};

struct Mask {
  HalfMask half[kHalves];
};

inline Lanes load(const double* from) {
  Lanes result;
  __builtin_memcpy(result.half, from, sizeof result.half);
  return result;
}
inline void store(double* to, const Lanes& value) {
  __builtin_memcpy(to, value.half, sizeof value.half);
}

#define HAPTICELL_LANE_OPERATOR(op)                                            \
  inline Lanes operator op(const Lanes& a, const Lanes& b) {                   \
    Lanes result;                                                              \
    for (int i = 0; i < kHalves; ++i) result.half[i] = a.half[i] op b.half[i]; \
    return result;                                                             \
  }
HAPTICELL_LANE_OPERATOR(+)
HAPTICELL_LANE_OPERATOR(-)
HAPTICELL_LANE_OPERATOR(*)
HAPTICELL_LANE_OPERATOR(/)
#undef HAPTICELL_LANE_OPERATOR

#define HAPTICELL_LANE_COMPARISON(op)                                                    \
  inline Mask operator op(const Lanes& a, const Lanes& b) {                              \
    Mask result;                                                                         \
    for (int i = 0; i < kHalves; ++i) result.half[i] = HalfMask(a.half[i] op b.half[i]); \
    return result;                                                                       \
  }
HAPTICELL_LANE_COMPARISON(<)
HAPTICELL_LANE_COMPARISON(>)
HAPTICELL_LANE_COMPARISON(<=)
HAPTICELL_LANE_COMPARISON(>=)
#undef HAPTICELL_LANE_COMPARISON

#define HAPTICELL_MASK_OPERATOR(op)                                            \
  inline Mask operator op(const Mask& a, const Mask& b) {                      \
    Mask result;                                                               \
    for (int i = 0; i < kHalves; ++i) result.half[i] = a.half[i] op b.half[i]; \
    return result;                                                             \
  }
HAPTICELL_MASK_OPERATOR(&)
HAPTICELL_MASK_OPERATOR(|)
HAPTICELL_MASK_OPERATOR(^)
#undef HAPTICELL_MASK_OPERATOR

inline Lanes operator-(const Lanes& a) {
  Lanes result;
  for (int i = 0; i < kHalves; ++i) result.half[i] = -a.half[i];
  return result;
}
inline Lanes& operator+=(Lanes& a, const Lanes& b) {
  return a = a + b;
}
inline Lanes& operator-=(Lanes& a, const Lanes& b) {
  return a = a - b;
}

inline Lanes select(const Mask& condition, const Lanes& yes, const Lanes& no) {
  Lanes result;
  for (int i = 0; i < kHalves; ++i) {
#if defined(__AVX2__)
    result.half[i] = condition.half[i] ? yes.half[i] : no.half[i];
#else
    result.half[i] = Half((condition.half[i] & HalfMask(yes.half[i])) | (~condition.half[i] & HalfMask(no.half[i])));
#endif
  }
  return result;
}

inline Lanes squareRoot(const Lanes& a) {
  Lanes result;
  for (int i = 0; i < kHalves; ++i) {
#if defined(__AVX2__)
    result.half[i] = _mm256_sqrt_pd(a.half[i]);
#elif defined(__SSE2__)
    result.half[i] = _mm_sqrt_pd(a.half[i]);
#else
    for (int k = 0; k < kHalfWidth; ++k) result.half[i][k] = __builtin_sqrt(a.half[i][k]);
#endif
  }
  return result;
}

inline Lanes minimum(const Lanes& a, const Lanes& b) {
  return select(a < b, a, b);
}
inline Lanes maximum(const Lanes& a, const Lanes& b) {
  return select(a > b, a, b);
}

/// Bit operations on the numbers' representation.
inline HalfMask signBits() {
  return HalfMask(-(Half{} + 0.0));
}
inline Lanes absolute(const Lanes& a) {
  Lanes result;
  for (int i = 0; i < kHalves; ++i) result.half[i] = Half(HalfMask(a.half[i]) & ~signBits());
  return result;
}
/// The magnitude of `a` (not negative) with the sign of `b`.
inline Lanes withSignOf(const Lanes& a, const Lanes& b) {
  Lanes result;
  for (int i = 0; i < kHalves; ++i) result.half[i] = Half(HalfMask(a.half[i]) | (HalfMask(b.half[i]) & signBits()));
  return result;
}

/// Bit k is set where lane k is true.
inline unsigned bitsOf(const Mask& mask) {
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_pd(__m256d(mask.half[0])));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(__m128d(mask.half[0])) | _mm_movemask_pd(__m128d(mask.half[1])) << 2);
#else
  unsigned bits = 0;
  for (int k = 0; k < 4; ++k) bits |= mask.half[k / kHalfWidth][k % kHalfWidth] != 0 ? 1u << k : 0u;
  return bits;
#endif
}

/// The nearest whole number, for |a| < 2^50.
inline Lanes nearestWhole(const Lanes& a) {
  constexpr double kMagic = 6755399441055744.0;  // 1.5 * 2^52: the sum has no room for a fraction
  return (a + kMagic) - Lanes(kMagic);
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
