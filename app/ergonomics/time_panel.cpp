// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/time_panel.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/motion_scores_model.h"
#include "app/ergonomics/score_painting.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/style/key_step.h"
#include "app/style/library_text.h"
#include "app/viewport/widget/viewport_widget.h"
#include "geometry/system/atomic_file.h"
#include "mannequin/motion/motion_writer.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

// Pixels; the last: ms a picture while playing, 30 a second. Half: twice the work; twice: it jerks.
constexpr int kNamesWidth = 92, kShares = 96, kTop = 26, kTimeLine = 26, kStrip = 18, kPlayMilliseconds = 33;
const std::array<const char*, 4> kBodyNames{
    QT_TRANSLATE_NOOP("ScoreHistory", "P5 woman"), QT_TRANSLATE_NOOP("ScoreHistory", "P50 woman"),
    QT_TRANSLATE_NOOP("ScoreHistory", "P50 man"), QT_TRANSLATE_NOOP("ScoreHistory", "P95 man")};

}  // namespace

TimePanel::TimePanel(MannequinContext& context, const LiveScores& scores, MotionScoresModel& motion, QWidget* parent)
    : QWidget(parent), context_(context), scores_(scores), motion_(motion) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  auto* line = new QHBoxLayout;
  auto* open_button = new QPushButton(tr("Open motion…"));
  open_button->setObjectName("buttonOpenMotion");
  play_ = new QPushButton(tr("Play"));
  play_->setObjectName("buttonPlayMotion");
  play_->setCheckable(true);
  worst_ = new QPushButton(tr("Worst phase"));
  worst_->setObjectName("buttonWorstFrame");
  take_ = new QPushButton(tr("Apply this posture"));
  take_->setObjectName("buttonTakeFrame");
  save_ = new QPushButton(tr("Save as BVH…"));
  save_->setObjectName("buttonSaveMotion");
  save_->setToolTip(tr("Save the motion as fitted to this mannequin"));
  name_ = makeLabel({}, TextRole::kSection);
  name_->setObjectName("labelMotion");
  at_ = makeLive(1, TextRole::kSecond, true);
  at_->setObjectName("labelScoredFrame");
  line->addWidget(open_button);
  line->addWidget(play_);
  line->addWidget(worst_);
  line->addWidget(take_);
  line->addWidget(save_);
  line->addStretch(1);
  column->addLayout(line);
  auto* told = new QHBoxLayout;
  told->addWidget(name_);
  told->addWidget(at_, 1);
  column->addLayout(told);
  beyond_ = makeLive(1, TextRole::kSecond);
  beyond_->setObjectName("labelBeyondLimits");
  column->addWidget(beyond_);
  history_ = new ScoreHistory(motion_);
  auto* scrolled = new QScrollArea;  // Where the dock is low: its rows must not take the scene's height.
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setWidgetResizable(true);
  scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scrolled->setMinimumHeight(kTop + kTimeLine);
  scrolled->setWidget(history_);
  column->addWidget(scrolled, 1);
  clock_.setInterval(kPlayMilliseconds);
  connect(open_button, &QPushButton::clicked, this, &TimePanel::choose);
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString path =
        askToSave(this, tr("Save the motion"), motion_.name() + ".bvh", tr("Motions (*.bvh);;All files (*)"));
    if (!path.isEmpty()) saveMotion(path);
  });
  connect(play_, &QPushButton::clicked, this, &TimePanel::play);
  connect(worst_, &QPushButton::clicked, this, [this] { setFrame(motion_.worstFrame()); });
  connect(take_, &QPushButton::clicked, this, &TimePanel::takePosture);
  connect(history_, &ScoreHistory::frameChosen, this, &TimePanel::setFrame);
  connect(&motion_, &MotionScoresModel::changed, this, &TimePanel::showMotion);
  connect(&motion_, &MotionScoresModel::opened, this, [this] {
    setFrame(motion_.worstFrame());
    if (const QString said = motion_.assumptions(); !said.isEmpty())
      context_.host().messages().tell(Severity::kInformation, tr("Assumptions for %1").arg(motion_.name()), said);
  });
  connect(&motion_, &MotionScoresModel::failed, this, [this](const QString& why) {
    context_.host().messages().tell(Severity::kWarning, tr("The motion cannot be shown"), why);
  });
  connect(&clock_, &QTimer::timeout, this, [this] {
    if (motion_.isEmpty()) return play(false);
    const double rate = motion_.frames() / std::max(1e-3, motion_.seconds());
    const int step = std::max(1, static_cast<int>(std::lround(rate * kPlayMilliseconds / 1000.0)));
    if (frame_ + step >= motion_.frames()) play(false);
    setFrame(std::min(frame_ + step, motion_.frames() - 1));
  });
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, [this] {
    play(false);
    frame_ = 0;
  });
  showMotion();
}

