// SPDX-License-Identifier: Apache-2.0
#include "cli/study/study_progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "cli/kit/command_listener.h"

namespace hapticell::cli {

std::string durationWords(double seconds) {
  char text[60];
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) {
    std::snprintf(text, sizeof text, "%ld s", whole);
  } else if (whole < 3600) {
    std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole / 60 % 60);
  }
  return text;
}

StudyProgress::StudyProgress() : terminal_(::isatty(STDERR_FILENO) != 0) {}

StudyProgress::~StudyProgress() {
  if (terminal_ && shown_) std::fputs("\r\033[K", stderr);
}

void StudyProgress::show(const studies::RunProgress& progress) {
  // ms: four times a second, as fast as numbers are read. Half: flicker; twice: it seems to stand.
  constexpr std::chrono::milliseconds kEvery{250};
  const auto now = std::chrono::steady_clock::now();
  const std::size_t tenths = progress.total > 0 ? 10 * progress.done / progress.total : 10;
  const bool by_time = terminal_ || listener_ != nullptr;
  if (by_time ? now - last_ < kEvery : tenths <= tenths_) return;
  last_ = now;
  const double share =
      progress.total > 0 ? static_cast<double>(progress.done) / static_cast<double>(progress.total) : 1.0;
  if (listener_ != nullptr) return listener_->hearProgress(share, "variants");
  tenths_ = tenths;
  const double rate = progress.seconds > 0.0 ? static_cast<double>(progress.done) / progress.seconds : 0.0;
  const double left = rate > 0.0 ? static_cast<double>(progress.total - progress.done) / rate : 0.0;
  std::fprintf(stderr, "%s%zu of %zu, %.3g a second, %s left%s", terminal_ ? "\r\033[K" : "", progress.done,
               progress.total, rate, durationWords(left).c_str(), terminal_ ? "" : "\n");
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace hapticell::cli
