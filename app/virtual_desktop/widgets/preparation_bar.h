// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <optional>

class QLabel;
class QProgressBar;

namespace hapticell::app {

/// In the corner of the view while the parts of a document are made ready for contacts: how far it is, and a button
/// that gives it up (meshes that are ready by then stay so). It appears only where that takes longer than half a
/// second.
class PreparationBar : public QWidget {
  Q_OBJECT
 public:
  explicit PreparationBar(QWidget* parent = nullptr);
  /// How long (ms) a preparation may last without being shown; 500 at first.
  void setPatience(qint64 milliseconds) { patience_ = milliseconds; }
  /// 0 to 1; nothing: there is nothing to be made ready. As often as one likes.
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