void TimePanel::open(const QString& path) {
  motion_.open(path, scores_.figure(), scores_.task());
}

void TimePanel::choose() {
  const QString path =
      askToOpen(this, tr("Open a recorded motion"), {}, tr("Motions (*.bvh *.amc *.c3d);;All files (*)"));
  if (!path.isEmpty()) open(path);
}

bool TimePanel::saveMotion(const QString& path) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || motion_.isEmpty()) return false;
  const auto written = writeFileAtomically(
      path.toStdString(),
      mannequin::bvhText(*entity->figure(), motion_.postures(), motion_.seconds() / motion_.frames()));
  if (written)
    context_.host().messages().tell(Severity::kInformation, tr("The motion is saved"), path);
  else
    context_.host().messages().reportCause(Severity::kProblem, tr("The motion was not saved"), written.error());
  return written.has_value();
}

void TimePanel::showMotion() {
  const bool any = !motion_.isEmpty();
  for (QPushButton* button : {play_, worst_, take_, save_}) button->setEnabled(any);
  const QString beyond = motion_.beyondLimits();
  beyond_->setText(beyond.isEmpty()
                       ? QString()
                       : tr("Beyond the range of motion, not clamped. Longest: %1.").arg(motion_.mostBeyond()));
  beyond_->setToolTip(beyond);
  const QString name = any ? motion_.name() : QString();
  name_->setText(motion_.isBusy() ? tr("Scoring the motion…") : name);
  at_->setText(any ? QString() : tr("Open a recording (BVH, AMC, C3D) to score each of its frames."));
  frame_ = std::min(frame_, std::max(0, motion_.frames() - 1));
  history_->setFrame(frame_);
  history_->update();
}

void TimePanel::setFrame(int frame) {
  if (motion_.isEmpty()) return;
  frame_ = std::clamp(frame, 0, motion_.frames() - 1);
  history_->setFrame(frame_);
  const double at = motion_.seconds() * frame_ / motion_.frames();
  const ergonomics::MotionPhase worst = *motion_.phase();
  at_->setText(tr("%1 s, RULA %2 · worst phase %3 s to %4 s, RULA %5")
                   .arg(at, 0, 'f', 2)
                   .arg(motion_.rulaAt(frame_))
                   .arg(worst.from_s, 0, 'f', 2)
                   .arg(worst.to_s, 0, 'f', 2)
                   .arg(worst.rula));
  if (isSeen(*this)) showPlayed(true);
}

void TimePanel::showPlayed(bool on) {
  const workcell::Entity* entity = context_.entity();
  std::vector<GhostPose> played;
  if (on && entity && !motion_.isEmpty() && !context_.isHeld()) {
    const auto posture = placedHere(*entity, motion_.posture(frame_));
    const auto stands = mannequin::toModel(*entity->figure(), posture);
    played.push_back({entity->id, stands.X_WE, stands.joints});
  }
  context_.host().viewport().scene().setPlayed(std::move(played));
  context_.host().viewport().refresh();
}

void TimePanel::play(bool on) {
  play_->setChecked(on);
  play_->setText(on ? tr("Pause") : tr("Play"));
  if (on && frame_ + 1 >= motion_.frames()) frame_ = 0;
  on ? clock_.start() : clock_.stop();
}

