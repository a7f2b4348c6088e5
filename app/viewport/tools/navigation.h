// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <Qt>
#include <optional>
#include <vector>

namespace hapticell::app {

/// What a drag does to the camera.
enum class ViewMotion { kOrbit, kPan, kZoom };

/// Buttons and modifiers held together. `chord`: the last button is pressed (and, with `released`, released again)
/// while the first is held, as in CATIA: `buttons` are then those still down.
struct ViewGesture {
  Qt::MouseButtons buttons;
  Qt::KeyboardModifiers modifiers;
  bool released = false;  ///< Only after another button was pressed and released while these stayed down.
  bool operator==(const ViewGesture&) const = default;
};

/// How mouse and touchpad move the camera: a value, from a preset or the user's own.
struct Navigation {
  std::vector<ViewGesture> orbit, pan, zoom;
  bool wheel_turns = false;  ///< Two fingers on a touchpad turn the view (Shift: pan, Ctrl: zoom) instead of zooming.
  bool wheel_reversed = false;
  bool zoom_to_pointer = true;  ///< False: towards the middle of the view.
  bool operator==(const Navigation&) const = default;

  const std::vector<ViewGesture>& of(ViewMotion motion) const;
  std::vector<ViewGesture>& of(ViewMotion motion);
  /// What these held buttons do; empty: nothing, so picking and tools may use them.
  std::optional<ViewMotion> motionFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers,
                                      bool after_release = false) const;
  /// True if a press of this button alone (with these modifiers) begins or may begin a motion.
  bool uses(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const;
};

/// Names of the presets: "hapticell", "catia", "solidworks", "nx", "freecad", "rviz", "blender", "touchpad".
const std::vector<QString>& navigationPresets();
/// "Middle button turns", "CATIA" ...
QString navigationPresetName(const QString& preset);
/// The preset of that name; "hapticell" for an unknown name.
Navigation navigationPreset(const QString& preset);

/// "Shift+Middle"; for menus, hints and settings (with `for_file`, in English).
QString gestureText(const ViewGesture& gesture, bool for_file = false);
/// Reads gestureText(…, true); empty if the text is invalid.
std::optional<ViewGesture> gestureFromText(const QString& text);

/// Converts all of it to one line for the settings, and back; empty if the line is invalid.
QString navigationText(const Navigation& navigation);
std::optional<Navigation> navigationFromText(const QString& text);

}  // namespace hapticell::app
