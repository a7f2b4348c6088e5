// SPDX-License-Identifier: Apache-2.0
#pragma once

/// 1 if compiled with the address or the thread sanitizer (g++ or clang), else 0. These sanitizers reserve terabytes of
/// address space, so memory limits can be neither set nor tested with them.
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
