// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/workcell_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/dock_front.h"
#include "app/panels/cell/entity_menu.h"
#include "app/panels/tree/tree_edits.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/viewport/overlay/overlay_painter.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

using Role = WorkcellTreeModel::Role;
constexpr int kEyeColumn = 26;  // From the right edge, the eye's box.
constexpr int kMarkColumn = 22;

/// Paints a row's icon, name, suffix and marks.
class RowDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {120, kRowHeight}; }

  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    editor->setGeometry(option.rect.adjusted(20, 0, -2 * kMarkColumn, 0));
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme& theme = themeOf(option.palette);
    const auto* view = static_cast<const WorkcellTreeView*>(option.widget);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool shown = index.data(Role::kVisibleRole).toBool();
    const QRect r = option.rect;
    const QColor text = shown ? theme.text1 : theme.text3;
    if (index.data(Role::kMotionFrameRole).isValid()) {
      paintDot(*painter, QPointF(r.left() + 8.0, r.center().y() + 0.5), index, theme);
      paintName(*painter, QRect(r.left() + 24, r.top(), r.width() - 28, r.height()), index, text);
      return painter->restore();
    }
    icon(index.data(Role::kIconRole).toString(), shown ? theme.text2 : theme.text3)
        .paint(painter, QRect(r.left(), r.center().y() - 7, 16, 16));
    const bool open = view->isExpanded(index);
    const Mark mark = static_cast<Mark>(index.data(open ? Role::kMarkRole : Role::kInnerMarkRole).toInt());
    const bool locked = index.data(Role::kLockedRole).toBool();
    int right = r.right() - kEyeColumn;
    if (locked) {
      icon("lock", theme.text2).paint(painter, view->lockRect(index));
      right -= kMarkColumn;
    }
    if (mark != Mark::kNone) {
      paintMark(*painter, mark, QPointF(right - 9.0, r.center().y() + 0.5), 11, theme);
      right -= kMarkColumn;
    }
    if (index.data(Role::kCanHideRole).toBool())
      icon(shown ? "eye" : "eye_closed", shown ? theme.text2 : theme.text3).paint(painter, view->eyeRect(index));
    paintName(*painter, QRect(r.left() + 24, r.top(), right - r.left() - 24, r.height()), index, text);
    painter->restore();
  }

 private:
  /// Of a trajectory's frame: what the check found, by shape and colour; free: a disc; not checked: a ring.
  static void paintDot(QPainter& painter, const QPointF& at, const QModelIndex& index, const Theme& theme) {
    const Mark mark = static_cast<Mark>(index.data(Role::kMarkRole).toInt());
    if (mark != Mark::kNone) return paintMark(painter, mark, at, 10, theme);
    painter.setPen(QPen(theme.text1, 1.4));
    painter.setBrush(index.data(Role::kCheckedRole).toBool() ? QBrush(theme.text1) : QBrush(Qt::NoBrush));
    painter.drawEllipse(at, 3.0, 3.0);
  }

  static void paintName(QPainter& painter, const QRect& rect, const QModelIndex& index, const QColor& color) {
    const Theme& theme = themeOf(static_cast<QWidget*>(painter.device())->palette());
    painter.setFont(textFont(TextRole::kText));
    painter.setPen(color);
    const QString name = painter.fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, rect.width());
    painter.drawText(rect, Qt::AlignVCenter | Qt::AlignLeft, name);
    const QString suffix = index.data(Role::kSuffixRole).toString();
    if (suffix.isEmpty()) return;
    painter.setPen(theme.text3);
    const QRect rest = rect.adjusted(painter.fontMetrics().horizontalAdvance(name) + 5, 0, 0, 0);
    painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(suffix, Qt::ElideRight, rest.width()));
  }
};

}  // namespace

