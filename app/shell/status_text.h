// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

namespace hapticell::app {

class Host;
class StatusLine;

/// What the status line says of the scene: its state in one sentence, and the rates of the loops. GUI thread.
class StatusText {
 public:
  /// Both must outlive it.
  StatusText(Host& host, StatusLine& line) : host_(host), line_(line) {}
  StatusLine& line() { return line_; }
  const StatusLine& line() const { return line_; }
  /// Pictures of the window a second.
  void setGuiRate(double hertz) { gui_rate_ = hertz; }
  /// As the scene and the document are now.
  void show();
  /// Ten times a second at most; true where it did. `now`: whenever it was last.
  bool showNumbers(bool now);

 private:
  Host& host_;
  StatusLine& line_;
  double gui_rate_ = 0.0;
  QElapsedTimer since_numbers_;
};

}  // namespace hapticell::app
