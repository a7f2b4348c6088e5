// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/trajectory_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/controls/strip_chart.h"
#include "app/style/icon.h"
#include "app/style/narrow_words.h"
#include "app/style/theme.h"
#include "app/trajectory/docks/chart_limits.h"
#include "app/trajectory/docks/motion_chart.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/motions/motion_player.h"
#include "app/trajectory/motions/motion_work.h"

namespace hapticell::app {
namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr int kNormalSpeed = 3;
constexpr int kLiveMilliseconds = 33;
constexpr double kLiveSeconds = 120.0;  // Kept of force and gap while recording.

}  // namespace

TrajectoryPanel::TrajectoryPanel(Host& host, MotionList& list, MotionPlayer& player, QWidget* parent)
    : QWidget(parent),
      host_(host),
      list_(list),
      player_(player),
      bar_(new TimeBar),
      chart_(new MotionChart),
      live_(new StripChart(kLiveSeconds)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 6);
  column->setSpacing(4);
  column->addWidget(makeTransport());
  column->addWidget(bar_);
  column->addWidget(chart_, 1);
  column->addWidget(live_, 1);
  live_->setObjectName("recordedStrip");
  live_->setLevels(host_.configuration().manipulation.near_miss, 0.0);
  live_->hide();
  connect(&live_timer_, &QTimer::timeout, this, [this] { live_->take(host_.snapshot()); });
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

QToolButton* TrajectoryPanel::button(const char* name, const QString& picture, const QString& tip,
                                     const QString& word) {
  auto* made = new QToolButton;
  made->setObjectName(name);
  made->setIcon(icon(picture));
  made->setIconSize(QSize(18, 18));
  made->setToolTip(tip);
  made->setAccessibleName(tip);
  made->setAutoRaise(true);
  made->setFixedHeight(28);
  if (!word.isEmpty()) {
    made->setText(word);
    made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  return made;
}

QWidget* TrajectoryPanel::makeTransport() {
  auto* holder = new QWidget;
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(10, 0, 10, 0);
  row->setSpacing(4);
  first_ = button("buttonFirst", "first", tr("To the beginning"));
  back_ = button("buttonStepBack", "step_back", tr("One frame back (Left, in the time bar)"));
  play_ = button("buttonPlay", "play", tr("Play"));
  next_ = button("buttonStepNext", "step_next", tr("One frame on (Right, in the time bar)"));
  last_ = button("buttonLast", "last", tr("To the end"));
  loop_ = button("buttonLoop", "loop", tr("Again and again"));
  shown_ = button("buttonShown", "eye", tr("Show the motion in the scene; off: the cell as it stands"));
  swept_ = button("buttonSwept", "apps", tr("Show the room that the motion needs: all its places at once"));
  for (QToolButton* checkable : {loop_, shown_, swept_}) checkable->setCheckable(true);
  speed_ = new QComboBox;
  speed_->setObjectName("comboSpeed");
  speed_->setAccessibleName(tr("Speed of the play"));
  for (const double speed : kSpeeds) speed_->addItem(tr("%1 ×").arg(speed, 0, 'g', 3), speed);
  speed_->setCurrentIndex(kNormalSpeed);
  record_ = button("buttonRecord", "record", tr("Record what moves  (R)"), tr("Record"));
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
  group_->addItems({tr("Path"), tr("x, y, z"), tr("Turn"), tr("Joints")});
  order_ = new QComboBox;
  order_->setObjectName("comboCurveOrder");
  order_->setAccessibleName(tr("Quantity of the curves"));
  order_->addItems({tr("Position"), tr("Speed"), tr("Accel."), tr("Jerk"), tr("All four")});
  order_->setCurrentIndex(1);
  trim_ = button("buttonTrim", "trim", tr("Keep the part between the brackets as a new motion"), tr("Trim"));
  smooth_ = button("buttonSmooth", "smooth", tr("Take the hand's tremor, keep the path"), tr("Smooth…"));
  check_ = button("buttonCheck", "check", tr("Limits and collisions along the whole motion"), tr("Check"));
  export_ = button("buttonExportMotion", "export", tr("Write it as a file or a robot's program"), tr("Export…"));
  edit_ = button("buttonEditMotion", "trajectory", tr("All that can be done with a motion"), tr("Edit…"));
  for (QWidget* widget :
       std::initializer_list<QWidget*>{first_, back_, play_, next_, last_, loop_, shown_, swept_, speed_, record_})
    row->addWidget(widget);
  row->addSpacing(6);
  row->addWidget(info_, 1);
  for (QWidget* widget : std::initializer_list<QWidget*>{trim_, smooth_, check_, export_, edit_})
    row->addWidget(widget);
  connect(first_, &QToolButton::clicked, this, [this] { player_.seek(player_.playback().begin()); });
  connect(last_, &QToolButton::clicked, this, [this] { player_.seek(player_.playback().end()); });
  connect(back_, &QToolButton::clicked, this, [this] { player_.step(-1); });
  connect(next_, &QToolButton::clicked, this, [this] { player_.step(1); });
  connect(play_, &QToolButton::clicked, this,
          [this] { player_.playback().isPlaying() ? player_.pause() : player_.play(); });
  connect(loop_, &QToolButton::toggled, this, [this](bool on) { player_.setLoop(on); });
  connect(shown_, &QToolButton::clicked, this, [this](bool on) { player_.setShown(on); });
  connect(swept_, &QToolButton::clicked, this, [this](bool on) { player_.setSwept(on); });
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this](int index) { player_.setSpeed(speed_->itemData(index).toDouble()); });
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
    layLiveChart();
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
  const bool playable = player_.playback().end() > player_.playback().begin();
  for (QWidget* widget : std::initializer_list<QWidget*>{first_, back_, play_, next_, last_})
    widget->setEnabled(playable);
}

