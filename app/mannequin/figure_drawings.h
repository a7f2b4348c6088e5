// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <map>
#include <memory>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/posture/posture.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class MannequinContext;

/// What the scene draws about the mannequin, with its switches: its reach and that of P5, P50 and P95, working zones,
/// its view, its balance; the view through its eyes; and whether it sees what was selected last. GUI thread; surfaces
/// that take long are made in the background once the mannequin is at rest.
class FigureDrawings : public QWidget {
  Q_OBJECT
 public:
  explicit FigureDrawings(MannequinContext& context, QWidget* parent = nullptr);
  void showNow();

 private:
  enum Kind { kReach, kTrunkReach, kZones, kSight, kBalance, kSizesReach, kKinds };
  void addSwitches(QVBoxLayout& column);
  void drawVolumes();
  void drawBalance();
  void askReach();
  void nameSizes();
  void askSight();
  void lookThroughEyes();
  void lookAtTarget();
  bool isOn(Kind kind) const;
  MannequinContext& context_;
  std::array<QCheckBox*, kKinds> switches_{};
  QPushButton *eyes_, *sight_, *gaze_;
  QLabel *balance_, *seen_;
  mannequin::Posture posture_;
  std::shared_ptr<const mannequin::Figure> figure_;
  std::map<int, std::vector<std::shared_ptr<const geometry::TriangleMesh>>> reach_;  ///< By kind: left, right.
  QTimer rests_;
  std::uint64_t question_ = 0;
  bool asking_ = false;
};

}  // namespace hapticell::app
