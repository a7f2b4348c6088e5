// SPDX-License-Identifier: Apache-2.0
#include "python/engine/long_work.h"

#include <chrono>
#include <exception>
#include <future>
#include <optional>

#include "python/engine/conversion.h"

namespace hapticell::python {

void runLong(const std::function<void()>& work, const std::function<void()>& stop, const std::function<void()>& watch) {
  // ms: Ctrl+C seems immediate. Half: nobody notices; twice: a progress bar stutters.
  constexpr std::chrono::milliseconds kEvery{50};
  std::exception_ptr raised;
  std::optional<py::gil_scoped_release> unlocked(std::in_place);
  std::future<void> done = std::async(std::launch::async, work);
  while (done.wait_for(kEvery) != std::future_status::ready) {
    if (raised) continue;
    const py::gil_scoped_acquire locked;
    try {
      checkSignals();
      if (watch) watch();
    } catch (...) {
      raised = std::current_exception();
      stop();
    }
  }
  unlocked.reset();
  if (raised) {
    try {
      done.get();
    } catch (...) {  // It was asked to end; why it did so says nothing more.
    }
    std::rethrow_exception(raised);
  }
  done.get();
  if (watch) watch();
}

}  // namespace hapticell::python
