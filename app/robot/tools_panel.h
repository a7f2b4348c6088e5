// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <functional>

#include "workcell/entity/entity.h"

class QComboBox;
class QLineEdit;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class RobotContext;
class ValueField;

/// The tools of a robot: named tool centre points, several of them, by numbers or picked on the geometry; and what the
/// robot carries: parts that are attached to a link and move with it. Each change is one undo step.
class ToolsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ToolsPanel(RobotContext& context, QWidget* parent = nullptr);
  ~ToolsPanel() override;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void addTools(QVBoxLayout& column);
  void addCarried(QVBoxLayout& column);
  void show();
  void showTool();
  void showCarried();
  void drawFrame();
  int chosen() const;
  /// Changes the tools by `edit` and keeps `row` chosen.
  void change(int row, const std::function<void(std::vector<workcell::ToolFrame>&)>& edit);
  void addTool();
  void editTool();
  void removeTool();
  void useTool();
  void pick();
  void attach(workcell::EntityId part);
  void mount(workcell::EntityId part);
  RobotContext& context_;
  QListWidget *tools_, *carried_;
  QLineEdit* name_;
  QComboBox *link_, *part_, *carrier_link_;
  std::array<ValueField*, 6> pose_{};
  QPushButton *remove_, *use_, *pick_, *attach_, *mount_, *release_;
  bool showing_ = false;
};

/// An unused name: "Tool", "Tool 2" ...
std::string freeToolName(const std::vector<workcell::ToolFrame>& tools);

}  // namespace hapticell::app