WorkcellTreeView::WorkcellTreeView(QWidget* parent) : QTreeView(parent) {
  setObjectName("treeWorkcell");
  setAccessibleName(tr("Workcell"));
  setHeaderHidden(true);
  setUniformRowHeights(true);
  setIndentation(18);
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(ExtendedSelection);
  setDragDropMode(InternalMove);
  setDragEnabled(true);
  setDropIndicatorShown(true);
  setEditTriggers(EditKeyPressed | DoubleClicked);
  setExpandsOnDoubleClick(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setContextMenuPolicy(Qt::CustomContextMenu);
  setMouseTracking(true);
  setItemDelegate(new RowDelegate(this));
  setBackgroundRole(QPalette::Window);
  viewport()->setBackgroundRole(QPalette::Window);
}

QRect WorkcellTreeView::eyeRect(const QModelIndex& index) const {
  const QRect row = visualRect(index);
  return {viewport()->width() - kEyeColumn + 1, row.center().y() - 7, 16, 16};
}

QRect WorkcellTreeView::lockRect(const QModelIndex& index) const {
  return eyeRect(index).translated(-kMarkColumn, 0);
}

void WorkcellTreeView::drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Theme& theme = themeOf(palette());
  const QRect row(0, option.rect.top(), viewport()->width(), option.rect.height());
  const bool selected = selectionModel()->isSelected(index);
  const bool hover = row.contains(viewport()->mapFromGlobal(QCursor::pos()));
  if (selected) {
    painter->fillRect(row, theme.selected_row);
    painter->fillRect(QRect(0, row.top(), 2, row.height()), theme.selection);
  } else if (hover) {
    painter->fillRect(row, theme.header);
  }
  QTreeView::drawRow(painter, option, index);
}

bool WorkcellTreeView::pressedMark(const QPoint& place) {
  const QModelIndex index = indexAt(place);
  if (!index.isValid()) return false;
  if (index.data(Role::kCanHideRole).toBool() && eyeRect(index).adjusted(-3, -4, 4, 4).contains(place)) {
    emit eyeClicked(index);
    return true;
  }
  if (index.data(Role::kLockedRole).toBool() && lockRect(index).adjusted(-3, -4, 3, 4).contains(place)) {
    emit lockClicked(index);
    return true;
  }
  return false;
}

void WorkcellTreeView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && pressedMark(event->pos())) return;
  QTreeView::mousePressEvent(event);
}

void WorkcellTreeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && pressedMark(event->pos())) return;
  QTreeView::mouseDoubleClickEvent(event);
}

void WorkcellTreeView::keyPressEvent(QKeyEvent* event) {
  const bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
  if (event->modifiers().testFlag(Qt::AltModifier) && (up || down)) return emit moveWanted(up ? -1 : 1);
  if (event->key() != Qt::Key_Delete) return QTreeView::keyPressEvent(event);
  emit removeWanted();
}

