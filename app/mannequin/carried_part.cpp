// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/carried_part.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/mannequin/mannequin_context.h"

namespace hapticell::app {
namespace {

/// What a hand may take, likely things first: what it has, then what may be moved, then what is locked.
std::vector<const workcell::Entity*> solidsToTake(const workcell::DocumentState& state, const std::string& carrier) {
  std::vector<const workcell::Entity*> solids;
  for (const auto& one : state.entities)
    if (one->mesh()) solids.push_back(one.get());
  const auto rest = std::stable_partition(
      solids.begin(), solids.end(), [&](const workcell::Entity* solid) { return solid->attachment.to == carrier; });
  std::stable_partition(rest, solids.end(), [](const workcell::Entity* solid) { return !solid->locked; });
  return solids;
}

}  // namespace

CarriedPart::CarriedPart(MannequinContext& context, QVBoxLayout& section, QObject* parent)
    : QObject(parent), context_(context) {
  part_ = new QComboBox;
  part_->setObjectName("comboCarried");
  part_->setMinimumWidth(60);
  part_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  carry_ = new QPushButton;
  carry_->setObjectName("buttonCarry");
  auto* pair = new QWidget;
  auto* line = new QHBoxLayout(pair);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(part_, 1);
  line->addWidget(carry_);
  addRow(section, tr("In the hand"), pair);
  connect(carry_, &QPushButton::clicked, this, &CarriedPart::carryWanted);
  connect(part_, &QComboBox::activated, this, [this] {
    part_chosen_ = true;
    show();
  });
}

workcell::EntityId CarriedPart::chosen() const {
  return part_->currentData().toULongLong();
}

void CarriedPart::show() {
  const workcell::Entity* entity = context_.entity();
  if (!entity) return;
  const auto solids = solidsToTake(context_.host().documentModel().document().state(), entity->name);
  bool same = part_->count() == static_cast<int>(solids.size());
  for (std::size_t i = 0; same && i < solids.size(); ++i)
    same = part_->itemData(static_cast<int>(i)).toULongLong() == solids[i]->id &&
           part_->itemText(static_cast<int>(i)).toStdString() == solids[i]->name;
  if (!same) {
    const qulonglong before = part_chosen_ ? part_->currentData().toULongLong() : 0;
    part_->clear();
    for (const workcell::Entity* solid : solids)
      part_->addItem(QString::fromStdString(solid->name), static_cast<qulonglong>(solid->id));
    part_->setCurrentIndex(std::max(0, part_->findData(before)));
  }
  const workcell::Entity* part = context_.host().documentModel().document().find(chosen());
  const bool carried = part && part->attachment.to == entity->name;
  carry_->setText(carried ? tr("Release") : tr("Hold"));
  carry_->setToolTip(carried ? tr("It stays where it is") : tr("It moves with the hand and is checked with it"));
  carry_->setEnabled(part != nullptr && context_.isFree());
}

}  // namespace hapticell::app
