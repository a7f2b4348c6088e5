// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/pair_set_editor.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/kit/swatch_row.h"
#include "app/kit/switch_list.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

constexpr int kSetLabels = 92;

/// A set's own colours stay in the family of their state: contacts dark and warm, near misses light.
std::vector<QColor> contactColors() {
  return {QColor("#FF6A45"), QColor("#E0306B"), QColor("#C026A8"), QColor("#8E4BE0")};
}
std::vector<QColor> nearMissColors() {
  return {QColor("#FFDD66"), QColor("#FFB02E"), QColor("#E9E2C0"), QColor("#BFE3FF")};
}

QColor colorOr(const std::optional<std::array<float, 3>>& own, const QColor& otherwise) {
  return own ? QColor::fromRgbF((*own)[0], (*own)[1], (*own)[2]) : otherwise;
}

}  // namespace

PairSetEditor::PairSetEditor(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setFixedWidth(260);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 8, 0, 0);
  outer->setSpacing(6);
  addHeader(*outer);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 8);
  column->setSpacing(6);
  sets_ = new SwitchList(tr("Everything against everything"));
  sets_->setAccessibleName(tr("Pair sets"));
  sets_->setObjectName("pairSets");
  column->addWidget(sets_);
  addFields(*column);
  column->addStretch(1);
  scroll->setWidget(content);
  outer->addWidget(scroll, 1);
  connect(sets_, &SwitchList::chosen, this, [this] {
    showSet();
    emit chosen(current());
  });
  connect(sets_, &SwitchList::switched, this, [this](int, bool on) { edit([on](auto& set) { set.enabled = on; }); });
  connect(sets_, &SwitchList::renamed, this, [this](int index, const QString& name) {
    sets_->setCurrent(index);
    edit([&name](auto& set) { set.name = name.toStdString(); });
  });
  connect(&host_.documentModel(), &DocumentModel::changed, this, &PairSetEditor::showSets);
  showSets();
}

void PairSetEditor::addHeader(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(12, 0, 8, 0);
  row->setSpacing(4);
  row->addWidget(makeLabel(tr("Sets"), TextRole::kSection, true), 1);
  const auto button = [row](const char* name, const char* picture, const QString& tip) {
    auto* made = new QPushButton(icon(picture), {});
    made->setObjectName(name);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setFlat(true);
    made->setFixedSize(24, 24);
    row->addWidget(made);
    return made;
  };
  add_ = button("buttonAddSet", "plus", tr("New pair set"));
  remove_ = button("buttonRemoveSet", "delete", tr("Remove the pair set"));
  column.addLayout(row);
  connect(add_, &QPushButton::clicked, this, &PairSetEditor::addSet);
  connect(remove_, &QPushButton::clicked, this, &PairSetEditor::removeSet);
}

void PairSetEditor::addFields(QVBoxLayout& column) {
  fields_ = new QWidget;
  auto* fields = new QVBoxLayout(fields_);
  fields->setContentsMargins(12, 6, 12, 0);
  fields->setSpacing(6);
  heading_ = makeLabel({}, TextRole::kSection, true);
  fields->addWidget(heading_);
  near_miss_ = new ValueField({tr("mm"), 1, 0.0, 1000.0, 1.0});
  near_miss_->setObjectName("fieldNearMiss");
  near_miss_->setToolTip(tr("Below this distance: shown and heard, not felt"));
  safety_ = new ValueField({tr("mm"), 2, 0.0, 1000.0, 0.1});
  safety_->setObjectName("fieldSafety");
  safety_->setToolTip(tr("Contact is felt at this distance"));
  on_contact_ = new QComboBox;
  on_contact_->setObjectName("comboSetOnContact");
  on_contact_->addItems({tr("As for the entity"), tr("Stop"), tr("Slide"), tr("Pass")});
  near_miss_color_ = new SwatchRow(nearMissColors());
  near_miss_color_->setObjectName("swatchNearMiss");
  contact_color_ = new SwatchRow(contactColors());
  contact_color_->setObjectName("swatchContact");
  name_ = new QLineEdit;
  name_->setObjectName("fieldSetName");
  addRow(*fields, tr("Near miss"), near_miss_, kSetLabels);
  addRow(*fields, tr("Safety distance"), safety_, kSetLabels);
  addRow(*fields, tr("On contact"), on_contact_, kSetLabels);
  addRow(*fields, tr("Near-miss colour"), near_miss_color_, kSetLabels);
  addRow(*fields, tr("Contact colour"), contact_color_, kSetLabels);
  addRow(*fields, tr("Name"), name_, kSetLabels);
  column.addWidget(fields_);
  connect(near_miss_, &ValueField::edited, this,
          [this](double mm) { edit([mm](auto& set) { set.near_miss = mm / 1000.0; }); });
  connect(safety_, &ValueField::edited, this,
          [this](double mm) { edit([mm](auto& set) { set.safety_distance = mm / 1000.0; }); });
  connect(near_miss_color_, &SwatchRow::chosen, this,
          [this](const QColor& color) { edit([&](auto& set) { set.near_miss_color = channelsOf(color); }); });
  connect(contact_color_, &SwatchRow::chosen, this,
          [this](const QColor& color) { edit([&](auto& set) { set.contact_color = channelsOf(color); }); });
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const QString name = name_->text().trimmed();
    if (const workcell::PairSet* set = currentSet();
        set && !name.isEmpty() && name != QString::fromStdString(set->name))
      edit([&](auto& changed) { changed.name = name.toStdString(); });
    showSet();
  });
  connect(on_contact_, &QComboBox::activated, this, [this](int index) {
    edit([index](auto& set) {
      set.on_contact = index == 0 ? std::nullopt : std::optional(static_cast<workcell::OnContact>(index - 1));
    });
  });
}

