// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "workcell/entity/entity.h"

class QComboBox;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class VirtualDesktopController;
class Segmented;

/// The section *What is held*: the entity, what of it the hand moves, what it is checked against, and its contact mode.
/// GUI thread.
class HeldSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  HeldSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void listEntities();
  void showSettings();

 private:
  void listSets();
  void listFrames(const workcell::Entity* entity);

  Host& host_;
  VirtualDesktopController& controller_;
  QComboBox *entity_, *against_, *moved_frame_;
  QWidget* moved_frame_row_;
  Segmented *moved_by_, *on_contact_;
};

}  // namespace hapticell::app
