// SPDX-License-Identifier: Apache-2.0
#include "app/settings/key_map.h"

#include <QAction>
#include <QActionEvent>
#include <QHash>
#include <QTimer>

#include "app/host/user_settings.h"

namespace hapticell::app {
namespace {

constexpr const char* kShipped = "shippedKeys";

bool isLetter(const QKeySequence& key) {
  if (key.count() != 1) return false;
  const auto combination = key[0];
  const bool plain = !(combination.keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  return plain && combination.key() < Qt::Key_Escape;
}

QString plainText(const QAction& action) {
  return QString(action.text()).remove(QLatin1Char('&')).remove(QChar(0x2026)).section(QLatin1Char(':'), 0, 0);
}

}  // namespace

KeyMap::KeyMap(QMainWindow& window, UserSettings& settings, QObject* parent)
    : QObject(parent), window_(window), settings_(settings) {
  window_.installEventFilter(this);
  apply();
}

bool KeyMap::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ActionAdded && !waiting_) {
    waiting_ = true;
    QTimer::singleShot(0, this, [this] {
      waiting_ = false;
      apply();
    });
  }
  return QObject::eventFilter(watched, event);
}

std::vector<KeyMap::Entry> KeyMap::entries() const {
  std::vector<Entry> entries;
  QHash<QString, int> seen;
  for (QAction* action : window_.findChildren<QAction*>()) {
    const QString name = action->objectName();
    if (!name.startsWith(QLatin1String("action")) || plainText(*action).isEmpty()) continue;
    const int number = ++seen[name];
    if (!action->property(kShipped).isValid()) action->setProperty(kShipped, QVariant::fromValue(action->shortcuts()));
    const auto shipped = action->property(kShipped).value<QList<QKeySequence>>();
    entries.push_back({number == 1 ? name : QStringLiteral("%1#%2").arg(name).arg(number), action,
                       shipped.isEmpty() ? QKeySequence() : shipped.front()});
  }
  return entries;
}

std::vector<KeyMap::Row> KeyMap::rows() const {
  std::vector<Row> rows;
  for (const Entry& entry : entries())
    rows.push_back({entry.id, plainText(*entry.action), entry.shipped, entry.action->shortcut()});
  return rows;
}

QKeySequence KeyMap::movedTo(const QString& keyboard, const QKeySequence& shipped) {
  if (keyboard != QLatin1String("azerty") || !isLetter(shipped)) return shipped;
  static const QHash<int, int> moved{{Qt::Key_Q, Qt::Key_A},         {Qt::Key_A, Qt::Key_Q},
                                     {Qt::Key_W, Qt::Key_Z},         {Qt::Key_Z, Qt::Key_W},
                                     {Qt::Key_1, Qt::Key_Ampersand}, {Qt::Key_2, Qt::Key_Eacute},
                                     {Qt::Key_3, Qt::Key_QuoteDbl},  {Qt::Key_4, Qt::Key_Apostrophe}};
  const auto combination = shipped[0];
  if (combination.keyboardModifiers().testFlag(Qt::KeypadModifier)) return shipped;
  const auto key = static_cast<Qt::Key>(moved.value(combination.key(), combination.key()));
  return QKeySequence(QKeyCombination(combination.keyboardModifiers(), key));
}

void KeyMap::apply() {
  if (applying_) return;
  applying_ = true;
  const QString board = keyboard();
  for (const Entry& entry : entries()) {
    const QVariant own = settings_.value("keys/" + entry.id);
    QList<QKeySequence> keys = entry.action->property(kShipped).value<QList<QKeySequence>>();
    for (QKeySequence& key : keys) key = movedTo(board, key);
    if (own.isValid()) keys = {QKeySequence(own.toString(), QKeySequence::PortableText)};
    if (!lettersOn()) keys.removeIf([](const QKeySequence& key) { return isLetter(key); });
    keys.removeIf([](const QKeySequence& key) { return key.isEmpty(); });
    if (entry.action->shortcuts() == keys) continue;
    entry.action->setShortcuts(keys);
    const QString tip = entry.action->toolTip().section(QLatin1String("  ("), 0, 0);
    entry.action->setToolTip(keys.isEmpty() ? tip
                                            : tip + "  (" + keys.front().toString(QKeySequence::NativeText) + ")");
  }
  applying_ = false;
  emit changed();
}

void KeyMap::set(const QString& id, const QKeySequence& key) {
  if (!key.isEmpty())
    for (const Row& row : rows())
      if (row.id != id && row.now == key) settings_.setValue("keys/" + row.id, QString());
  settings_.setValue("keys/" + id, key.toString(QKeySequence::PortableText));
  apply();
}

void KeyMap::reset(const QString& id) {
  settings_.remove("keys/" + id);
  apply();
}

void KeyMap::resetAll() {
  for (const QString& id : settings_.keysBelow("keys")) settings_.remove("keys/" + id);
  apply();
}

QString KeyMap::useOf(const QKeySequence& key, const QString& beside) const {
  if (key.isEmpty()) return {};
  for (const Row& row : rows())
    if (row.id != beside && row.now == key) return row.text;
  return {};
}

void KeyMap::setKeyboard(const QString& keyboard) {
  settings_.setValue("keyboard/layout", keyboard);
  apply();
}

QString KeyMap::keyboard() const {
  return settings_.value("keyboard/layout", "qwerty").toString();
}

void KeyMap::setLettersOn(bool on) {
  settings_.setValue("keyboard/letters", on);
  apply();
}

bool KeyMap::lettersOn() const {
  return settings_.value("keyboard/letters", true).toBool();
}

}  // namespace hapticell::app
