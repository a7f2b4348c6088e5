// SPDX-License-Identifier: Apache-2.0
#include "app/shell/typed_keys.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCursor>
#include <QDockWidget>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/typed_key.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

bool waitsForText(const QWidget* focus) {
  if (const auto* line = qobject_cast<const QLineEdit*>(focus)) return !line->isReadOnly();
  if (const auto* text = qobject_cast<const QTextEdit*>(focus)) return !text->isReadOnly();
  if (const auto* text = qobject_cast<const QPlainTextEdit*>(focus)) return !text->isReadOnly();
  if (const auto* combo = qobject_cast<const QComboBox*>(focus)) return combo->isEditable();
  if (const auto* number = qobject_cast<const QAbstractSpinBox*>(focus)) {
    const auto* line = number->findChild<const QLineEdit*>();
    return line && line->isModified();  // A number that was entered waits for nothing but the next number.
  }
  return qobject_cast<const QKeySequenceEdit*>(focus);
}

bool beginsNumber(const QKeyEvent& key) {
  return !key.text().isEmpty() && (key.text().front().isDigit() || QStringLiteral("+-.,").contains(key.text().front()));
}

/// Typing in it searches.
bool isList(const QWidget* focus) {
  return qobject_cast<const QAbstractItemView*>(focus) || qobject_cast<const QComboBox*>(focus) ||
         (focus && focus->property("list").toBool());
}

bool isEraser(int key) {
  return key == Qt::Key_Delete || key == Qt::Key_Backspace;
}

bool isPrinted(const QKeyEvent& key) {
  return !key.text().isEmpty() && key.text().front().isPrint() && !key.text().front().isSpace();
}

/// The field that searches the panel of `widget`, if it has one.
QLineEdit* searchFieldOf(const QWidget* widget) {
  for (const QWidget* holder = widget; holder; holder = holder->parentWidget()) {
    for (QLineEdit* field : holder->findChildren<QLineEdit*>())
      if (field->property("search").toBool() && field->isVisible() && field->isEnabled()) return field;
    if (holder->isWindow() || qobject_cast<const QDockWidget*>(holder)) return nullptr;
  }
  return nullptr;
}

}  // namespace

TypedKeys::TypedKeys(Host& host, QObject* parent) : QObject(parent), host_(host) {
  qApp->installEventFilter(this);
}

TypedKeys::~TypedKeys() = default;

bool TypedKeys::act() const {
  if (QApplication::activePopupWidget() || QApplication::activeModalWidget()) return false;
  const QWidget* focus = QApplication::focusWidget();
  if (waitsForText(focus)) return false;
  const QWidget* under = QApplication::widgetAt(QCursor::pos());
  const QWidget* scene = &host_.viewport();
  if (under == scene || (under && under->parentWidget() == scene && under->property("seeThrough").toBool()))
    return true;
  return host_.snapshot() && host_.snapshot()->stylus.held != 0 && !isList(focus);
}

bool TypedKeys::isOurs(const QWidget* widget) const {
  while (widget && widget != &host_.window()) widget = widget->parentWidget();
  return widget;
}

bool TypedKeys::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if ((type != QEvent::ShortcutOverride && type != QEvent::KeyPress) || !watched->isWidgetType()) return false;
  auto& key = *static_cast<QKeyEvent*>(event);
  auto& widget = *static_cast<QWidget*>(watched);
  if (!isTypedKey(key.key(), key.modifiers()) || !isOurs(&widget)) return false;
  return type == QEvent::ShortcutOverride ? keepFromCommands(widget, key) : press(widget, key);
}

/// A key whose override is taken reaches the focus as text, and no shortcut hears it.
bool TypedKeys::keepFromCommands(QWidget& focus, QKeyEvent& key) const {
  const bool is_number = qobject_cast<const QAbstractSpinBox*>(&focus);
  if (waitsForText(&focus) || (is_number && (beginsNumber(key) || isEraser(key.key())))) return false;  // Its own key.
  if (is_number && act()) {
    key.ignore();
    return true;  // Not to the field, which would take any letter from the commands.
  }
  const bool in_scene = &focus == &host_.viewport() || focus.isWindow();
  if (isEraser(key.key()) ? in_scene : act()) return false;
  if (isPrinted(key) && !QApplication::activePopupWidget())
    if (QLineEdit* field = searchFieldOf(in_scene ? QApplication::widgetAt(QCursor::pos()) : &focus))
      field->setFocus(Qt::OtherFocusReason);
  key.accept();
  return true;
}

bool TypedKeys::press(QWidget& widget, const QKeyEvent& key) {
  if (auto* combo = qobject_cast<QComboBox*>(&widget); combo && !combo->isEditable() && isPrinted(key)) {
    if (!combo->view()->isVisible()) combo->showPopup();
    combo->view()->keyboardSearch(key.text());
    return true;
  }
  if (&widget == &host_.window() && !act()) sayWhere(key);  // Nothing below it took the key.
  return false;
}

void TypedKeys::sayWhere(const QKeyEvent& key) {
  if (said_) return;
  const QKeySequence pressed(key.keyCombination());
  for (const QAction* action : host_.window().findChildren<QAction*>()) {
    if (!action->shortcuts().contains(pressed)) continue;
    said_ = true;
    return host_.messages().tell(
        Severity::kInformation,
        QObject::tr("%1 works while the pointer is over the scene").arg(pressed.toString(QKeySequence::NativeText)),
        QObject::tr("Elsewhere, letters and digits are text: type to search lists and panels."));
  }
}

}  // namespace hapticell::app
