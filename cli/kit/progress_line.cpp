// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/progress_line.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "geometry/system/plain_text.h"
#include "geometry/system/text.h"

namespace hapticell::cli {

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) != 0), thread_([this] { run(); }) {}

ProgressLine::~ProgressLine() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  thread_.join();
  if (terminal_ && shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::run() {
  // ms: four times a second, as fast as numbers are read. Half: flicker; twice: it seems to stand.
  constexpr std::chrono::milliseconds kEvery{250};
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kEvery, [this] { return stopping_; })) show();
}

void ProgressLine::show() {
  if (listener_ != nullptr && listener_->stopAsked()) monitor_.cancel();
  const workcell::ImportProgress progress = monitor_.progress();
  if (progress.stage.empty()) return;
  if (listener_ != nullptr) return listener_->hearProgress(progress.share, english(progress.stage));
  const int percent = static_cast<int>(100.0 * progress.share);
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K%3d %%  %s", percent, plainText(english(progress.stage), 60).c_str());
    std::fflush(stderr);
  } else if (percent / 10 > tenths_) {
    tenths_ = percent / 10;
    std::fprintf(stderr, "%3d %%  %s\n", percent, plainText(english(progress.stage)).c_str());
  }
  shown_ = true;
}

}  // namespace hapticell::cli
