// SPDX-License-Identifier: Apache-2.0
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <array>

#include "app/host/host.h"
#include "app/host/user_settings.h"
#include "app/kit/form.h"
#include "app/settings/gesture_field.h"
#include "app/settings/settings_pages.h"
#include "app/settings/user_choices.h"

namespace hapticell::app {
namespace {

/// Presets, and what each motion is made by.
class NavigationPage : public QWidget {
 public:
  explicit NavigationPage(Host& host) : settings_(host.userSettings()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    addPresets(*column);
    addSwitches(*column);
    column->addStretch(1);
    show();
  }

 private:
  void addPresets(QVBoxLayout& column) {
    QVBoxLayout* section = addSection(column, tr("Mouse and view"));
    preset_ = new QComboBox;
    preset_->setObjectName("comboNavigation");
    for (const QString& key : navigationPresets()) preset_->addItem(navigationPresetName(key), key);
    preset_->addItem(tr("Custom"), "own");
    addRow(*section, tr("Preset"), preset_);
    connect(preset_, &QComboBox::activated, this, [this](int index) {
      if (preset_->itemData(index).toString() == QLatin1String("own")) return change(navigationFrom(settings_));
      settings_.setValue("navigation/preset", preset_->itemData(index));
      show();
    });
    const std::array<QString, 3> names{tr("Rotate"), tr("Pan"), tr("Zoom")};
    for (std::size_t i = 0; i < 3; ++i) {
      fields_[i] = new GestureField;
      fields_[i]->setObjectName(QStringLiteral("fieldGesture%1").arg(i));
      addRow(*section, names[i], fields_[i]);
      const auto motion = static_cast<ViewMotion>(i);
      connect(fields_[i], &GestureField::recorded, this,
              [this, motion](const ViewGesture& gesture) { bind(motion, gesture); });
    }
    note_ = makeLive(2, TextRole::kSecond, true);
    note_->setObjectName("labelGesture");
    section->addWidget(note_);
  }

  /// A gesture means one thing: what had it before loses it.
  void bind(ViewMotion motion, const ViewGesture& gesture) {
    Navigation own = navigationFrom(settings_);
    for (const ViewMotion other : {ViewMotion::kOrbit, ViewMotion::kPan, ViewMotion::kZoom})
      std::erase(own.of(other), gesture);
    own.of(motion) = {gesture};
    change(own);
  }

  void addSwitches(QVBoxLayout& column) {
    QVBoxLayout* section = addSection(column, tr("Wheel and touchpad"));
    const auto add = [&](const QString& text, const char* name, bool Navigation::*what) {
      auto* box = new QCheckBox(text);
      box->setMinimumHeight(26);
      box->setObjectName(QLatin1String(name));
      section->addWidget(box);
      connect(box, &QCheckBox::clicked, this, [this, what](bool on) {
        Navigation own = navigationFrom(settings_);
        own.*what = on;
        change(own);
      });
      return box;
    };
    pointer_ = add(tr("Zoom to the pointer"), "switchZoomPointer", &Navigation::zoom_to_pointer);
    reversed_ = add(tr("Invert the wheel"), "switchWheelReversed", &Navigation::wheel_reversed);
    turns_ = add(tr("Two fingers rotate; with Shift they pan, with Ctrl they zoom"), "switchWheelTurns",
                 &Navigation::wheel_turns);
  }

  void change(const Navigation& navigation) {
    settings_.setValue("navigation/own", navigationText(navigation));
    settings_.setValue("navigation/preset", "own");
    show();
  }

  void show() {
    const Navigation now = navigationFrom(settings_);
    preset_->setCurrentIndex(preset_->findData(settings_.value("navigation/preset", "hapticell")));
    for (std::size_t i = 0; i < 3; ++i) fields_[i]->setGestures(now.of(static_cast<ViewMotion>(i)));
    pointer_->setChecked(now.zoom_to_pointer);
    reversed_->setChecked(now.wheel_reversed);
    turns_->setChecked(now.wheel_turns);
    const bool left = now.uses(Qt::LeftButton, Qt::NoModifier);
    note_->setText(left ? tr("A left click still selects; Ctrl and a left drag draw a selection box.")
                        : tr("The left button is free: click to select, drag to draw a selection box."));
  }

  UserSettings& settings_;
  QComboBox* preset_;
  std::array<GestureField*, 3> fields_{};
  QLabel* note_;
  QCheckBox *pointer_, *reversed_, *turns_;
};

}  // namespace

QWidget* makeNavigationPage(Host& host) {
  return new NavigationPage(host);
}

}  // namespace hapticell::app
