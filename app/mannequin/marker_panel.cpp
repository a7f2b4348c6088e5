// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/marker_panel.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/kit/thread_pool_task.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/library_text.h"
#include "app/style/style_painting.h"
#include "app/viewport/widget/viewport_widget.h"
#include "geometry/shapes/shapes.h"
#include "mannequin/motion/marker_set.h"

namespace hapticell::app {
namespace {

// ms a picture: 30 a second move smoothly. Half: twice the work; twice: it jerks.
constexpr int kPlayMilliseconds = 33;
constexpr double kBallRadius = 0.009;  // m, about a real marker's.
constexpr const char* kOwner = "markers";

}  // namespace

MarkerPanel::MarkerPanel(MannequinContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      ball_(std::make_shared<const geometry::TriangleMesh>(geometry::makeSphere(kBallRadius))) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  auto* open_button = new QPushButton(tr("Open markers…"));
  open_button->setObjectName("buttonOpenMarkers");
  play_ = new QPushButton(tr("Play"));
  play_->setObjectName("buttonPlayMarkers");
  play_->setCheckable(true);
  name_ = makeLabel({}, TextRole::kSection);
  name_->setObjectName("labelMarkers");
  auto* line = new QHBoxLayout;
  line->addWidget(open_button);
  line->addWidget(play_);
  line->addWidget(name_, 1);
  column->addLayout(line);
  at_ = new QSlider(Qt::Horizontal);
  at_->setObjectName("sliderMarkers");
  at_->setAccessibleName(tr("Time in the recording"));
  column->addWidget(at_);
  state_ = makeLive(3, TextRole::kSecond, true);
  state_->setText(tr("Open a recording of markers (C3D) to see them in the scene."));
  state_->setObjectName("labelMarkerState");
  column->addWidget(state_);
  column->addStretch(1);
  play_->setEnabled(false);
  at_->setEnabled(false);
  clock_.setInterval(kPlayMilliseconds);
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, [this] {
    play(false);
    draw(false);
    clip_ = {};
    at_->setRange(0, 0);
    play_->setEnabled(false);
    at_->setEnabled(false);
    name_->clear();
    state_->setText(tr("Open a recording of markers (C3D) to see them in the scene."));
  });
  connect(open_button, &QPushButton::clicked, this, [this] {
    const QString path = askToOpen(this, tr("Open recorded markers"), {}, tr("Markers (*.c3d);;All files (*)"));
    if (!path.isEmpty()) open(path);
  });
  connect(play_, &QPushButton::clicked, this, &MarkerPanel::play);
  connect(at_, &QSlider::valueChanged, this, [this] { draw(true); });
  connect(&clock_, &QTimer::timeout, this, [this] {
    const int step = std::max(1, static_cast<int>(std::lround(1e-3 * kPlayMilliseconds / clip_.frame_time)));
    if (frame() + step > at_->maximum()) play(false);
    setFrame(frame() + step);
  });
}

void MarkerPanel::open(const QString& path) {
  runInThreadPool(
      this, [file = path.toStdString()] { return mannequin::readC3d(file); },
      [this, path](Expected<mannequin::MarkerClip> clip) {
        if (clip) return take(std::move(*clip), path);
        context_.host().messages().reportCause(Severity::kWarning, tr("The markers cannot be shown"), clip.error());
      });
}

void MarkerPanel::take(mannequin::MarkerClip clip, const QString& path) {
  play(false);
  clip_ = std::move(clip);
  const int last = static_cast<int>(clip_.frames()) - 1;
  play_->setEnabled(last > 0);
  at_->setEnabled(last > 0);
  at_->setRange(0, std::max(0, last));
  at_->setValue(0);
  name_->setText(tr("%1: %2 markers, %3 s at %4 Hz")
                     .arg(QFileInfo(path).fileName())
                     .arg(clip_.names.size())
                     .arg(clip_.seconds(), 0, 'f', 1)
                     .arg(1.0 / clip_.frame_time, 0, 'f', 0));
  for (const Text& warning : clip_.warnings)
    context_.host().messages().reportCause(Severity::kWarning, QFileInfo(path).fileName(), warning);
  const auto set = mannequin::recogniseMarkers(clip_);
  context_.host().messages().tell(
      Severity::kInformation, QFileInfo(path).fileName(),
      set ? tr("These are the markers of %1. To put the recording on the mannequin: Mannequin > Open a recorded "
               "motion.")
                .arg(QString::fromStdString(set->name))
          : tr("The markers are shown, but no mannequin can be fitted to this marker set: %1")
                .arg(shownText(set.error())));
  draw(true);
}

int MarkerPanel::frame() const {
  return at_->value();
}

void MarkerPanel::setFrame(int frame) {
  at_->setValue(frame);
}

/// Where the recording's floor stands: about the mannequin's place, turned as it is.
Pose MarkerPanel::groundPose() const {
  const workcell::Entity* entity = context_.entity();
  return entity ? entity->X_WE : Pose::identity();
}

void MarkerPanel::draw(bool on) {
  std::vector<RenderItem> items;
  QStringList unseen;
  if (on && clip_.frames() > 0 && isVisible()) {
    const auto now = static_cast<std::size_t>(frame());
    dvec3 middle(0.0);
    double count = 0.0;
    for (std::size_t k = 0; k < clip_.names.size(); ++k) {  // The recording begins where the mannequin stands.
      if (const auto& p = clip_.at(0, k)) middle += *p, ++count;
    }
    if (count > 0.0) middle /= count;
    const Pose X_WG = groundPose();
    for (std::size_t k = 0; k < clip_.names.size(); ++k) {
      const auto& p = clip_.at(now, k);
      if (!p) {
        unseen << QString::fromStdString(clip_.names[k]);
        continue;
      }
      RenderItem item;
      item.mesh = ball_;
      item.bounds_M = ball_->bounds();
      item.X_WM = X_WG * Pose::translation(*p - dvec3(middle.x, middle.y, 0.0));
      item.color = channelsOf(themeOf(palette()).scene.force);
      item.casts_shadow = false;
      items.push_back(std::move(item));
    }
    QString text = tr("%1 s, %2 of %3 markers seen")
                       .arg(static_cast<double>(frame()) * clip_.frame_time, 0, 'f', 2)
                       .arg(clip_.names.size() - static_cast<std::size_t>(unseen.size()))
                       .arg(clip_.names.size());
    constexpr int kNamed = 6;
    if (!unseen.isEmpty()) text += tr(", not seen: %1").arg(unseen.mid(0, kNamed).join(", "));
    if (unseen.size() > kNamed) text += QStringLiteral(", …");
    state_->setText(text);
  }
  context_.host().viewport().scene().setExtras(kOwner, std::move(items));
  context_.host().viewport().refresh();
}

void MarkerPanel::play(bool on) {
  play_->setChecked(on);
  play_->setText(on ? tr("Pause") : tr("Play"));
  if (on && frame() >= at_->maximum()) setFrame(0);
  on ? clock_.start() : clock_.stop();
}

void MarkerPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  play(false);
  draw(false);
}

void MarkerPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  draw(true);
}

}  // namespace hapticell::app
