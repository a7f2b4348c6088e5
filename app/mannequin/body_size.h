// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include "mannequin/body/anthropometry.h"

class QComboBox;
class QLabel;
class QSlider;

namespace hapticell::app {

class MannequinContext;
class Segmented;
class ValueField;

/// Size of the chosen mannequin: the four boundary bodies, sex, percentile, stature, mass, and single measures. Each
/// change is one undo step; the feet stay where they are.
class BodySize : public QWidget {
  Q_OBJECT
 public:
  explicit BodySize(MannequinContext& context, QWidget* parent = nullptr);
  void showNow();

 private:
  void addMeasures();
  void showMeasure();
  void ask(const mannequin::BodyRequest& request);
  void begin();
  mannequin::BodyRequest present() const;
  MannequinContext& context_;
  Segmented *boundary_, *sex_;
  ValueField *stature_, *mass_, *measure_;
  QComboBox* dimension_;
  QSlider* percentile_;
  QLabel* percentile_text_;
  QTimer wait_;
  mannequin::BodyRequest wanted_;
  bool busy_ = false, again_ = false;
};

}  // namespace hapticell::app
