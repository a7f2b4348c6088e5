// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QThreadPool>
#include <QWidget>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "app/measure/measurement.h"
#include "app/measure/part_distance.h"

class QFormLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class Segmented;

/// Measures picked corners, edges and faces, one or two of them, or the smallest distance of two parts, with
/// components, and copies the numbers. The scene shows them until the panel is closed or something else is measured.
class MeasurePanel : public QWidget {
  Q_OBJECT
 public:
  explicit MeasurePanel(Host& host, QWidget* parent = nullptr);
  ~MeasurePanel() override;
  /// Starts picking; called when the dock is opened.
  void begin();
  /// Ends picking and removes the lines.
  void end();
  /// The results as text, one per line.
  QString text() const;

 private:
  enum class What { kAny, kCorners, kEdges, kFaces, kParts };
  void addTop(QVBoxLayout& column);
  void pick();
  void take(const PickedFeature& feature);
  void measurePicked();
  void measureParts(workcell::EntityId a, workcell::EntityId b);
  void showParts(const std::optional<collision::DistanceResult>& result);
  void showRows(const Measurement& m, const QString& about);
  void addRow(const QString& name, const QString& value, bool main = false);
  void clearRows();
  void draw(const Measurement& m);
  QString nameOf(const PickedFeature& feature) const;
  What what() const;

  Host& host_;
  Segmented* what_;
  QLabel *about_, *number_, *note_;
  QFormLayout* rows_;
  QPushButton *pick_, *copy_, *clear_;
  std::vector<PickedFeature> picked_;
  QStringList lines_;
  bool picking_ = false;
  std::shared_ptr<ColliderCache> cache_;        // Used by the worker only, while one measures.
  std::shared_ptr<std::atomic<bool>> current_;  // Flag of the newest request; false: its answer is not needed any more.
  QThreadPool worker_;
};

}  // namespace hapticell::app