const workcell::PairSet* PairSetEditor::currentSet() const {
  const auto& sets = host_.documentModel().document().state().pair_sets;
  const int index = sets_->current();
  return index >= 0 && index < static_cast<int>(sets.size()) ? &sets[static_cast<std::size_t>(index)] : nullptr;
}

QString PairSetEditor::current() const {
  const workcell::PairSet* set = currentSet();
  return set ? QString::fromStdString(set->name) : QString();
}

void PairSetEditor::addSet() {
  const workcell::DocumentState& state = host_.documentModel().document().state();
  const auto& defaults = host_.configuration().manipulation;
  workcell::PairSet set;
  set.safety_distance = defaults.safety_distance;
  set.near_miss = defaults.near_miss;
  // The first set is what was checked without any, so that nothing is unchecked by making one.
  set.name = state.pair_sets.empty() ? tr("Everything").toStdString() : std::string();
  for (std::size_t n = state.pair_sets.size() + 1; set.name.empty() || state.findPairSet(set.name); ++n)
    set.name = tr("Set %1").arg(n).toStdString();
  if (!state.pair_sets.empty())
    if (const workcell::Entity* selected = state.find(host_.selection().current())) set.first = {selected->name};
  if (!host_.documentModel().execute(workcell::AddPairSet{std::move(set)})) return;
  sets_->setCurrent(static_cast<int>(state.pair_sets.size()) - 1);
  emit chosen(current());
}

void PairSetEditor::removeSet() {
  if (const workcell::PairSet* set = currentSet()) host_.documentModel().execute(workcell::RemovePairSet{set->name});
}

void PairSetEditor::showSets() {
  std::vector<SwitchList::Row> rows;
  for (const workcell::PairSet& set : host_.documentModel().document().state().pair_sets)
    rows.push_back({QString::fromStdString(set.name), set.enabled});
  sets_->setRows(std::move(rows));
  showSet();
  emit chosen(current());
}

void PairSetEditor::showSet() {
  const workcell::PairSet* set = currentSet();
  fields_->setVisible(set);
  remove_->setEnabled(set);
  if (!set) return;
  const Theme& theme = themeOf(palette());
  const QString name = QString::fromStdString(set->name);
  heading_->setText(tr("Set: %1").arg(name));
  if (!near_miss_->hasFocus()) near_miss_->setValue(1000.0 * set->near_miss);
  if (!safety_->hasFocus()) safety_->setValue(1000.0 * set->safety_distance);
  if (!name_->hasFocus()) name_->setText(name);
  near_miss_color_->setCurrent(colorOr(set->near_miss_color, theme.near_miss));
  contact_color_->setCurrent(colorOr(set->contact_color, theme.contact));
  on_contact_->setCurrentIndex(set->on_contact ? 1 + static_cast<int>(*set->on_contact) : 0);
}

void PairSetEditor::edit(const std::function<void(workcell::PairSet&)>& change) {
  const workcell::PairSet* set = currentSet();
  if (!set) return;
  workcell::PairSet fresh = *set;
  change(fresh);
  if (!host_.documentModel().execute(workcell::EditPairSet{set->name, fresh})) showSet();
}

void PairSetEditor::setAlerts(const std::map<QString, int>& alerts) {
  sets_->setAlerts(alerts);
}

}  // namespace hapticell::app
