// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "workcell/document/command.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class PartSizes;
class Segmented;
class SolidPlace;
class SwatchRow;
class ValueField;

/// The dialog of a solid: what it turns about when held (own origin, geometric centre, own frame; the scene shows all
/// three), its placement in the world, in its carrier or in a frame, how it feels, what it is checked for. Follows the
/// selection. Each edit is a command of the document.
class SolidPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SolidPanel(Host& host, QWidget* parent = nullptr);
  /// Shows the newest numbers, and the marks in the scene; called a few times a second.
  void showNow();
  /// Shows the marks alone, at the present pose of the solid.
  void showMarks();

 private:
  void addTurn(QVBoxLayout& column);
  void addFeel(QVBoxLayout& column);
  void addFlags(QVBoxLayout& column);
  void rebuild();
  void showTurn(const workcell::Entity& solid);
  void showFeel(const workcell::Entity& solid);
  void pickFrame();
  void execute(workcell::SetProperties change);
  const workcell::Entity* solid() const;
  const workcell::DocumentState& state() const;

  Host& host_;
  QLabel *nothing_, *title_, *turn_note_, *triangles_;
  QWidget* content_;
  Segmented *turns_, *force_class_, *on_contact_;
  QComboBox *frame_, *material_;
  QWidget* frame_row_;
  QPushButton* new_frame_;
  SolidPlace* place_;
  ValueField* mass_;
  QCheckBox *visible_, *checked_, *locked_;
  SwatchRow* color_;
  PartSizes* sizes_;
};

}  // namespace hapticell::app
