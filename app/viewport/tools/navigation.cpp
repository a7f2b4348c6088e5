// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/tools/navigation.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>

namespace hapticell::app {
namespace {

constexpr auto kLeftButton = Qt::LeftButton, kMiddleButton = Qt::MiddleButton, kRightButton = Qt::RightButton;
constexpr auto kNone = Qt::NoModifier;
constexpr auto kShift = Qt::ShiftModifier, kControl = Qt::ControlModifier, kAlt = Qt::AltModifier;

QString tr(const char* text) {
  return QCoreApplication::translate("Navigation", text);
}

struct Word {
  const char* key;
  const char* text;
};
constexpr std::array<std::pair<Qt::MouseButton, Word>, 3> kButtons{
    {{kLeftButton, {"left", QT_TRANSLATE_NOOP("Navigation", "Left")}},
     {kMiddleButton, {"middle", QT_TRANSLATE_NOOP("Navigation", "Middle")}},
     {kRightButton, {"right", QT_TRANSLATE_NOOP("Navigation", "Right")}}}};
constexpr std::array<std::pair<Qt::KeyboardModifier, Word>, 3> kModifiers{
    {{kControl, {"ctrl", QT_TRANSLATE_NOOP("Navigation", "Ctrl")}},
     {kAlt, {"alt", QT_TRANSLATE_NOOP("Navigation", "Alt")}},
     {kShift, {"shift", QT_TRANSLATE_NOOP("Navigation", "Shift")}}}};
constexpr std::array kMotions{ViewMotion::kOrbit, ViewMotion::kPan, ViewMotion::kZoom};

struct Preset {
  QString key;
  const char* name;
  Navigation navigation;
};

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all{
      {"hapticell",
       QT_TRANSLATE_NOOP("Navigation", "HaptiCell: middle button rotates"),
       {{{kMiddleButton, kNone}}, {{kMiddleButton, kShift}}, {{kMiddleButton, kControl}}}},
      {"catia",
       "CATIA",
       {{{kMiddleButton | kRightButton, kNone}, {kMiddleButton | kLeftButton, kNone}},
        {{kMiddleButton, kNone}},
        {{kMiddleButton, kNone, true}}}},
      {"solidworks", "SolidWorks", {{{kMiddleButton, kNone}}, {{kMiddleButton, kControl}}, {{kMiddleButton, kShift}}}},
      {"nx",
       "NX",
       {{{kMiddleButton, kNone}},
        {{kMiddleButton | kRightButton, kNone}, {kMiddleButton, kShift}},
        {{kMiddleButton | kLeftButton, kNone}, {kMiddleButton, kControl}}}},
      {"freecad",
       "FreeCAD",
       {{{kMiddleButton | kLeftButton, kNone}, {kMiddleButton | kRightButton, kNone}},
        {{kMiddleButton, kNone}},
        {{kMiddleButton, kShift | kControl}}}},
      {"rviz",
       "RViz",
       {{{kLeftButton, kNone}}, {{kMiddleButton, kNone}, {kLeftButton, kShift}}, {{kRightButton, kNone}}}},
      {"blender", "Blender", {{{kMiddleButton, kNone}}, {{kMiddleButton, kShift}}, {{kMiddleButton, kControl}}}},
      {"touchpad",
       QT_TRANSLATE_NOOP("Navigation", "Touchpad"),
       {{{kLeftButton, kAlt}}, {{kLeftButton, kAlt | kShift}}, {{kLeftButton, kAlt | kControl}}, true}}};
  return all;
}

}  // namespace

const std::vector<ViewGesture>& Navigation::of(ViewMotion motion) const {
  if (motion == ViewMotion::kOrbit) return orbit;
  return motion == ViewMotion::kPan ? pan : zoom;
}

std::vector<ViewGesture>& Navigation::of(ViewMotion motion) {
  if (motion == ViewMotion::kOrbit) return orbit;
  return motion == ViewMotion::kPan ? pan : zoom;
}

