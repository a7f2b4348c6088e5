// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/pair_columns.h"

#include <QDropEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/panels/tree/workcell_tree_model.h"
#include "app/style/icon.h"
#include "app/style/theme.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

NameList::NameList(QWidget* parent) : QListWidget(parent) {
  setSelectionMode(ExtendedSelection);
  setDragEnabled(true);
  setAcceptDrops(true);
  setDragDropMode(DragDrop);
}

void NameList::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Delete && event->key() != Qt::Key_Backspace) return QListWidget::keyPressEvent(event);
  QStringList names;
  for (const QListWidgetItem* item : selectedItems()) names << item->text();
  if (!names.isEmpty()) emit removed(names);
}

void NameList::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(WorkcellTreeModel::kNamesFormat) || event->source() != nullptr)
    event->acceptProposedAction();
}

void NameList::dragMoveEvent(QDragMoveEvent* event) {
  event->acceptProposedAction();
}

void NameList::dropEvent(QDropEvent* event) {
  QStringList names;
  if (event->mimeData()->hasFormat(WorkcellTreeModel::kNamesFormat)) {
    names = QString::fromUtf8(event->mimeData()->data(WorkcellTreeModel::kNamesFormat)).split('\n', Qt::SkipEmptyParts);
  } else if (const auto* other = qobject_cast<const NameList*>(event->source()); other && other != this) {
    for (const QListWidgetItem* item : other->selectedItems()) names << item->text();
  }
  // The lists follow the document; nothing is moved by the drag itself.
  event->setDropAction(Qt::CopyAction);
  event->accept();
  if (!names.isEmpty()) emit dropped(names);
}

void NameList::paintEvent(QPaintEvent* event) {
  QListWidget::paintEvent(event);
  if (count() > 0) return;
  QPainter painter(viewport());
  painter.setPen(themeOf(palette()).text2);
  painter.drawText(viewport()->rect().adjusted(12, 10, -12, -10), Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap,
                   tr("Everything. To narrow it down, drag entities here from the tree."));
}

PairColumns::PairColumns(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 0, 12, 8);
  row->setSpacing(12);
  row->addWidget(makeColumn(0), 1);
  auto* against = makeLabel(tr("against"), TextRole::kSecond, true);
  row->addWidget(against);
  row->addWidget(makeColumn(1), 1);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &PairColumns::show);
  connect(&host_.selection(), &Selection::changed, this, &PairColumns::show);
  show();
}

QWidget* PairColumns::makeColumn(int side) {
  const auto index = static_cast<std::size_t>(side);
  auto* holder = new QWidget;
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* list = lists_[index] = new NameList;
  list->setObjectName(side == 0 ? "listFirst" : "listSecond");
  list->setAccessibleName(side == 0 ? tr("First column") : tr("Second column"));
  column->addWidget(list, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(6);
  adds_[index] = new QPushButton(tr("Add selected"));
  adds_[index]->setObjectName(side == 0 ? "buttonAddFirst" : "buttonAddSecond");
  picks_[index] = new QPushButton(tr("Pick"));
  picks_[index]->setObjectName(side == 0 ? "buttonPickFirst" : "buttonPickSecond");
  picks_[index]->setToolTip(tr("Click entities in the scene; Esc: end"));
  removes_[index] = new QPushButton(tr("Remove"));
  removes_[index]->setObjectName(side == 0 ? "buttonRemoveFirst" : "buttonRemoveSecond");
  for (QPushButton* button : {adds_[index], picks_[index], removes_[index]}) buttons->addWidget(button, 1);
  column->addLayout(buttons);
  connect(list, &NameList::dropped, this, [this, side](const QStringList& names) { add(side, names); });
  connect(list, &NameList::removed, this, [this, side](const QStringList& names) { remove(side, names); });
  connect(list, &QListWidget::itemSelectionChanged, this,
          [this, index] { removes_[index]->setEnabled(!lists_[index]->selectedItems().isEmpty()); });
  connect(adds_[index], &QPushButton::clicked, this, [this, side] {
    const workcell::Entity* entity = host_.documentModel().document().find(host_.selection().current());
    if (entity) add(side, {QString::fromStdString(entity->name)});
  });
  connect(picks_[index], &QPushButton::clicked, this, [this, side] { pick(side); });
  connect(removes_[index], &QPushButton::clicked, this, [this, side, list] {
    QStringList names;
    for (const QListWidgetItem* item : list->selectedItems()) names << item->text();
    remove(side, names);
  });
  return holder;
}

const workcell::PairSet* PairColumns::set() const {
  return name_.isEmpty() ? nullptr : host_.documentModel().document().state().findPairSet(name_.toStdString());
}

void PairColumns::setSet(const QString& name) {
  name_ = name;
  show();
}

void PairColumns::show() {
  const workcell::PairSet* shown = set();
  const workcell::Entity* selected = host_.documentModel().document().find(host_.selection().current());
  for (std::size_t side = 0; side < 2; ++side) {
    QStringList names;
    if (shown)
      for (const std::string& name : side == 0 ? shown->first : shown->second) names << QString::fromStdString(name);
    QStringList before;
    for (int i = 0; i < lists_[side]->count(); ++i) before << lists_[side]->item(i)->text();
    if (names != before) {
      lists_[side]->clear();
      for (const QString& name : names) {
        const workcell::Entity* entity = host_.documentModel().document().findByName(name.toStdString());
        const char* const shape = entity && entity->robot() ? "robot" : "cube";
        new QListWidgetItem(icon(entity ? shape : "warning"), name, lists_[side]);
      }
    }
    lists_[side]->setEnabled(shown);
    picks_[side]->setEnabled(shown);
    adds_[side]->setEnabled(shown && selected);
    removes_[side]->setEnabled(shown && !lists_[side]->selectedItems().isEmpty());
  }
}

void PairColumns::add(int side, const QStringList& names) {
  const workcell::PairSet* now = set();
  if (!now) return;
  workcell::PairSet fresh = *now;
  std::vector<std::string>& column = side == 0 ? fresh.first : fresh.second;
  for (const QString& name : names) {
    const std::string text = name.toStdString();
    if (std::find(column.begin(), column.end(), text) == column.end()) column.push_back(text);
  }
  if (column != (side == 0 ? now->first : now->second))
    host_.documentModel().execute(workcell::EditPairSet{now->name, std::move(fresh)});
}

void PairColumns::remove(int side, const QStringList& names) {
  const workcell::PairSet* now = set();
  if (!now) return;
  workcell::PairSet fresh = *now;
  std::erase_if(side == 0 ? fresh.first : fresh.second,
                [&](const std::string& name) { return names.contains(QString::fromStdString(name)); });
  host_.documentModel().execute(workcell::EditPairSet{now->name, std::move(fresh)});
}

void PairColumns::pick(int side) {
  const QString prompt = side == 0 ? tr("Pick entities for the first column · Esc: end")
                                   : tr("Pick entities for the second column · Esc: end");
  host_.viewport().startPick(
      {{true, false, false}, prompt, [self = QPointer(this), side](const std::optional<PickedFeature>& feature) {
         if (!feature || !self) return;
         const auto* entity = self->host_.documentModel().document().find(feature->entity);
         if (entity) self->add(side, {QString::fromStdString(entity->name)});
         self->pick(side);
       }});
}

}  // namespace hapticell::app
