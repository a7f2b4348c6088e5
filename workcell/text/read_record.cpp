// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/read_record.h"

namespace hapticell::workcell {

namespace {

thread_local ReadRecord* innermost = nullptr;

}  // namespace

ReadRecord::ReadRecord() : outer_(innermost) {
  innermost = this;
}

ReadRecord::~ReadRecord() {
  innermost = outer_;
}

void ReadRecord::note(const std::filesystem::path& file) {
  if (innermost == nullptr) return;
  std::error_code fault;
  const auto whole = std::filesystem::absolute(file, fault).lexically_normal();
  if (!fault) innermost->files_.insert(whole);
}

}  // namespace hapticell::workcell