WorkcellPanel::WorkcellPanel(Host& host, QWidget* parent)
    : QWidget(parent), host_(host), model_(host.documentModel()), filter_(new QLineEdit), tree_(new WorkcellTreeView) {
  setMinimumWidth(240);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 8, 0, 0);
  column->setSpacing(8);
  auto* top = new QVBoxLayout;
  top->setContentsMargins(8, 0, 8, 0);
  filter_->setObjectName("fieldFilter");
  filter_->setProperty("search", true);
  filter_->setPlaceholderText(tr("Filter by name or state"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(icon("search", QColor()), QLineEdit::LeadingPosition);
  top->addWidget(filter_);
  column->addLayout(top);
  column->addWidget(tree_, 1);
  connect(&host_.documentModel(), &DocumentModel::closing, filter_, &QLineEdit::clear);
  filter_model_.setSourceModel(&model_);
  filter_model_.setFilterRole(Role::kFilterRole);
  filter_model_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  filter_model_.setRecursiveFilteringEnabled(true);
  tree_->setModel(&filter_model_);
  keepExpanded();
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_model_.setFilterFixedString(text);
    text.isEmpty() ? keepExpanded() : tree_->expandAll();
  });
  connect(&model_, &QAbstractItemModel::modelReset, this, &WorkcellPanel::keepExpanded, Qt::QueuedConnection);
  connect(tree_, &QTreeView::collapsed, this, [this](const QModelIndex& index) {
    if (!restoring_) collapsed_.insert(keyOf(index)), expanded_.remove(keyOf(index));
  });
  connect(tree_, &QTreeView::expanded, this, [this](const QModelIndex& index) {
    if (!restoring_) collapsed_.remove(keyOf(index)), expanded_.insert(keyOf(index));
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &WorkcellPanel::takeSelection);
  connect(&host_.selection(), &Selection::allChanged, this, &WorkcellPanel::showSelection);
  connect(tree_, &WorkcellTreeView::eyeClicked, this, [this](const QModelIndex& index) {
    model_.setShown(source(index), !index.data(Role::kVisibleRole).toBool());
  });
  connect(tree_, &WorkcellTreeView::lockClicked, this,
          [this](const QModelIndex& index) { model_.setLocked(source(index), false); });
  connect(tree_, &WorkcellTreeView::moveWanted, this, [this](int rows) {
    const QModelIndex now = tree_->currentIndex();
    if (now.data(Role::kMotionFrameRole).isValid()) emit pointStepWanted(now, rows);
  });
  connect(tree_, &WorkcellTreeView::removeWanted, this, [this] {
    const QModelIndex now = tree_->currentIndex();
    if (host_.selection().all().empty() && !now.data(Role::kMotionRole).toString().isEmpty())
      return emit motionRemoveWanted(now);
    if (auto* remove = host_.window().findChild<QAction*>("actionRemove")) remove->trigger();
  });
  connect(tree_, &QWidget::customContextMenuRequested, this, &WorkcellPanel::openMenu);
}

QString WorkcellPanel::keyOf(const QModelIndex& index) const {
  return index.parent().isValid() ? keyOf(index.parent()) + QLatin1Char('/') + index.data().toString()
                                  : QStringLiteral("cell");
}

void WorkcellPanel::keepExpanded() {
  restoring_ = true;
  const auto restore = [this](const auto& self, const QModelIndex& parent) -> void {
    for (int row = 0; row < filter_model_.rowCount(parent); ++row) {
      const QModelIndex index = filter_model_.index(row, 0, parent);
      const auto kind = model_.kindOf(source(index));
      // Parts from which an assembly stays closed: a large one is opened by whom it interests. Half: small ones too;
      // twice: the tree is long.
      constexpr int kManyRows = 40;
      // Frames of a motion are opened by whom they interest, and have nothing below them.
      const bool motion = kind == WorkcellTreeModel::Kind::kTrajectory;
      const bool few = kind == WorkcellTreeModel::Kind::kCell || filter_model_.rowCount(index) <= kManyRows;
      const bool open_at_first = few && !motion && kind != WorkcellTreeModel::Kind::kPairSets;
      const QString key = keyOf(index);
      tree_->setExpanded(index, expanded_.contains(key) || (open_at_first && !collapsed_.contains(key)));
      if (!motion) self(self, index);
    }
  };
  restore(restore, {});
  restoring_ = false;
  showSelection();
}

