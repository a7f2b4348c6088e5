// SPDX-License-Identifier: Apache-2.0
// What the buttons of the motion panel do, and what it shows.
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include "app/host/host.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "app/trajectory/docks/clean_fields.h"
#include "app/trajectory/docks/motion_facts.h"
#include "app/trajectory/docks/motion_panel.h"
#include "app/trajectory/docks/recording_fields.h"
#include "app/trajectory/docks/timing_fields.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/motions/motion_player.h"
#include "app/trajectory/motions/motion_work.h"
#include "app/trajectory/motions/track_rows.h"

namespace hapticell::app {
namespace {

using Made = Expected<std::vector<trajectory::Trajectory>>;

Made oneOf(Expected<trajectory::Trajectory> made) {
  HAPTICELL_TRY(made);
  return std::vector<trajectory::Trajectory>{std::move(*made)};
}

}  // namespace

manipulation::command::StartRecording MotionPanel::recordingWanted() const {
  return recording_->wanted();
}

double MotionPanel::reach() const {
  return reach_->value();
}

void MotionPanel::showLine(const QString& line, bool careful) {
  facts_->showLine(line, careful);
}

void MotionPanel::markMissed() {
  facts_->markMissed();
}

void MotionPanel::setFrame(std::optional<std::size_t> frame) {
  if (frame == frame_) return;
  frame_ = frame;
  showFrame();
  emit frameChanged();
}

void MotionPanel::showSection(const QString& heading) {
  for (const auto& [name, widget] : sections_)
    if (name == heading) emit sectionWanted(widget);
}

std::optional<TimeBar::Part> MotionPanel::part() const {
  return bar_.part();
}

void MotionPanel::show() {
  const Motion* motion = list_.current();
  const bool any = motion && motion->trajectory;
  for (QPushButton* button : need_motion_) button->setEnabled(any);
  facts_->show();
  showFrame();
  showCheck();
}

void MotionPanel::showCheck() {
  findings_->clear();
  const Motion* motion = list_.current();
  if (!motion || !motion->check) {
    findings_->addItem(tr("Not checked yet"));
    return;
  }
  const Theme& theme = themeOf(palette());
  for (const auto& finding : motion->check->findings) {
    auto* item = new QListWidgetItem(tr("%1 s  %2").arg(finding.t_in, 0, 'f', 2).arg(findingText(finding)), findings_);
    item->setData(Qt::UserRole, finding.t_in);
    const CheckMark mark = markOf(finding);
    QPixmap dot(12, 12);
    dot.fill(colorOf(mark, theme));
    item->setIcon(QIcon(dot));
  }
  if (motion->check->findings.empty()) findings_->addItem(checkLine(*motion->check));
  for (const auto& touch : motion->check->touching_at_start)
    findings_->addItem(tr("In contact from the start: %1 and %2")
                           .arg(QString::fromStdString(touch.first), QString::fromStdString(touch.second)));
}

void MotionPanel::showFrame() {
  const Motion* motion = list_.current();
  const bool any = motion && motion->trajectory && !motion->trajectory->empty();
  const bool chosen = any && frame_ && *frame_ < motion->trajectory->size();
  for (QPushButton* button : need_frame_) button->setEnabled(chosen);
  if (!chosen) {
    frame_label_->setText(any ? tr("Click a dot in the time bar to select a frame, then drag it in the scene.")
                              : tr("No frames"));
    return;
  }
  const auto& frame = (*motion->trajectory)[*frame_];
  QString text =
      tr("Frame %1 of %2 at %3 s: %4, %5, %6").arg(*frame_ + 1).arg(motion->trajectory->size()).arg(frame.t, 0, 'f', 3);
  text = text.arg(lengthText(frame.X_WT.p.x), lengthText(frame.X_WT.p.y), lengthText(frame.X_WT.p.z));
  if (frame.by_hand) text += tr(", by hand");
  if (frame.dwell > 0.0) text += tr(", dwell %1 s").arg(frame.dwell, 0, 'f', 2);
  frame_label_->setText(text);
}

void MotionPanel::smooth() {
  const trajectory::PathTolerance within = clean_->tolerance();
  work_.smooth({within.position, within.angle}, clean_->keepsFree());
}

void MotionPanel::trim() {
  const auto chosen = part();
  if (!chosen) {
    showLine(tr("Set the range first, with the brackets that are now in the time bar."), true);
    const auto& playback = player_.playback();
    const double length = playback.end() - playback.begin();
    bar_.setPart(TimeBar::Part{playback.begin() + 0.25 * length, playback.begin() + 0.75 * length});
    return;
  }
  work_.edit(tr("trimmed"),
             [p = *chosen](const auto& given) { return oneOf(trajectory::trimmed(given, p.from, p.to)); });
}

void MotionPanel::retime() {
  if (timing_->isAsRecorded()) {
    const double sample = recording_->interval();
    return work_.edit(tr("resampled"),
                      [sample](const auto& given) { return oneOf(trajectory::resampled(given, sample)); });
  }
  work_.retime(timing_->options(), clean_->keepsFree());
}

void MotionPanel::insertFrame() {
  const Motion* motion = list_.current();
  if (!motion || !motion->trajectory || motion->trajectory->empty()) return;
  const double t = player_.playback().time();
  work_.edit(tr("with a frame"),
             [t](const auto& given) { return oneOf(trajectory::withFrame(given, t, given.poseAt(t))); });
}

void MotionPanel::deletePart() {
  const Motion* motion = list_.current();
  if (!motion || !motion->trajectory) return;
  if (const auto chosen = part(); chosen && !frame_) {
    return work_.edit(tr("without a range"), [p = *chosen](const auto& given) -> Made {
      std::size_t first = given.size(), last = 0;
      for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i].t < p.from || given[i].t > p.to) continue;
        first = std::min(first, i);
        last = i;
      }
      return oneOf(trajectory::withoutFrames(given, first, last));
    });
  }
  if (!frame_) return showLine(tr("Click a dot in the time bar, or set a range."), true);
  work_.edit(tr("without a frame"),
             [i = *frame_](const auto& given) { return oneOf(trajectory::withoutFrames(given, i, i)); });
}

void MotionPanel::addWay(bool approach) {
  trajectory::StraightWay way;
  way.length = 1e-3 * way_->value();
  way.speed = timing_->speed();
  work_.edit(approach ? tr("with approach") : tr("with retract"), [way, approach](const auto& given) {
    return oneOf(approach ? trajectory::withApproach(given, way) : trajectory::withRetract(given, way));
  });
}

}  // namespace hapticell::app
