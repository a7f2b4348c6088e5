// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QLabel;
class QVBoxLayout;

namespace hapticell::app {

class FigureDrag;
class MannequinContext;

/// How far the hand is from its target, and what would help. GUI thread.
class ReachLines : public QObject {
 public:
  /// Context and drag must outlive it.
  ReachLines(MannequinContext& context, FigureDrag& drag, QVBoxLayout& section, QObject* parent = nullptr);
  void show();

 private:
  MannequinContext& context_;
  FigureDrag& drag_;
  QLabel *mark_, *words_, *advice_;
};

}  // namespace hapticell::app