/// Curves are laid anew for another motion only: a long one takes a while.
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
  play_->setIcon(icon(playback.isPlaying() ? "pause" : "play"));
  play_->setToolTip(playback.isPlaying() ? tr("Pause") : tr("Play"));
  play_->setAccessibleName(play_->toolTip());
  if (player_.isSlow() && !slow_told_)
    showLine(tr("Plays slower than recorded: fewer than 10 pictures a second can be drawn"), true);
  slow_told_ = player_.isSlow() || (slow_told_ && playback.isPlaying());
  shown_->setChecked(player_.isShown());
  swept_->setChecked(player_.isSwept());
  const bool playable = playback.end() > playback.begin();
  for (QWidget* widget : std::initializer_list<QWidget*>{first_, back_, play_, next_, last_})
    widget->setEnabled(playable);
}

void TrajectoryPanel::showRecording(const std::optional<Recording>& recording) {
  const bool on = recording.has_value();
  if (on != recording_) {
    recording_ = on;
    record_->setText(on ? tr("Stop recording") : tr("Record"));
    record_->setToolTip(on ? tr("End the recording  (R)") : tr("Record what moves  (R)"));
    record_->setProperty("recording", on);
    if (!on) info_->clear();
  }
  bar_->setRecorded(on ? std::optional<double>(recording->seconds) : std::nullopt);
  const auto& now = host_.snapshot();
  const bool live = on && now && now->connected;
  if (live) {
    live_->take(now);
    recorded_from_s_ = live_->history().now() - recording->seconds;
    layLiveChart();
  }
  if (live != live_timer_.isActive()) live ? live_timer_.start(kLiveMilliseconds) : live_timer_.stop();
  live_->setVisible(live);
  chart_->setVisible(!live);
  if (!on) return;
  info_->setText(tr("%1 s · frames: %2").arg(recording->seconds, 0, 'f', 1).arg(recording->frames) +
                 (recording->by_hand > 0 ? tr(" · %1 by hand").arg(recording->by_hand) : QString()));
}

void TrajectoryPanel::layLiveChart() {
  const TimeAxis& axis = bar_->axis();
  live_->setTimes({axis.left, axis.right, recorded_from_s_ + axis.begin, recorded_from_s_ + axis.end});
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
