// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "workcell/entity/entity.h"

class QComboBox;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class MannequinContext;

/// The row *In the hand*: the solid, and the button that holds or releases it. GUI thread.
class CarriedPart : public QObject {
  Q_OBJECT
 public:
  /// The context must outlive it.
  CarriedPart(MannequinContext& context, QVBoxLayout& section, QObject* parent = nullptr);
  /// 0: no part is chosen.
  workcell::EntityId chosen() const;
  void show();

 signals:
  void carryWanted();

 private:
  MannequinContext& context_;
  QComboBox* part_;
  bool part_chosen_ = false;  ///< By the user: the choice stays when other parts are added or move.
  QPushButton* carry_;
};

}  // namespace hapticell::app
