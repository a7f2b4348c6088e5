// SPDX-License-Identifier: Apache-2.0
#pragma once

/// 1 in what is compiled with the address or the thread sanitizer, by g++ or clang, else 0. They reserve terabytes of
/// addresses and take memory by themselves: limits of memory cannot be set or tried beneath them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAPTICELL_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAPTICELL_SANITIZED 1
#endif
#endif
#ifndef HAPTICELL_SANITIZED
#define HAPTICELL_SANITIZED 0
#endif
