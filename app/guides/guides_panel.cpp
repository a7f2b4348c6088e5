// SPDX-License-Identifier: Apache-2.0
// How the panel is put together; what it does stands in guides_panel_edit.cpp.
#include "app/guides/guides_panel.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/guides/guide_fields.h"
#include "app/guides/guide_geometry_fields.h"
#include "app/guides/guide_making.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/kit/switch_list.h"
#include "app/style/icon.h"

namespace hapticell::app {
GuidesPanel::GuidesPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addList(*column);
  addKinds(*column);
  editor_ = new QWidget;
  auto* editor = new QVBoxLayout(editor_);
  editor->setContentsMargins(0, 0, 0, 0);
  editor->setSpacing(0);
  const GuideEdit editing = [this](const std::function<void(workcell::Guide&)>& change) { edit(change); };
  geometry_ = new GuideGeometryFields(host_, *editor, editing, this);
  fields_ = new GuideFields(*editor, editing, this);
  connectGeometry();
  column->addWidget(editor_);
  column->addStretch(1);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] { current_.clear(); });
  connect(&host_.documentModel(), &DocumentModel::changed, this, &GuidesPanel::show);
  connect(&host_.selection(), &Selection::changed, this, &GuidesPanel::show);
  show();
}

void GuidesPanel::addList(QVBoxLayout& column) {
  list_ = new SwitchList(tr("No guides yet"));
  list_->setObjectName("listGuides");
  list_->setAccessibleName(tr("Guides"));
  column.addSpacing(8);
  column.addWidget(list_);
  QVBoxLayout* section = addSection(column, {});
  new_ = makeButton("buttonNewGuide", tr("New guide"), tr("Choose a type below, then pick its geometry in the scene"));
  new_->setProperty("main", true);
  remove_ = makeButton("buttonRemoveGuide", tr("Remove"));
  section->addWidget(sideBySide({new_, remove_}));
  auto* words = makeLabel(tr("A guide keeps what you move on a line, a plane, a hinge and so on. Select an entity, "
                             "choose a type, then pick an edge or a face."),
                          TextRole::kSecond, true);
  words->setWordWrap(true);
  empty_ = words;
  section->addWidget(words);
  connect(list_, &SwitchList::chosen, this, [this](int index) {
    const auto& guides = host_.documentModel().document().state().guides;
    if (index >= 0 && index < static_cast<int>(guides.size()))
      choose(QString::fromStdString(guides[static_cast<std::size_t>(index)].name));
  });
  connect(list_, &SwitchList::switched, this,
          [this](int, bool on) { edit([on](auto& guide) { guide.enabled = on; }); });
  connect(list_, &SwitchList::renamed, this, [this](int index, const QString& name) {
    list_->setCurrent(index);
    edit([&name](auto& guide) { guide.name = name.toStdString(); });
    show();
  });
  connect(new_, &QPushButton::clicked, this, &GuidesPanel::startNew);
  connect(remove_, &QPushButton::clicked, this, &GuidesPanel::removeGuide);
}

void GuidesPanel::addKinds(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Type"));
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  kinds_ = new QButtonGroup(this);
  int place = 0;
  for (const workcell::GuideKind kind : guideKinds()) {
    const QString name = QString::fromStdString(guideKindName(kind));
    auto* button = new QToolButton;
    button->setObjectName("kind" + name);
    button->setIcon(icon("guide_" + name.toLower()));
    button->setIconSize(QSize(22, 22));
    button->setText(tr(name.toLatin1().constData()));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFixedHeight(50);
    kinds_->addButton(button, static_cast<int>(kind));
    grid->addWidget(button, place / 5, place % 5);
    ++place;
  }
  kinds_->button(static_cast<int>(wanted_))->setChecked(true);
  section->addLayout(grid);
  connect(kinds_, &QButtonGroup::idClicked, this, [this](int id) { chooseKind(static_cast<workcell::GuideKind>(id)); });
}

void GuidesPanel::connectGeometry() {
  connect(geometry_, &GuideGeometryFields::pickWanted, this, [this] {
    if (const workcell::Guide* now = guide()) pickGeometry(now->kind, false);
  });
  connect(geometry_, &GuideGeometryFields::pathWanted, this, &GuidesPanel::takePath);
  connect(geometry_, &GuideGeometryFields::reverseWanted, this, &GuidesPanel::reverseAxis);
  connect(geometry_, &GuideGeometryFields::placeWanted, this, &GuidesPanel::placeAtEntity);
  connect(geometry_, &GuideGeometryFields::handlePickWanted, this, &GuidesPanel::pickHandle);
}

}  // namespace hapticell::app
