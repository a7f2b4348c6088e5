// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <string>

class QCheckBox;
class QSlider;

namespace hapticell::app {

class LiveLabel;

/// One agent: its switch, its weight on a slider, and a bar as long as its present wish in the colour of its arrow.
class AgentRow : public QWidget {
  Q_OBJECT
 public:
  AgentRow(std::string kind, bool enabled, double weight, QWidget* parent = nullptr);
  const std::string& kind() const { return kind_; }
  bool isOn() const;
  double weight() const;
  /// ShownWish::strength.
  void setStrength(double strength);

 signals:
  void changed();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void showWeight();
  std::string kind_;
  QCheckBox* switch_;
  QSlider* slider_;
  LiveLabel* number_;
  QWidget* bar_;
  double strength_ = 0.0;
};

}  // namespace hapticell::app
