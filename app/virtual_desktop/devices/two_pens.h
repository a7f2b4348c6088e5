// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/virtual_desktop/devices/mouse_stylus.h"

namespace hapticell::app {

/// The mouse over two drawn styluses: a drag moves the pen nearer to the pointer until the button is released; at other
/// times, the mouse controls the first one.
class TwoPens final : public PointerTool {
 public:
  TwoPens(MouseStylus& first, MouseStylus& second) : first_(first), second_(second) {}

  bool press(const PointerEvent& event) override {
    if (dragged_ != nullptr) return dragged_->press(event);
    const bool second_is_nearer = !first_.follow() && second_.pixelsToPen(event) < first_.pixelsToPen(event);
    MouseStylus& nearer = second_is_nearer ? second_ : first_;
    MouseStylus& other = second_is_nearer ? first_ : second_;
    if (nearer.press(event)) return dragged_ = &nearer, true;
    if (other.press(event)) return dragged_ = &other, true;
    return false;
  }
  bool move(const PointerEvent& event) override {
    if (dragged_ != nullptr) return dragged_->move(event);
    second_.move(event);
    return first_.move(event);
  }
  bool release(const PointerEvent& event) override {
    MouseStylus& released = dragged_ != nullptr ? *dragged_ : first_;
    if (event.button == Qt::LeftButton) dragged_ = nullptr;
    return released.release(event);
  }
  bool wheel(const PointerEvent& event) override { return dragged_ ? dragged_->wheel(event) : first_.wheel(event); }
  QString hint() const override {
    if (dragged_ != nullptr) return dragged_->hint();
    const QString hint = first_.hint();
    return hint.isEmpty() ? second_.hint() : hint;
  }

 private:
  MouseStylus &first_, &second_;
  MouseStylus* dragged_ = nullptr;
};

}  // namespace hapticell::app
