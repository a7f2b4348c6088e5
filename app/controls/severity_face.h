// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

#include "app/host/message_log.h"
#include "app/style/theme.h"

namespace hapticell::app {

/// The icon of a message.
constexpr const char* severityIcon(Severity severity) {
  if (severity == Severity::kProblem) return "crossed";
  return severity == Severity::kWarning ? "warning" : "info";
}

/// The colour of that icon.
inline QColor severityColor(Severity severity, const Theme& theme) {
  if (severity == Severity::kProblem) return theme.contact;
  return severity == Severity::kWarning ? theme.near_miss : theme.selection;
}

}  // namespace hapticell::app
