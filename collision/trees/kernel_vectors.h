// SPDX-License-Identifier: Apache-2.0
// Part of proximity_kernels_body.h, see there: vectors of several numbers.
#pragma once

#include <cstdint>

namespace hapticell::collision {
namespace {

#define HAPTICELL_INLINE inline __attribute__((always_inline))

using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Float16 = float __attribute__((vector_size(64)));
using Double2 = double __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));

template <typename V>
struct Scalar {
  using Type = float;
};
template <>
struct Scalar<Double2> {
  using Type = double;
};
template <>
struct Scalar<Double4> {
  using Type = double;
};
template <>
struct Scalar<Double8> {
  using Type = double;
};

template <typename V>
HAPTICELL_INLINE V all(typename Scalar<V>::Type value) {
  return V{} + value;
}
template <typename V, typename T>
HAPTICELL_INLINE V load(const T* from) {
  V result;
  __builtin_memcpy(&result, from, sizeof(V));
  return result;
}
template <typename V, typename T>
HAPTICELL_INLINE void store(T* to, V value) {
  __builtin_memcpy(to, &value, sizeof(V));
}
template <typename V>
HAPTICELL_INLINE V larger(V a, V b) {
  return a > b ? a : b;
}
template <typename V>
HAPTICELL_INLINE V smaller(V a, V b) {
  return a < b ? a : b;
}
template <typename V>
HAPTICELL_INLINE V squareRoot(V a) {
  V root;
  for (unsigned i = 0; i < sizeof(V) / sizeof(a[0]); ++i) root[i] = __builtin_sqrtf(a[i]);
  return root;
}
#ifdef __AVX__
HAPTICELL_INLINE Float8 squareRoot(Float8 a) {
  return __builtin_ia32_sqrtps256(a);
}
// Compilers make two instructions or more of these where the processor has one.
HAPTICELL_INLINE Float4 larger(Float4 a, Float4 b) {
  return __builtin_ia32_maxps(a, b);
}
HAPTICELL_INLINE Float4 smaller(Float4 a, Float4 b) {
  return __builtin_ia32_minps(a, b);
}
HAPTICELL_INLINE Float8 larger(Float8 a, Float8 b) {
  return __builtin_ia32_maxps256(a, b);
}
HAPTICELL_INLINE Float8 smaller(Float8 a, Float8 b) {
  return __builtin_ia32_minps256(a, b);
}
HAPTICELL_INLINE Double4 larger(Double4 a, Double4 b) {
  return __builtin_ia32_maxpd256(a, b);
}
HAPTICELL_INLINE Double4 smaller(Double4 a, Double4 b) {
  return __builtin_ia32_minpd256(a, b);
}
#endif
template <typename V>
HAPTICELL_INLINE V magnitude(V a) {
  using Bits = decltype(a < a);
  return V(Bits(a) & ~Bits(-V{}));  // All but the sign.
}
template <typename V>
HAPTICELL_INLINE V clampedToUnit(V a) {
  return smaller(larger(a, V{}), all<V>(1));
}

template <typename V>
struct Vector {
  V x, y, z;
};
template <typename V>
HAPTICELL_INLINE Vector<V> operator-(const Vector<V>& a, const Vector<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename V>
HAPTICELL_INLINE Vector<V> operator+(const Vector<V>& a, const Vector<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename V>
HAPTICELL_INLINE Vector<V> operator*(V s, const Vector<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <typename V>
HAPTICELL_INLINE V dot(const Vector<V>& a, const Vector<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename V>
HAPTICELL_INLINE Vector<V> cross(const Vector<V>& a, const Vector<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename V, typename T>
HAPTICELL_INLINE Vector<V> loadVector(const T* x, int stride) {
  return {load<V>(x), load<V>(x + stride), load<V>(x + 2 * stride)};
}

HAPTICELL_INLINE float absolute(float x) {
  return x < 0.0f ? -x : x;
}

template <typename V>
HAPTICELL_INLINE V sumOfMagnitudes(const Vector<V>& a) {
  return magnitude(a.x) + magnitude(a.y) + magnitude(a.z);
}

}  // namespace
}  // namespace hapticell::collision
