// SPDX-License-Identifier: Apache-2.0
#include "app/controls/frame_fields.h"

#include <QComboBox>
#include <QObject>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/controls/entity_icon.h"
#include "app/kit/form.h"
#include "app/style/icon.h"

namespace hapticell::app {
namespace {

constexpr int kFrameLabel = 68;  // As the rows around it.

}  // namespace

std::vector<FrameCarrier> frameCarriers(const workcell::DocumentState& state, workcell::EntityId frame) {
  std::vector<FrameCarrier> carriers{{QObject::tr("World"), 0}};
  for (const auto& entity : state.entities) {
    // An assembly has no place of its own; a mannequin's segments are no links that users know.
    const bool carries = entity->kind() != workcell::EntityKind::kAssembly && !entity->figure() && !entity->unloaded;
    if (!carries || workcell::isCarriedBy(state, *entity, frame)) continue;
    const QString name = QString::fromStdString(entity->name);
    if (!entity->robot()) {
      carriers.push_back({name, entity->id});
      continue;
    }
    for (const auto& link : entity->robot()->links)
      carriers.push_back({name + QStringLiteral(" · ") + QString::fromStdString(link.name), entity->id, link.name});
  }
  return carriers;
}

FrameFields::FrameFields(Host& host, QWidget* parent) : QWidget(parent), host_(host), carrier_(new QComboBox) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  carrier_->setObjectName("comboFrameCarrier");
  carrier_->setToolTip(tr("The frame keeps its current placement and moves with it"));
  addRow(*rows, tr("Fixed to"), carrier_, kFrameLabel);
  connect(carrier_, &QComboBox::activated, this, &FrameFields::choose);
}

void FrameFields::showFrame(const workcell::Entity& entity) {
  const bool frame = entity.kind() == workcell::EntityKind::kFrame;
  setVisible(frame);
  id_ = frame ? entity.id : 0;
  if (!frame) return;
  const workcell::DocumentState& state = host_.documentModel().document().state();
  auto carriers = frameCarriers(state, entity.id);
  if (carriers != carriers_ || carrier_->count() == 0) {
    carriers_ = std::move(carriers);
    carrier_->clear();
    for (const FrameCarrier& carrier : carriers_) {
      const workcell::Entity* to = state.find(carrier.to);
      carrier_->addItem(icon(to ? entityIcon(*to) : "cell"), carrier.name);
    }
  }
  now_ = 0;
  for (std::size_t k = 0; k < carriers_.size(); ++k) {
    const workcell::Entity* to = state.find(carriers_[k].to);
    if (to && to->name == entity.attachment.to && (!to->robot() || carriers_[k].link == entity.attachment.link))
      now_ = static_cast<int>(k);
  }
  carrier_->setCurrentIndex(now_);
}

void FrameFields::choose(int index) {
  if (id_ == 0 || index == now_ || index < 0 || index >= static_cast<int>(carriers_.size())) return;
  const FrameCarrier carrier = carriers_[static_cast<std::size_t>(index)];
  if (carrier.to == 0)
    host_.documentModel().execute(workcell::Detach{id_});
  else
    host_.documentModel().execute(workcell::Attach{id_, carrier.to, carrier.link});
}

}  // namespace hapticell::app
