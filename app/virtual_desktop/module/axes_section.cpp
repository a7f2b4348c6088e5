// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/axes_section.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "app/controls/entity_icon.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/viewport/scene/strip_text.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {

AxesSection::AxesSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), host_(host), controller_(controller) {
  using manipulation::AxesMode;
  QVBoxLayout* section = addSection(column, tr("Axes and scale"));
  axes_ = new Segmented({tr("Screen"), tr("Cell"), tr("Frame")});
  axes_->setObjectName("segmentsAxes");
  addRow(*section, tr("Axes"), axes_);
  axes_frame_ = new QComboBox;
  axes_frame_->setObjectName("comboAxesFrame");
  axes_frame_row_ = addRow(*section, {}, axes_frame_);
  const char* const names[]{"X", "Y", "Z", "A", "B", "C"};
  Segmented* const groups[]{new Segmented({"X", "Y", "Z"}, nullptr, Segmented::Kind::kMany),
                            new Segmented({"A", "B", "C"}, nullptr, Segmented::Kind::kMany)};
  for (std::size_t i = 0; i < 6; ++i) {
    const QString axis = QString::fromLatin1(names[i % 3]);
    free_[i] = groups[i / 3]->button(static_cast<int>(i % 3));
    const QString tip = i < 3 ? tr("Allow motion along %1 (%1: only this axis)").arg(axis)
                              : tr("Allow rotation about %1 (%1 twice: only this axis)").arg(axis);
    free_[i]->setToolTip(tip);
    free_[i]->setAccessibleName(tip);
    free_[i]->setObjectName(QStringLiteral("free") + QString::fromLatin1(names[i]));
  }
  addRow(*section, tr("Free to move"), sideBySide({groups[0], groups[1]}));
  scale_ = new Segmented({tr("Rough"), tr("Medium"), tr("Fine"), tr("Screen")});
  scale_->setObjectName("segmentsScale");
  addRow(*section, tr("Scale"), scale_);
  scale_note_ = makeLabel({}, TextRole::kSecond, true);
  scale_note_->setObjectName("labelScale");
  scale_note_->setContentsMargins(kLabelColumn, 2, 0, 2);
  section->addWidget(scale_note_);
  connect(axes_, &Segmented::chosen, this, [this](int index) {
    controller_.edit([&](VirtualDesktopSettings& settings) {
      constexpr AxesMode kModes[]{AxesMode::kScreen, AxesMode::kCell, AxesMode::kFrame};
      settings.axes = kModes[index];
      settings.axes_frame = index == 2 ? axes_frame_->currentText().toStdString() : std::string();
    });
  });
  connect(axes_frame_, &QComboBox::activated, this, [this] {
    controller_.edit(
        [&](VirtualDesktopSettings& settings) { settings.axes_frame = axes_frame_->currentText().toStdString(); });
  });
  connect(scale_, &Segmented::chosen, this, [this](int index) {
    controller_.edit(
        [&](VirtualDesktopSettings& settings) { settings.scale = static_cast<manipulation::ScaleLevel>(index); });
  });
  for (Segmented* group : groups)
    connect(group, &Segmented::chosen, this, [this] {
      controller_.edit([&](VirtualDesktopSettings& settings) {
        for (std::size_t i = 0; i < 3; ++i) {
          settings.free.moves[i] = free_[i]->isChecked();
          settings.free.turns[i] = free_[i + 3]->isChecked();
        }
      });
    });
}

void AxesSection::listFrames() {
  axes_frame_->clear();
  for (const auto& other : host_.documentModel().document().state().entities)
    axes_frame_->addItem(icon(entityIcon(*other)), QString::fromStdString(other->name));
  axes_frame_->setCurrentText(QString::fromStdString(controller_.settings().axes_frame));
}

void AxesSection::showSettings() {
  const VirtualDesktopSettings& settings = controller_.settings();
  listFrames();
  axes_frame_row_->setVisible(settings.axes == manipulation::AxesMode::kFrame);
  axes_->setCurrent(static_cast<int>(settings.axes));
  scale_->setCurrent(static_cast<int>(settings.scale));
  for (std::size_t i = 0; i < 6; ++i) free_[i]->setChecked(i < 3 ? settings.free.moves[i] : settings.free.turns[i - 3]);
}

void AxesSection::showScale() {
  scale_note_->setText(scaleNote(controller_.snapshot().stylus.motion_scale));
}

}  // namespace hapticell::app
