// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <optional>

class QLabel;
class QProgressBar;

namespace hapticell::app {

/// Shown in the corner of the view while the parts of a document are prepared for contacts: the progress, and
/// a button to cancel (meshes that are ready stay ready). Appears only if that takes longer than half a
/// second.
class PreparationBar : public QWidget {
  Q_OBJECT
 public:
  explicit PreparationBar(QWidget* parent = nullptr);
  /// How long (ms) a preparation may last without being shown; 500 at first.
  void setPatience(qint64 milliseconds) { patience_ = milliseconds; }
  /// Progress, 0 to 1; empty: nothing is being prepared. May be called at any rate.
  void setShare(std::optional<double> share);

 signals:
  void cancelled();

 private:
  QLabel* text_;
  QProgressBar* bar_;
  QElapsedTimer since_;
  qint64 patience_ = 500;
};

}  // namespace hapticell::app
