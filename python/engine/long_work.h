// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace hapticell::python {

/// Does `work` in a thread of its own while this thread waits without the interpreter's lock, so that Python's other
/// threads go on. Twenty times a second it looks for signals and calls `watch` (may be empty) with the lock. After
/// Ctrl+C or if `watch` raises, `stop` is called, the end of the work is awaited and the exception is raised. What
/// `work` throws is thrown here. Needs the interpreter's lock; `work` runs without it.
void runLong(const std::function<void()>& work, const std::function<void()>& stop,
             const std::function<void()>& watch = {});

}  // namespace hapticell::python
