// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/play_controls.h"

#include <QComboBox>
#include <QToolButton>

#include "app/style/icon.h"
#include "app/trajectory/motions/motion_player.h"

namespace hapticell::app {
namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr int kNormalSpeed = 3;

}  // namespace

QToolButton* transportButton(const char* name, const QString& picture, const QString& tip, const QString& word) {
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

PlayControls::PlayControls(MotionPlayer& player, QObject* parent) : QObject(parent), player_(player) {
  first_ = transportButton("buttonFirst", "first", tr("Go to start"));
  back_ = transportButton("buttonStepBack", "step_back", tr("Previous frame (Left, in the time bar)"));
  play_ = transportButton("buttonPlay", "play", tr("Play"));
  next_ = transportButton("buttonStepNext", "step_next", tr("Next frame (Right, in the time bar)"));
  last_ = transportButton("buttonLast", "last", tr("Go to end"));
  loop_ = transportButton("buttonLoop", "loop", tr("Loop"));
  shown_ = transportButton("buttonShown", "eye", tr("Show the motion in the scene; off: show the cell"));
  swept_ = transportButton("buttonSwept", "apps", tr("Show the swept volume of the motion"));
  for (QToolButton* checkable : {loop_, shown_, swept_}) checkable->setCheckable(true);
  speed_ = new QComboBox;
  speed_->setObjectName("comboSpeed");
  speed_->setAccessibleName(tr("Playback speed"));
  for (const double speed : kSpeeds) speed_->addItem(tr("%1 ×").arg(speed, 0, 'g', 3), speed);
  speed_->setCurrentIndex(kNormalSpeed);
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
}

std::vector<QWidget*> PlayControls::widgets() const {
  return {first_, back_, play_, next_, last_, loop_, shown_, swept_, speed_};
}

void PlayControls::show() {
  const auto& playback = player_.playback();
  play_->setIcon(icon(playback.isPlaying() ? "pause" : "play"));
  play_->setToolTip(playback.isPlaying() ? tr("Pause") : tr("Play"));
  play_->setAccessibleName(play_->toolTip());
  shown_->setChecked(player_.isShown());
  swept_->setChecked(player_.isSwept());
  const bool playable = playback.end() > playback.begin();
  for (QWidget* widget : std::initializer_list<QWidget*>{first_, back_, play_, next_, last_})
    widget->setEnabled(playable);
}

}  // namespace hapticell::app