/// Rows of the tree become the selection; a folder or a link stands for its entity where it has one.
void WorkcellPanel::takeSelection() {
  if (restoring_) return;
  std::vector<workcell::EntityId> ids;
  for (const QModelIndex& index : tree_->selectionModel()->selectedIndexes()) {
    const auto id = index.data(Role::kEntityRole).toULongLong();
    if (id != 0 && std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
  restoring_ = true;  // What is chosen here stands so already.
  host_.selection().setAll(std::move(ids), tree_->currentIndex().data(Role::kEntityRole).toULongLong());
  restoring_ = false;
}

void WorkcellPanel::showSelection() {
  if (restoring_) return;
  const auto rowOf = [this](workcell::EntityId id) { return filter_model_.mapFromSource(model_.indexOf(id)); };
  const Selection& selection = host_.selection();
  QItemSelection rows;
  bool shown = true;
  std::size_t selected = 0;
  for (const auto id : selection.all()) {
    const QModelIndex index = rowOf(id);
    if (!index.isValid()) continue;
    rows.select(index, index);
    ++selected;
    shown = shown && tree_->selectionModel()->isSelected(index);
  }
  const auto now = tree_->selectionModel()->selectedIndexes();
  // A link's or a folder's row stands for its entity: it stays.
  const bool of_current = selection.all().size() == 1 && now.size() == 1 &&
                          now.front().data(Role::kEntityRole).toULongLong() == selection.current();
  if (of_current || (shown && selected == static_cast<std::size_t>(now.size()) && selected > 0)) return;
  const bool folder = selected == 0 && now.size() == 1 && now.front().data(Role::kEntityRole).toULongLong() == 0;
  if (folder) return;
  restoring_ = true;
  tree_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (const QModelIndex index = rowOf(selection.current()); index.isValid()) {
    tree_->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    tree_->scrollTo(index);
  }
  restoring_ = false;
}

std::vector<workcell::EntityId> WorkcellPanel::chosenEntities() const {
  std::vector<workcell::EntityId> ids;
  for (const QModelIndex& index : tree_->selectionModel()->selectedIndexes())
    for (const auto id : model_.entitiesOf(source(index)))
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  return ids;
}

void WorkcellPanel::openMenu(const QPoint& place) {
  const QModelIndex index = tree_->indexAt(place);
  if (!index.isValid()) return;
  QMenu menu(this);
  fillMenu(menu, index);
  menu.exec(tree_->viewport()->mapToGlobal(place));
}

void WorkcellPanel::fillMenu(QMenu& menu, const QModelIndex& index) {
  const QPersistentModelIndex row = index;
  const bool named = model_.flags(source(index)) & Qt::ItemIsEditable;
  const auto rename = named ? [this, row] { tree_->edit(row); } : std::function<void()>();
  if (model_.kindOf(source(index)) == WorkcellTreeModel::Kind::kFrame) {
    menu.addAction(tr("Rename"), &menu, rename);
    const auto entity = index.data(Role::kEntityRole).toULongLong();
    menu.addAction(icon("delete"), tr("Remove this frame"), &menu,
                   [this, entity, frame = index.data(Role::kPartRole).toString()] {
                     removeOwnFrame(host_.documentModel(), entity, frame);
                   });
  } else if (index.data(Role::kMotionRole).toString().isEmpty())
    fillEntityMenu(menu, host_, chosenEntities(), rename);
  else if (named)
    menu.addAction(tr("Rename"), &menu, rename);
  emit menuFilled(&menu, index);
}

void WorkcellPanel::chooseFrame(const QString& motion, std::size_t frame) {
  // Queued, as is the opening of the rows after they are new.
  QMetaObject::invokeMethod(
      this,
      [this, motion, frame] {
        const QModelIndex index = filter_model_.mapFromSource(model_.indexOfFrame(motion, frame));
        if (!index.isValid()) return;
        tree_->setExpanded(index.parent(), true);
        tree_->setCurrentIndex(index);
        tree_->scrollTo(index);
      },
      Qt::QueuedConnection);
}

void WorkcellPanel::rename(workcell::EntityId entity) {
  for (QWidget* holder = parentWidget(); holder; holder = holder->parentWidget())
    if (auto* dock = qobject_cast<QDockWidget*>(holder)) {
      bringToFront(dock);
    }
  if (!filter_model_.mapFromSource(model_.indexOf(entity)).isValid()) filter_->clear();
  const QModelIndex index = filter_model_.mapFromSource(model_.indexOf(entity));
  if (!index.isValid()) return;
  tree_->scrollTo(index);
  tree_->edit(index);
}

}  // namespace hapticell::app
