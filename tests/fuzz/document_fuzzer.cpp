// SPDX-License-Identifier: Apache-2.0
// Any text as a workcell document: refused in words, or accepted, written and read again to the same bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "workcell/format/document_io.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  Diagnostics notes;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto document = workcell::parseDocument(text, "/nowhere", "fuzzed", notes);
  if (!document) return 0;
  const std::string written = workcell::documentText(document->state(), "/nowhere");
  const auto again = workcell::parseDocument(written, "/nowhere", "fuzzed", notes);
  if (!again || workcell::documentText(again->state(), "/nowhere") != written) std::abort();
  return 0;
}
