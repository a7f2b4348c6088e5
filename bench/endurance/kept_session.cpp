// SPDX-License-Identifier: Apache-2.0
#include "bench/endurance/kept_session.h"

#include <cstdarg>
#include <cstdio>
#include <string>

#include "workcell/format/document_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::endurance {

namespace {

/// As printf() has it.
__attribute__((format(printf, 1, 2))) std::string text(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  char buffer[512];
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

std::string handText(const haptic::HandPath& hand) {
  std::string csv = "t,x,y,z,qw,qx,qy,qz,button\n";
  for (const haptic::HandSample& sample : hand.samples()) {
    const auto& [p, q] = sample.X_DH;
    csv += text("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%u\n", sample.t, p.x, p.y, p.z, q.w, q.x, q.y, q.z,
                sample.buttons);
  }
  return csv;
}

std::string commandText(const manipulation::SessionOptions& options) {
  constexpr const char* kClasses[] = {"constant", "contact", "dynamics"};
  std::string command = text(
      "hapticell-cli session --workcell cell.hcell --hand hand.csv --entity '%s' --device touch --rate-gui %g "
      "--rate-manipulation %g --latency %.17g --set scale=%.17g",
      options.entity.c_str(), options.rate_gui_hz, options.configuration.manipulation.rate_hz, 1e3 * options.latency_s,
      options.scale.number);
  if (!std::holds_alternative<manipulation::by::Default>(options.moved_by))
    command += text(" --set moved_by=%s", manipulation::wordOf(options.moved_by, false).c_str());
  const bool stops = options.on_contact == workcell::OnContact::kStop;
  command += text(" --set on_contact=%s", stops ? "stop" : "slide");
  if (options.force_class)
    command += text(" --set force_class=%s", kClasses[static_cast<std::size_t>(*options.force_class)]);
  return command + "\n";
}

}  // namespace

Expected<void> keepSession(const workcell::Document& document, const manipulation::SessionOptions& options,
                           const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  workcell::Document copy(document.state());
  if (const auto saved = workcell::saveDocument(copy, folder / "cell.hcell"); !saved) return saved;
  const std::string hand = (folder / "hand.csv").string(), command = (folder / "session.txt").string();
  if (const auto written = workcell::writeFileAtomically(hand, handText(options.hand)); !written) return written;
  return workcell::writeFileAtomically(command, commandText(options));
}

}  // namespace hapticell::endurance
