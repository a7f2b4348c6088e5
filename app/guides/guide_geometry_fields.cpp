// SPDX-License-Identifier: Apache-2.0
#include "app/guides/guide_geometry_fields.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "app/guides/guide_making.h"
#include "app/guides/guide_row.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/kit/form.h"

namespace hapticell::app {
namespace {

QPushButton* guideButton(const char* name, const QString& text, const QString& tip = {}) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  return button;
}

QLineEdit* makeShown(const char* name) {
  auto* line = new QLineEdit;
  line->setObjectName(name);
  line->setReadOnly(true);
  line->setFocusPolicy(Qt::NoFocus);
  return line;
}

}  // namespace

GuideGeometryFields::GuideGeometryFields(Host& host, QVBoxLayout& column, GuideEdit edit, QObject* parent)
    : QObject(parent), host_(host), edit_(std::move(edit)) {
  QVBoxLayout* section = addSection(column, {});
  name_ = new QLineEdit;
  name_->setObjectName("fieldGuideName");
  addRow(*section, tr("Name"), name_);
  entity_ = new QComboBox;
  entity_->setObjectName("comboGuided");
  addRow(*section, tr("Entity"), entity_);
  geometry_ = makeShown("fieldGeometry");
  pick_ = guideButton("buttonPickGeometry", tr("Pick"));
  addRow(*section, tr("Geometry"), guideRow(geometry_, {pick_}));
  path_ = guideButton("buttonPath", tr("From a recording…"), tr("The path of a recorded motion, simplified"));
  path_row_ = addRow(*section, {}, path_);
  reverse_ = guideButton("buttonReverse", tr("Flip"), tr("Flip the axis or normal"));
  place_ = guideButton("buttonPlace", tr("Move to entity"),
                       tr("Moves the guide to the handle of the entity; its direction stays"));
  addRow(*section, {}, sideBySide({reverse_, place_}));
  handle_ = makeShown("fieldHandle");
  handle_pick_ = guideButton("buttonPickHandle", tr("Pick"), tr("Point at which the hand holds the entity"));
  addRow(*section, tr("Handle at"), guideRow(handle_, {handle_pick_}));
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const QString name = name_->text().trimmed();
    if (!name.isEmpty() && name.toStdString() != shown_.name)
      edit_([&](workcell::Guide& guide) { guide.name = name.toStdString(); });
    if (!name_->hasFocus()) name_->setText(QString::fromStdString(shown_.name));
  });
  connect(entity_, &QComboBox::activated, this,
          [this] { edit_([this](workcell::Guide& guide) { guide.entity = entity_->currentText().toStdString(); }); });
  connect(pick_, &QPushButton::clicked, this, &GuideGeometryFields::pickWanted);
  connect(path_, &QPushButton::clicked, this, &GuideGeometryFields::pathWanted);
  connect(reverse_, &QPushButton::clicked, this, &GuideGeometryFields::reverseWanted);
  connect(place_, &QPushButton::clicked, this, &GuideGeometryFields::placeWanted);
  connect(handle_pick_, &QPushButton::clicked, this, &GuideGeometryFields::handlePickWanted);
}

void GuideGeometryFields::show(const workcell::Guide& guide) {
  shown_ = guide;
  if (!name_->hasFocus()) name_->setText(QString::fromStdString(guide.name));
  entity_->clear();
  for (const auto& entity : host_.documentModel().document().state().entities)
    if (canBeGuided(*entity)) entity_->addItem(QString::fromStdString(entity->name));
  entity_->setCurrentText(QString::fromStdString(guide.entity));
  geometry_->setText(geometryText(guide));
  geometry_->setCursorPosition(0);
  geometry_->setToolTip(geometry_->text());
  const HoldChoice& hold = host_.holdChoice();
  handle_->setText(hold.is<by::Frame>() ? QString::fromStdString(hold.frame()) : tr("where it is held"));
  path_row_->setVisible(guide.kind == workcell::GuideKind::kTube);
}

}  // namespace hapticell::app
