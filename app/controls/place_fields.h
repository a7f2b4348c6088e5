// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "geometry/shapes/pose.h"

class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class ValueField;

/// Fields for the placement of a new entity: X, Y, Z, a turn about Z, and a button to pick a point in the scene. Two
/// rows for a section of a panel.
class PlaceFields : public QWidget {
  Q_OBJECT
 public:
  /// `prompt`: what the user is asked to click. The fields' object names begin with `name`.
  PlaceFields(Host& host, const QString& name, const QString& prompt, QWidget* parent = nullptr);
  Pose X_W() const;
  void set(const dvec3& p_W);

 signals:
  void edited();

 private:
  void pick(const QString& prompt);
  Host& host_;
  std::array<ValueField*, 4> fields_{};  ///< X, Y, Z in mm; turn about Z in degrees.
};

}  // namespace hapticell::app
