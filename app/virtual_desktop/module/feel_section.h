// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "workcell/entity/entity.h"

class QComboBox;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class VirtualDesktopController;
class Segmented;
class ValueField;

/// The section *Feel of this entity*: its force class and its material. GUI thread.
class FeelSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  FeelSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void showSettings();

 private:
  void showMaterial(const workcell::Entity* entity);

  Host& host_;
  VirtualDesktopController& controller_;
  Segmented* force_class_;
  QComboBox* material_;
  ValueField *stiffness_, *damping_;
};

}  // namespace hapticell::app
