// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QStatusBar>
#include <QTimer>

#include "app/host/message_log.h"
#include "app/style/steady_number.h"
#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {

/// The bottom line: the state in one sentence, three loop rates, device, units. A new message is shown for 8 seconds.
class StatusLine : public QStatusBar {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);
  /// The rates, shown relative to 1000 Hz and to the default limits.
  struct Rates {
    double haptic_hz = 0.0, collision_hz = 0.0, window_hz = 0.0;
    double haptic_full = 1000.0, collision_full = 1000.0, window_full = 60.0;
    bool idle = false;  ///< Nothing is to be done: collision and window are shown as idle.
  };
  void setSentence(Mark mark, const QString& sentence);
  /// Updates the display if the rates differ visibly, at most twice a second; at once if a loop starts, ends or becomes
  /// idle.
  void setRates(const Rates& rates);
  void setDevice(const QString& text, bool works);
  const QString& device() const { return device_; }
  bool deviceWorks() const { return device_works_; }
  const Rates& rates() const { return rates_; }
  void setSound(const QString& text, bool on);
  /// The message in one line, cut to its room, for a few seconds; whole in the tooltip. A click emits messageClicked().
  void show(const Message& message);
  QString sentence() const { return sentence_; }
  QSize sizeHint() const override { return {400, 26}; }

 signals:
  void messageClicked();

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void clearMessage();
  void paintSentence(QPainter& painter, const QRect& rect) const;
  int paintRate(QPainter& painter, int right, const QString& name, double value, double full, bool idle = false) const;
  Mark mark_ = Mark::kNone;
  QString sentence_, device_, message_, sound_;
  bool sound_on_ = false, device_works_ = true;
  Severity severity_ = Severity::kInformation;
  /// A rate is updated if it differs by this fraction: 1000 Hz vary by a few. Half: numbers flicker; twice: a drop of
  /// 10 % is not shown.
  static constexpr double kShare = 0.05;
  Rates rates_;
  QElapsedTimer rates_shown_;
  SteadyNumber haptic_{kShare}, collision_{kShare}, window_{kShare};
  QTimer message_timer_;
};

}  // namespace hapticell::app