std::optional<ViewMotion> Navigation::motionFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers,
                                                bool after_release) const {
  modifiers &= ~Qt::KeypadModifier;
  std::optional<ViewMotion> plain;
  for (const ViewMotion motion : kMotions)
    for (const ViewGesture& gesture : of(motion)) {
      if (gesture.buttons != buttons || gesture.modifiers != modifiers) continue;
      if (gesture.released && after_release) return motion;
      if (!gesture.released && !plain) plain = motion;
    }
  return plain;
}

bool Navigation::uses(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const {
  return motionFor(button, modifiers).has_value();
}

const std::vector<QString>& navigationPresets() {
  static const std::vector<QString> keys = [] {
    std::vector<QString> all;
    for (const Preset& preset : presets()) all.push_back(preset.key);
    return all;
  }();
  return keys;
}

QString navigationPresetName(const QString& preset) {
  for (const Preset& known : presets())
    if (known.key == preset) return tr(known.name);
  return preset;
}

Navigation navigationPreset(const QString& preset) {
  for (const Preset& known : presets())
    if (known.key == preset) return known.navigation;
  return presets().front().navigation;
}

QString gestureText(const ViewGesture& gesture, bool for_file) {
  QStringList words;
  const auto word = [&](const Word& w) { words << (for_file ? QString::fromLatin1(w.key) : tr(w.text)); };
  for (const auto& [modifier, w] : kModifiers)
    if (gesture.modifiers.testFlag(modifier)) word(w);
  for (const auto& [button, w] : kButtons)
    if (gesture.buttons.testFlag(button)) word(w);
  if (gesture.released)
    words << (for_file ? QStringLiteral("released") : QCoreApplication::translate("Navigation", "another clicked"));
  return words.join(QLatin1Char('+'));
}

std::optional<ViewGesture> gestureFromText(const QString& text) {
  ViewGesture gesture;
  for (const QString& part : text.split(QLatin1Char('+'))) {
    bool known = part == QLatin1String("released");
    if (known) gesture.released = true;
    for (const auto& [modifier, w] : kModifiers)
      if (part == QLatin1String(w.key)) gesture.modifiers |= modifier, known = true;
    for (const auto& [button, w] : kButtons)
      if (part == QLatin1String(w.key)) gesture.buttons |= button, known = true;
    if (!known) return std::nullopt;
  }
  if (gesture.buttons == Qt::NoButton) return std::nullopt;
  return gesture;
}

QString navigationText(const Navigation& navigation) {
  QStringList fields;
  for (const ViewMotion motion : kMotions) {
    QStringList gestures;
    for (const ViewGesture& gesture : navigation.of(motion)) gestures << gestureText(gesture, true);
    fields << gestures.join(QLatin1Char(' '));
  }
  QStringList flags;
  if (navigation.wheel_turns) flags << "wheel_turns";
  if (navigation.wheel_reversed) flags << "wheel_reversed";
  if (navigation.zoom_to_pointer) flags << "zoom_to_pointer";
  fields << flags.join(QLatin1Char(' '));
  return fields.join(QLatin1Char(';'));
}

std::optional<Navigation> navigationFromText(const QString& text) {
  const QStringList fields = text.split(QLatin1Char(';'));
  if (fields.size() != 4) return std::nullopt;
  Navigation navigation;
  for (std::size_t i = 0; i < kMotions.size(); ++i)
    for (const QString& word : fields[static_cast<int>(i)].split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
      const auto gesture = gestureFromText(word);
      if (!gesture) return std::nullopt;
      navigation.of(kMotions[i]).push_back(*gesture);
    }
  navigation.wheel_turns = fields[3].contains("wheel_turns");
  navigation.wheel_reversed = fields[3].contains("wheel_reversed");
  navigation.zoom_to_pointer = fields[3].contains("zoom_to_pointer");
  return navigation;
}

}  // namespace hapticell::app
