// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/result_writer.h"

#include <cmath>
#include <cstdio>
#include <iostream>

#include "cli/kit/command_listener.h"
#include "geometry/system/plain_number.h"
#include "geometry/system/plain_text.h"

namespace hapticell::cli {

Expected<void> ResultWriter::write(const nlohmann::ordered_json& result) const {
  return put(result, 2);
}

Expected<void> ResultWriter::writeLine(const nlohmann::ordered_json& result) const {
  return put(result, -1);
}

Expected<void> ResultWriter::put(const nlohmann::ordered_json& result, int indent) const {
  if (!toFile()) {
    if (CommandListener* const listener = commandListener()) {
      listener->hearResult(result);
      return {};
    }
  }
  // Text that is not UTF-8 (a file name, say) must not stop the result from being written.
  const std::string text = result.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (toFile()) return writeFileAtomically(json_file_, text);
  return printText(text);
}

nlohmann::ordered_json toJson(const dvec3& v) {
  return nlohmann::ordered_json::array({v.x, v.y, v.z});
}

nlohmann::ordered_json finiteOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

std::string shortNumber(double value) {
  constexpr int kDigits = 6;
  return plainNumber(value, std::chars_format::general, kDigits);
}

Expected<void> printText(const std::string& text) {
  if (CommandListener* const listener = commandListener()) {
    listener->hearText(text);
    return {};
  }
  std::cout << text << std::flush;
  if (std::cout) return {};
  return makeError({.file = "standard output",
                    .found = "it could not be written",
                    .fix = "Check the disk or the receiving program."});
}

void report(const Error& error) {
  if (CommandListener* const listener = commandListener()) return listener->hearError(error);
  std::fprintf(stderr, "hapticell-cli: %s\n", error.message().c_str());
}

void warn(const Text& sentence) {
  if (CommandListener* const listener = commandListener()) return listener->hearWarning(sentence);
  std::fprintf(stderr, "hapticell-cli: %s\n", plainText(english(sentence), 4096).c_str());
}

}  // namespace hapticell::cli
