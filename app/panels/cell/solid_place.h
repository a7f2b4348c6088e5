// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>

#include "workcell/entity/entity.h"

class QVBoxLayout;
class QWidget;

namespace hapticell::app {

class Host;
class ReferenceChoice;
class Segmented;
class ValueField;

/// The placement of the selected solid: in the world, in what it is attached to, or in a frame. Typed values become
/// commands of the document. GUI thread.
class SolidPlace : public QObject {
  Q_OBJECT
 public:
  /// The host must outlive it.
  SolidPlace(Host& host, QVBoxLayout& column, QObject* parent = nullptr);
  /// Updates the list of references from the document.
  void showChoices(const workcell::Entity& solid);
  /// Shows the present placement.
  void showNow(const workcell::Entity& solid);

 private:
  void place();
  void showAgain();
  const workcell::Entity* solid() const;
  Pose placeReference_W(const workcell::Entity& solid) const;

  Host& host_;
  Segmented* in_;
  ReferenceChoice* frame_;  ///< The frame, if the placement is given in one of the cell.
  QWidget* frame_row_;
  std::array<ValueField*, 6> fields_{};
};

}  // namespace hapticell::app
