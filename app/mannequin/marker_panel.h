// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/motion/marker_clip.h"

class QLabel;
class QPushButton;
class QSlider;

namespace hapticell::app {

class MannequinContext;

/// Recorded markers (C3D) as small balls in the scene, with play and a time slider. They are drawn at the mannequin if
/// there is one, so that its posture can be compared. GUI thread; files are read in the background.
class MarkerPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MarkerPanel(MannequinContext& context, QWidget* parent = nullptr);
  void open(const QString& path);
  int frame() const;
  void setFrame(int frame);

 protected:
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void take(mannequin::MarkerClip clip, const QString& path);
  void draw(bool on);
  void play(bool on);
  Pose groundPose() const;
  MannequinContext& context_;
  mannequin::MarkerClip clip_;
  std::shared_ptr<const geometry::TriangleMesh> ball_;
  QPushButton* play_;
  QSlider* at_;
  QLabel *name_, *state_;
  QTimer clock_;
};

}  // namespace hapticell::app
