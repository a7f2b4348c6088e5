// SPDX-License-Identifier: Apache-2.0
#include "importer/parent_link.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "geometry/system/packed_text.h"
#include "workcell/scenes/import_process.h"

namespace hapticell::importer {

namespace {

bool writeAll(int file, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t written = ::write(file, bytes.data() + at, bytes.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

void ParentLink::line(const std::string& text) {
  writeAll(workcell::kLinesDescriptor, text + "\n");
}

void ParentLink::progress(double share, const Text& stage) {
  // Of the progress: a pixel of the bar. Half: twice the lines; twice: steps are seen.
  constexpr double kStep = 0.01;
  share = from_ + share * (to_ - from_);
  if (share < told_ + kStep && stage == stage_) return;
  told_ = share;
  stage_ = stage;
  char text[40];
  std::snprintf(text, sizeof text, "progress %.3f ", share);
  line(text + packed(stage));
}

void ParentLink::setRange(double from, double to) {
  from_ = from;
  to_ = to;
}

void ParentLink::beginPart(int number) {
  line("part " + std::to_string(number));
}

std::string ParentLink::flatParts(const Error& error) {
  return packed(error);
}

void ParentLink::error(const Error& error) {
  line("error " + flatParts(error));
}

void ParentLink::done() {
  line("done");
}

std::string ParentLink::readScene() {
  struct stat state {};
  if (::fstat(workcell::kSceneDescriptor, &state) != 0 || state.st_size <= 0) return {};
  std::string bytes(static_cast<std::size_t>(state.st_size), '\0');
  const ssize_t got = ::pread(workcell::kSceneDescriptor, bytes.data(), bytes.size(), 0);
  if (got < 0) return {};
  bytes.resize(static_cast<std::size_t>(got));
  return bytes;
}

bool ParentLink::writeScene(const std::string& bytes) {
  return ::ftruncate(workcell::kSceneDescriptor, 0) == 0 && ::lseek(workcell::kSceneDescriptor, 0, SEEK_SET) == 0 &&
         writeAll(workcell::kSceneDescriptor, bytes);
}

}  // namespace hapticell::importer
