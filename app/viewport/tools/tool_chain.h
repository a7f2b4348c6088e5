// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "app/viewport/tools/pointer_tool.h"

namespace hapticell::app {

/// Tools that share the pointer: first the gizmo of the selection is asked, then the panels' handles in the scene, then
/// the module's tool. The tool that accepts a press keeps the pointer until the last button is released.
class ToolChain final : public PointerTool {
 public:
  enum Place { kGizmo, kHandles, kFigure, kMotion, kModule };
  /// Null removes the tool. It must outlive the time it is set.
  void set(Place place, PointerTool* tool) {
    if (active_ == tools_[place]) active_ = nullptr;
    tools_[place] = tool;
  }

  bool press(const PointerEvent& event) override {
    if (active_) return active_->press(event);
    for (PointerTool* tool : tools_) {
      if (!tool || !tool->press(event)) continue;
      active_ = tool;
      return true;
    }
    return false;
  }
  bool move(const PointerEvent& event) override {
    if (active_) return active_->move(event);
    for (PointerTool* tool : tools_)
      if (tool && tool->move(event)) return true;
    return false;
  }
  bool release(const PointerEvent& event) override {
    PointerTool* const tool = active_;
    if (event.buttons == Qt::NoButton) active_ = nullptr;
    return tool && tool->release(event);
  }
  bool wheel(const PointerEvent& event) override {
    if (active_) return active_->wheel(event);
    for (PointerTool* tool : tools_)
      if (tool && tool->wheel(event)) return true;
    return false;
  }
  QString hint() const override {
    if (active_) return active_->hint();
    for (const PointerTool* tool : tools_)
      if (tool && !tool->hint().isEmpty()) return tool->hint();
    return {};
  }

 private:
  std::array<PointerTool*, 5> tools_{};
  PointerTool* active_ = nullptr;
};

}  // namespace hapticell::app
