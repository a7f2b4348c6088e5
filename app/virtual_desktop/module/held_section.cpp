// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/held_section.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "app/controls/entity_icon.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {
namespace {

using manipulation::isSameWay;
using manipulation::MovedBy;

/// In the order of the segments.
std::array<MovedBy, 10> waysOffered() {
  using mannequin::Side;
  return {by::Tool{},      by::Base{},  by::Origin{},          by::Center{},
          by::Frame{},     by::Whole{}, by::Hand{Side::kLeft}, by::Hand{Side::kRight},
          by::BothHands{}, by::Head{}};
}

void showMoved(Segmented& moved_by, const VirtualDesktopSettings& settings, const workcell::Entity* entity) {
  constexpr int kTool = 0, kOrigin = 2, kWhole = 5;  // Among the ways offered.
  const bool mannequin = entity && entity->kind() == workcell::EntityKind::kMannequin;
  const bool robot = entity && entity->robot() && !mannequin;
  for (int i = 0; i < 4; ++i) moved_by.button(i)->setVisible(!entity || (!mannequin && (i < 2) == robot));
  moved_by.button(4)->setVisible(!mannequin);
  for (int i = 5; i < 10; ++i) moved_by.button(i)->setVisible(mannequin);
  const auto ways = waysOffered();
  const auto chosen =
      std::find_if(ways.begin(), ways.end(), [&](const MovedBy& way) { return isSameWay(way, settings.moved_by); });
  int usual = entity ? kOrigin : -1;
  if (robot) usual = kTool;
  if (mannequin) usual = kWhole;
  moved_by.setCurrent(chosen == ways.end() ? usual : static_cast<int>(chosen - ways.begin()));
}

}  // namespace

HeldSection::HeldSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), host_(host), controller_(controller) {
  QVBoxLayout* section = addSection(column, tr("Held entity"));
  entity_ = new QComboBox;
  entity_->setObjectName("comboEntity");
  addRow(*section, tr("Entity"), entity_);
  moved_by_ = new Segmented({tr("TCP"), tr("Base"), tr("Origin"), tr("Centre"), tr("Frame"), tr("Whole"), tr("Left"),
                             tr("Right"), tr("Both"), tr("Head")});
  moved_by_->setObjectName("segmentsMovedBy");
  addRow(*section, tr("Moved by"), moved_by_);
  moved_frame_ = new QComboBox;
  moved_frame_row_ = addRow(*section, {}, moved_frame_);
  against_ = new QComboBox;
  against_->setObjectName("comboAgainst");
  addRow(*section, tr("Against"), against_);
  on_contact_ = new Segmented({tr("Stop"), tr("Slide"), tr("Pass")});
  on_contact_->setObjectName("segmentsOnContact");
  addRow(*section, tr("On contact"), on_contact_);
  connect(entity_, &QComboBox::activated, this, [this](int index) {
    controller_.edit([&](VirtualDesktopSettings& settings) {
      settings.entity = entity_->itemData(index).toULongLong();
      const workcell::Entity* entity = host_.documentModel().document().find(settings.entity);
      settings.moved_by = entity ? HoldChoice::usual(*entity) : MovedBy();
      if (entity) settings.on_contact = entity->contact.on_contact, settings.force_class = entity->contact.force_class;
      if (entity) host_.selection().set(entity->id);
    });
  });
  connect(moved_by_, &Segmented::chosen, this, [this](int index) {
    controller_.edit([&](VirtualDesktopSettings& settings) {
      settings.moved_by = waysOffered()[static_cast<std::size_t>(index)];
      if (auto* frame = std::get_if<by::Frame>(&settings.moved_by))
        frame->name = moved_frame_->currentText().toStdString();
    });
  });
  connect(moved_frame_, &QComboBox::activated, this, [this] {
    controller_.edit([&](VirtualDesktopSettings& settings) {
      settings.moved_by = by::Frame{moved_frame_->currentText().toStdString()};
    });
  });
  connect(against_, &QComboBox::activated, this, [this](int index) {
    controller_.edit([&](VirtualDesktopSettings& settings) {
      settings.against = against_->itemData(index).toString().toStdString();
    });
  });
  connect(on_contact_, &Segmented::chosen, this,
          [this](int index) { controller_.setOnContact(static_cast<workcell::OnContact>(index)); });
}

void HeldSection::listEntities() {
  const workcell::EntityId chosen = controller_.settings().entity;
  entity_->clear();
  entity_->addItem(icon("hand"), tr("What the tip touches"), 0ULL);
  for (const auto& entity : host_.documentModel().document().state().entities) {
    if (entity->locked) continue;
    entity_->addItem(icon(entityIcon(*entity)), QString::fromStdString(entity->name),
                     static_cast<qulonglong>(entity->id));
    if (entity->id == chosen) entity_->setCurrentIndex(entity_->count() - 1);
  }
}

void HeldSection::listSets() {
  against_->clear();
  const auto& sets = host_.documentModel().document().state().pair_sets;
  const auto on = std::count_if(sets.begin(), sets.end(), [](const auto& set) { return set.enabled; });
  against_->addItem(sets.empty() ? tr("Everything") : tr("All active sets (%1)").arg(on), QString());
  for (const auto& set : sets) {
    const QString name = QString::fromStdString(set.name);
    against_->addItem(name, name);
  }
  against_->setCurrentIndex(std::max(0, against_->findData(QString::fromStdString(controller_.settings().against))));
}

void HeldSection::listFrames(const workcell::Entity* entity) {
  moved_frame_->clear();
  if (entity)
    for (const auto& frame : entity->frames) moved_frame_->addItem(icon("frame"), QString::fromStdString(frame.name));
  if (entity && entity->robot())
    for (const auto& link : entity->robot()->links)
      moved_frame_->addItem(icon("frame"), QString::fromStdString(link.name));
  moved_by_->setChoiceEnabled(4, moved_frame_->count() > 0, tr("This entity has no frames"));
  moved_frame_->setCurrentText(QString::fromStdString(manipulation::frameOf(controller_.settings().moved_by)));
}

void HeldSection::showSettings() {
  const VirtualDesktopSettings& settings = controller_.settings();
  const workcell::Entity* entity = host_.documentModel().document().find(settings.entity);
  listSets();
  listFrames(entity);
  showMoved(*moved_by_, settings, entity);
  moved_frame_row_->setVisible(std::holds_alternative<by::Frame>(settings.moved_by));
  on_contact_->setCurrent(static_cast<int>(settings.on_contact));
  const int index = entity_->findData(static_cast<qulonglong>(settings.entity));
  entity_->setCurrentIndex(index >= 0 ? index : 0);
}

}  // namespace hapticell::app