void TimePanel::takePosture() {
  const workcell::Entity* entity = context_.entity();
  if (!entity || motion_.isEmpty() || !context_.isFree()) return;
  play(false);
  showPlayed(false);
  context_.host().documentModel().executeAll(tr("Posture of %1 at frame %2").arg(motion_.name()).arg(frame_ + 1),
                                             {postureCommand(*entity, placedHere(*entity, motion_.posture(frame_)))});
}

void TimePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (motion_.isEmpty()) return;
  play(false);
  showPlayed(false);
}

ScoreHistory::ScoreHistory(const MotionScoresModel& motion, QWidget* parent) : QWidget(parent), motion_(motion) {
  setObjectName("scoreHistory");
  setFocusPolicy(Qt::StrongFocus);
  setMinimumHeight(kTop + 4 * kTimeLine);
  setAccessibleName(tr("RULA along the motion, four mannequins"));
}

QRectF ScoreHistory::area() const {
  return {kNamesWidth, kTop, std::max(10.0, width() - kNamesWidth - kShares - 4.0), 4.0 * kTimeLine};
}

void ScoreHistory::setFrame(int frame) {
  frame_ = frame;
  update();
}

void ScoreHistory::chooseAt(double x) {
  if (motion_.isEmpty()) return;
  const double share = std::clamp((x - area().left()) / area().width(), 0.0, 1.0);
  emit frameChosen(static_cast<int>(std::lround(share * (motion_.frames() - 1))));
}

void ScoreHistory::mousePressEvent(QMouseEvent* event) {
  chooseAt(event->position().x());
}
void ScoreHistory::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) chooseAt(event->position().x());
}

void ScoreHistory::keyPressEvent(QKeyEvent* event) {
  const int step = keyStep(event->key(), Qt::Key_Left, Qt::Key_Right);
  if (step == 0 || motion_.isEmpty()) return QWidget::keyPressEvent(event);
  emit frameChosen(std::clamp(frame_ + step, 0, motion_.frames() - 1));
}

void ScoreHistory::paintEvent(QPaintEvent*) {
  if (motion_.isEmpty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kSecond));
  const QRectF all = area();
  painter.setPen(theme.text2);
  for (int i = 0; i <= 6; ++i) {
    const double x = all.left() + all.width() * i / 6.0;
    painter.drawLine(QPointF(x, kTop - 6), QPointF(x, kTop - 2));
    painter.drawText(QRectF(x - 40, 2, 80, 16), Qt::AlignCenter,
                     tr("%1 s").arg(motion_.seconds() * i / 6.0, 0, 'f', 1));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double top = kTop + kTimeLine * static_cast<double>(i);
    painter.setPen(theme.text1);
    painter.drawText(QRectF(0, top, kNamesWidth - 6, kStrip), Qt::AlignLeft | Qt::AlignVCenter, tr(kBodyNames[i]));
    paintStrip(painter, QRectF(all.left(), top, all.width(), kStrip), motion_.bands(i), theme);
    painter.setPen(theme.text1);
    painter.drawText(QRectF(all.right() + 8, top, kShares - 4, kStrip), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("%1 % at 5–7").arg(100.0 * motion_.shareAbove(i), 0, 'f', 0));
  }
  const auto place = [&](std::size_t frame) {
    return all.left() + all.width() * static_cast<double>(frame) / static_cast<double>(motion_.frames());
  };
  const double from = place(motion_.worstPhase().first), to = place(motion_.worstPhase().last + 1);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.text1, 1.5));
  painter.drawRect(QRectF(from, kTop - 3.0, std::max(3.0, to - from), 4.0 * kTimeLine));
  const double x = all.left() + all.width() * frame_ / std::max(1, motion_.frames() - 1);
  painter.setPen(QPen(theme.scene.force, 2));
  painter.drawLine(QPointF(x, kTop - 8), QPointF(x, kTop + 4 * kTimeLine - 4));
}

}  // namespace hapticell::app
