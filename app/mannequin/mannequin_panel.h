// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "manipulation/engine/manipulation_command.h"
#include "mannequin/body/skeleton.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace hapticell::app {

class BodySize;
class CarriedPart;
class FigureDrag;
class FigureSketch;
class JointList;
class MannequinContext;
class ReachLines;
class Segmented;

/// The dock of the mannequin: what the stylus holds of it, what is locked, its size, its hands, its posture, its
/// joints, and how far the hand is from its target.
class MannequinPanel : public QWidget {
  Q_OBJECT
 public:
  MannequinPanel(MannequinContext& context, FigureDrag& drag, QWidget* parent = nullptr);
  /// Updates the panel; called ten times a second and after changes.
  void showNow();
  /// The section for the switches of the drawings.
  QVBoxLayout& drawings() { return *drawings_; }
  /// Asks for a file, starting in the folder of the user's own postures.
  void openPosture();
  void savePosture();
  /// Tells what is needed for a posture; false if a mannequin is selected.
  bool lacksMannequin();
  /// Applies a posture from a file; shows errors in the messages.
  bool openPostureFile(const QString& path);
  /// The folder of the user's own postures; the menu lists those in it.
  static QString postureFolder();
  /// Saves in the format of the file's ending: .json, .x3d (H-Anim) or .bvh (one frame).
  bool savePostureFile(const QString& path);

 signals:
  void addWanted();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addEmptyState(QVBoxLayout& column);
  void addHolding(QVBoxLayout& column);
  void addHands(QVBoxLayout& column);
  void addPostures(QVBoxLayout& column);
  void addReach(QVBoxLayout& column);
  void showMannequin();
  void showHolding();
  void showHands();
  void hold(const manipulation::MovedBy& way);
  void setLock(int which, bool on);
  void takePosture(const QString& name);
  void openPostureMenu();
  void setGrasp(int index);
  void setCurl(int degrees);
  void carry();
  std::vector<mannequin::Side> chosenHands() const;
  MannequinContext& context_;
  FigureDrag& drag_;
  QWidget *empty_, *content_;
  QLabel *name_, *body_;
  ReachLines* reach_;
  FigureSketch* sketch_;
  std::array<QPushButton*, 5> holds_{};
  std::array<QCheckBox*, 4> locks_{};
  BodySize* size_;
  Segmented *grasp_, *two_hands_;
  QSlider* curl_;
  CarriedPart* part_;
  QPushButton *postures_, *mirror_, *swap_;
  JointList* joints_;
  QVBoxLayout* drawings_;
};

}  // namespace hapticell::app
