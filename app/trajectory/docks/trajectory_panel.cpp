// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/trajectory_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/narrow_words.h"
#include "app/style/theme.h"
#include "app/trajectory/docks/chart_limits.h"
#include "app/trajectory/docks/motion_chart.h"
#include "app/trajectory/docks/play_controls.h"
#include "app/trajectory/docks/recorded_strip.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/motions/motion_player.h"
#include "app/trajectory/motions/motion_work.h"

namespace hapticell::app {

TrajectoryPanel::TrajectoryPanel(Host& host, MotionList& list, MotionPlayer& player, QWidget* parent)
    : QWidget(parent),
      list_(list),
      player_(player),
      bar_(new TimeBar),
      chart_(new MotionChart),
      live_(new RecordedStrip(host, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 6);
  column->setSpacing(4);
  column->addWidget(makeTransport());
  column->addWidget(bar_);
  column->addWidget(chart_, 1);
  column->addWidget(live_->chart(), 1);
  // The choice of the curves stands in the chart's own column of names.
  auto* choice = new QGridLayout(chart_);
  choice->setContentsMargins(10, 4, 0, 0);
  choice->setSpacing(4);
  for (QComboBox* combo : {group_, order_}) combo->setFixedWidth(88);
  choice->addWidget(group_, 0, 0);
  choice->addWidget(order_, 0, 1);
  choice->setColumnStretch(2, 1);
  choice->setRowStretch(1, 1);
  connectBar();
  connect(&list_, &MotionList::changed, this, &TrajectoryPanel::showMotions);
  connect(&list_, &MotionList::currentChanged, this, [this] {
    showMotions();
    showCurrent();
  });
  connect(&player_, &MotionPlayer::changed, this, &TrajectoryPanel::showTime);
  chooseCurves();
  showMotions();
  showCurrent();
  showTime();
}

QWidget* TrajectoryPanel::makeTransport() {
  auto* holder = new QWidget;
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(10, 0, 10, 0);
  row->setSpacing(4);
  play_ = new PlayControls(player_, this);
  record_ = transportButton("buttonRecord", "record", tr("Record what moves  (R)"), tr("Record"));
  record_->setAutoRaise(false);
  record_->setText(tr("Stop recording"));  // It is as wide as it will be: its neighbours stay.
  record_->setMinimumWidth(record_->sizeHint().width());
  record_->setText(tr("Record"));
  info_ = makeLabel({}, TextRole::kSecond, true);
  info_->setObjectName("labelMotionLine");
  info_->setMinimumWidth(60);
  group_ = new QComboBox;
  group_->setObjectName("comboCurveGroup");
  group_->setAccessibleName(tr("Curves of"));
  group_->addItems({tr("Path"), tr("x, y, z"), tr("Rotation"), tr("Joints")});
  order_ = new QComboBox;
  order_->setObjectName("comboCurveOrder");
  order_->setAccessibleName(tr("Quantity of the curves"));
  order_->addItems({tr("Position"), tr("Speed"), tr("Accel."), tr("Jerk"), tr("All four")});
  order_->setCurrentIndex(1);
  trim_ = transportButton("buttonTrim", "trim", tr("Keep the range between the brackets as a new motion"), tr("Trim"));
  smooth_ = transportButton("buttonSmooth", "smooth", tr("Remove hand tremor, keep the path"), tr("Smooth…"));
  check_ = transportButton("buttonCheck", "check", tr("Limits and collisions along the whole motion"), tr("Check"));
  export_ = transportButton("buttonExportMotion", "export", tr("Save it as a file or a robot program"), tr("Export…"));
  edit_ = transportButton("buttonEditMotion", "trajectory", tr("All edits of a motion"), tr("Edit…"));
  for (QWidget* widget : play_->widgets()) row->addWidget(widget);
  row->addWidget(record_);
  row->addSpacing(6);
  row->addWidget(info_, 1);
  for (QWidget* widget : std::initializer_list<QWidget*>{trim_, smooth_, check_, export_, edit_})
    row->addWidget(widget);
  connect(record_, &QToolButton::clicked, this, &TrajectoryPanel::recordWanted);
  connect(trim_, &QToolButton::clicked, this, &TrajectoryPanel::trimWanted);
  connect(smooth_, &QToolButton::clicked, this, &TrajectoryPanel::smoothWanted);
  connect(check_, &QToolButton::clicked, this, &TrajectoryPanel::checkWanted);
  connect(export_, &QToolButton::clicked, this, &TrajectoryPanel::exportWanted);
  connect(edit_, &QToolButton::clicked, this, &TrajectoryPanel::editWanted);
  for (QComboBox* combo : {group_, order_})
    connect(combo, &QComboBox::currentIndexChanged, this, &TrajectoryPanel::chooseCurves);
  new NarrowWords(*holder, {{record_}, {trim_, smooth_, check_, export_, edit_}});
  return holder;
}

void TrajectoryPanel::connectBar() {
  connect(bar_, &TimeBar::scrubbed, this, [this](double t) { player_.seek(t); });
  connect(chart_, &MotionChart::scrubbed, this, [this](double t) { player_.seek(t); });
  connect(bar_, &TimeBar::stepped, this, [this](int direction) { player_.step(direction); });
  connect(bar_, &TimeBar::rowChosen, this, [this](const QString& name) {
    list_.setCurrent(name.toStdString());
    list_.setPlayed(name.toStdString(), true);
  });
  connect(bar_, &TimeBar::playedToggled, this,
          [this](const QString& name, bool played) { list_.setPlayed(name.toStdString(), played); });
  connect(bar_, &TimeBar::axisChanged, this, [this] {
    chart_->setAxis(bar_->axis());
    live_->lay(bar_->axis());
  });
  connect(bar_, &TimeBar::frameChosen, this, &TrajectoryPanel::frameChosen);
  connect(bar_, &TimeBar::partChanged, this, &TrajectoryPanel::showMotions);
}

void TrajectoryPanel::chooseCurves() {
  chart_->setChoice(static_cast<MotionChart::Group>(group_->currentIndex()),
                    static_cast<MotionChart::Order>(order_->currentIndex()));
  if (chart_->order() == MotionChart::Order::kAll) emit roomWanted();
}

void TrajectoryPanel::showMotions() {
  const auto most = static_cast<std::size_t>(std::max(40, bar_->width() / 8));
  bar_->setRows(trackRows(list_, most));
  chart_->setAxis(bar_->axis());
  const bool any = list_.current() && list_.current()->trajectory;
  for (QWidget* widget : std::initializer_list<QWidget*>{smooth_, check_, export_, trim_}) widget->setEnabled(any);
  play_->show();
}

/// Curves are made again for another motion only: a long one takes a while.
void TrajectoryPanel::showCurrent() {
  const Motion* motion = list_.current();
  const auto trajectory = motion ? motion->trajectory : nullptr;
  if (trajectory == shown_motion_) return;
  shown_motion_ = trajectory;
  bar_->setFrame({});
  bar_->setPart({});
  if (!trajectory || trajectory->size() < 2) {
    chart_->setCurves(nullptr);
    return;
  }
  chart_->setCurves(std::make_shared<const trajectory::MotionCurves>(trajectory::motionCurves(*trajectory)));
  chart_->setLimits(motion->entity ? chartLimits(*motion->entity, *trajectory) : std::vector<MotionChart::Limit>{});
  if (!motion->replay) showLine(motion->problem, true);
}

void TrajectoryPanel::showTime() {
  const auto& playback = player_.playback();
  bar_->setTime(playback.time());
  chart_->setTime(playback.time());
  play_->show();
  if (player_.isSlow() && !slow_told_) showLine(tr("Plays slower than recorded: the view is below 10 Hz"), true);
  slow_told_ = player_.isSlow() || (slow_told_ && playback.isPlaying());
}

void TrajectoryPanel::showRecording(const std::optional<Recording>& recording) {
  const bool on = recording.has_value();
  if (on != recording_) {
    recording_ = on;
    record_->setText(on ? tr("Stop recording") : tr("Record"));
    record_->setToolTip(on ? tr("Stop recording  (R)") : tr("Record what moves  (R)"));
    record_->setProperty("recording", on);
    if (!on) info_->clear();
  }
  bar_->setRecorded(on ? std::optional<double>(recording->seconds) : std::nullopt);
  const bool live = live_->show(on ? std::optional<double>(recording->seconds) : std::nullopt, bar_->axis());
  chart_->setVisible(!live);
  if (!on) return;
  info_->setText(tr("%1 s · frames: %2").arg(recording->seconds, 0, 'f', 1).arg(recording->frames) +
                 (recording->by_hand > 0 ? tr(" · %1 by hand").arg(recording->by_hand) : QString()));
}

void TrajectoryPanel::showLine(const QString& line, bool careful) {
  info_->setText(line);
  info_->setToolTip(line);
  info_->setForegroundRole(careful ? QPalette::WindowText : kQuietText);
  info_->setPalette({});
}

void TrajectoryPanel::markMissed() {
  QPalette red = info_->palette();
  red.setColor(QPalette::WindowText, themeOf(palette()).contact);
  info_->setPalette(red);
}

void TrajectoryPanel::setFrame(std::optional<std::size_t> frame) {
  bar_->setFrame(frame);
}

}  // namespace hapticell::app
