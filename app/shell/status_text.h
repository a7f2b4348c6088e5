// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

namespace hapticell::app {

class Host;
class StatusLine;

/// What the status line shows: the state of the scene in one sentence, and the rates of the loops. GUI thread.
class StatusText {
 public:
  /// Both must outlive it.
  StatusText(Host& host, StatusLine& line) : host_(host), line_(line) {}
  StatusLine& line() { return line_; }
  const StatusLine& line() const { return line_; }
  /// Frames of the window per second.
  void setGuiRate(double hertz) { gui_rate_ = hertz; }
  /// Shows the present state of the scene and the document.
  void show();
  /// Shows the numbers, at most ten times a second; returns whether it did. `now`: in any case.
  bool showNumbers(bool now);

 private:
  Host& host_;
  StatusLine& line_;
  double gui_rate_ = 0.0;
  QElapsedTimer since_numbers_;
};

}  // namespace hapticell::app
