// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <map>
#include <string>

namespace hapticell::app {

/// Where the controls of a dock stand, to see that none of them moves.
class ControlPlaces {
 public:
  explicit ControlPlaces(const QDockWidget& dock) : dock_(&dock) {
    for (const QWidget* widget : dock.widget()->findChildren<QWidget*>())  // Not its title bar.
      if (isControl(*widget) && widget->isVisible()) places_[widget] = placeOf(*widget);
  }
  std::size_t count() const { return places_.size(); }
  /// Those that stand elsewhere now; empty: none. What came or went meanwhile does not count.
  std::string moved() const {
    std::string told;
    for (const QWidget* widget : dock_->widget()->findChildren<QWidget*>()) {
      const auto before = places_.find(widget);
      if (before == places_.end() || !widget->isVisible() || placeOf(*widget) == before->second) continue;
      const QRect now = placeOf(*widget), was = before->second;
      told += dock_->objectName().toStdString() + '/' + widget->metaObject()->className() + ' ' +
              widget->objectName().toStdString() + " from " + text(was) + " to " + text(now) + '\n';
    }
    return told;
  }

 private:
  static bool isControl(const QWidget& widget) {
    return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
           qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
           (qobject_cast<const QAbstractSlider*>(&widget) && !widget.inherits("QScrollBar")) ||
           qobject_cast<const QAbstractItemView*>(&widget);
  }
  QRect placeOf(const QWidget& widget) const { return {widget.mapTo(dock_->widget(), QPoint(0, 0)), widget.size()}; }
  static std::string text(const QRect& rect) {
    return std::to_string(rect.x()) + ',' + std::to_string(rect.y()) + ' ' + std::to_string(rect.width()) + 'x' +
           std::to_string(rect.height());
  }
  const QDockWidget* dock_;
  std::map<const QWidget*, QRect> places_;
};

}  // namespace hapticell::app
