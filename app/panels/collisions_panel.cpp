// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions_panel.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/panels/form.h"
#include "app/panels/pair_set_list.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/theme.h"
#include "app/style/value_field.h"
#include "app/viewport/overlay_painter.h"

namespace hapticell::app {
namespace {

constexpr int kTableRow = 28;
constexpr int kBarWidth = 64;

class PairDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme& theme = themeOf(option.palette);
    const Mark mark = static_cast<Mark>(index.data(PairTableModel::kMarkRole).toInt());
    const bool measured = index.data(PairTableModel::kShareRole).isValid();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (option.state.testFlag(QStyle::State_Selected)) {
      painter->fillRect(option.rect, theme.selected_row);
      if (index.column() == 0)
        painter->fillRect(QRect(option.rect.left(), option.rect.top(), 2, option.rect.height()), theme.selection);
    }
    QRect text = option.rect.adjusted(8, 0, -8, 0);
    QColor color = measured ? theme.text1 : theme.text3;
    if (index.column() == PairTableModel::kState) {
      const QPointF center(text.left() + 10.0, text.center().y() + 0.5);
      if (mark == Mark::kNone) {
        painter->setPen(QPen(theme.text3, 1.3));
        painter->drawEllipse(center, 3.5, 3.5);
      } else {
        paintMark(*painter, mark, center, 11, theme);
        color = mark == Mark::kContact ? theme.contact_text : theme.near_miss_text;
      }
      text.adjust(26, 0, 0, 0);
    }
    if (index.column() == PairTableModel::kDistance) {
      if (measured)
        paintBar(*painter, QRect(text.right() - kBarWidth, text.center().y() - 4, kBarWidth, 9), index, theme);
      text.adjust(0, 0, -kBarWidth - 10, 0);
    }
    painter->setPen(color);
    const QString words = painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, text.width());
    painter->drawText(text, index.data(Qt::TextAlignmentRole).toInt(), words);
    painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), theme.header);
    painter->restore();
  }

 private:
  static void paintBar(QPainter& painter, const QRect& bar, const QModelIndex& index, const Theme& theme) {
    const Mark mark = static_cast<Mark>(index.data(PairTableModel::kMarkRole).toInt());
    const double share = index.data(PairTableModel::kShareRole).toDouble();
    const int threshold =
        bar.left() + static_cast<int>(bar.width() * index.data(PairTableModel::kThresholdRole).toDouble());
    painter.fillRect(bar, theme.field);
    if (mark == Mark::kContact)
      paintMark(painter, mark, QPointF(bar.left() + 4.0, bar.center().y() + 0.5), 8, theme);
    else
      painter.fillRect(QRect(bar.left(), bar.top(), static_cast<int>(bar.width() * share), bar.height()),
                       mark == Mark::kNearMiss ? theme.near_miss : theme.text3);
    painter.setPen(QPen(theme.text1, 1.0, Qt::DotLine));
    painter.drawLine(threshold, bar.top() - 2, threshold, bar.bottom() + 2);
  }
};

}  // namespace

CollisionsPanel::CollisionsPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(makeSets());
  auto* line = new QFrame;
  line->setFixedWidth(1);
  line->setBackgroundRole(QPalette::Mid);
  line->setAutoFillBackground(true);
  row->addWidget(line);
  row->addWidget(makeTable(), 1);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &CollisionsPanel::showSets);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] { showSnapshot(host_.snapshot()); });
  connect(&host_.selection(), &Selection::changed, this, [this] { showSnapshot(host_.snapshot()); });
  showSets();
  showSnapshot({});
}

QWidget* CollisionsPanel::makeSets() {
  auto* holder = new QWidget;
  holder->setFixedWidth(236);
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 8, 0, 8);
  column->setSpacing(6);
  auto* heading = makeLabel(tr("Sets"), TextRole::kSection, true);
  heading->setContentsMargins(12, 0, 0, 0);
  column->addWidget(heading);
  sets_ = new PairSetList;
  sets_->setObjectName("pairSets");
  column->addWidget(sets_);
  set_fields_ = new QWidget;
  auto* fields = new QVBoxLayout(set_fields_);
  fields->setContentsMargins(12, 6, 12, 0);
  fields->setSpacing(6);
  set_heading_ = makeLabel({}, TextRole::kSection, true);
  fields->addWidget(set_heading_);
  near_miss_ = new ValueField({tr("mm"), 1, 0.0, 1000.0, 1.0});
  near_miss_->setObjectName("fieldNearMiss");
  safety_ = new ValueField({tr("mm"), 2, 0.0, 1000.0, 0.1});
  safety_->setObjectName("fieldSafety");
  safety_->setToolTip(tr("Felt as the boundary"));
  on_contact_ = new QComboBox;
  on_contact_->addItems({tr("As the entity"), tr("Stop"), tr("Slide"), tr("Pass")});
  addRow(*fields, tr("Near miss"), near_miss_);
  addRow(*fields, tr("Safety"), safety_);
  addRow(*fields, tr("On contact"), on_contact_);
  column->addWidget(set_fields_);
  column->addStretch(1);
  connect(sets_, &PairSetList::chosen, this, &CollisionsPanel::showSet);
  connect(sets_, &PairSetList::switched, this, [this](int, bool on) { edit([on](auto& set) { set.enabled = on; }); });
  connect(near_miss_, &ValueField::edited, this,
          [this](double mm) { edit([mm](auto& set) { set.near_miss = mm / 1000.0; }); });
  connect(safety_, &ValueField::edited, this,
          [this](double mm) { edit([mm](auto& set) { set.safety_distance = mm / 1000.0; }); });
  connect(on_contact_, &QComboBox::activated, this, [this](int index) {
    edit([index](auto& set) {
      set.on_contact = index == 0 ? std::nullopt : std::optional(static_cast<workcell::OnContact>(index - 1));
    });
  });
  return holder;
}

QWidget* CollisionsPanel::makeTable() {
  auto* holder = new QWidget;
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 8, 0, 0);
  column->setSpacing(6);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(10, 0, 12, 0);
  filter_ = new QLineEdit;
  filter_->setPlaceholderText(tr("Filter by name"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(icon("search"), QLineEdit::LeadingPosition);
  filter_->setFixedWidth(220);
  show_ = new Segmented({tr("All 000"), tr("Contact 00"), tr("Near miss 00")});
  show_->setFixedWidth(show_->sizeHint().width() + 24);
  show_->setCurrent(0);
  top->addWidget(filter_);
  top->addWidget(show_);
  top->addStretch(1);
  column->addLayout(top);
  table_ = new QTableView;
  table_->setObjectName("tablePairs");
  table_->setAccessibleName(tr("Pairs"));
  table_->setModel(&model_);
  table_->setItemDelegate(new PairDelegate(table_));
  table_->setFrameShape(QFrame::NoFrame);
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->viewport()->setBackgroundRole(QPalette::Window);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kTableRow);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setSectionResizeMode(QHeaderView::Fixed);
  const int widths[PairTableModel::kColumns]{120, 180, 180, 180, 100, 100};
  for (int i = 0; i < PairTableModel::kColumns; ++i) header->resizeSection(i, widths[i]);
  header->setSectionResizeMode(PairTableModel::kMoved, QHeaderView::Stretch);
  header->setSectionResizeMode(PairTableModel::kAgainst, QHeaderView::Stretch);
  column->addWidget(table_, 1);
  const auto choose = [this] {
    model_.setShow(static_cast<PairTableModel::Show>(std::max(0, show_->current())), filter_->text());
  };
  connect(filter_, &QLineEdit::textChanged, this, choose);
  connect(show_, &Segmented::chosen, this, choose);
  connect(table_, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { host_.selection().set(model_.row(index.row()).other); });
  return holder;
}

const workcell::PairSet* CollisionsPanel::currentSet() const {
  const auto& sets = host_.documentModel().document().state().pair_sets;
  const int index = sets_->current();
  return index >= 0 && index < static_cast<int>(sets.size()) ? &sets[static_cast<std::size_t>(index)] : nullptr;
}

void CollisionsPanel::showSets() {
  sets_->setSets(host_.documentModel().document().state().pair_sets);
  showSet();
}

void CollisionsPanel::showSet() {
  const workcell::PairSet* set = currentSet();
  set_fields_->setVisible(set);
  if (!set) return;
  set_heading_->setText(tr("Set: %1").arg(QString::fromStdString(set->name)));
  if (!near_miss_->hasFocus()) near_miss_->setValue(1000.0 * set->near_miss);
  if (!safety_->hasFocus()) safety_->setValue(1000.0 * set->safety_distance);
  on_contact_->setCurrentIndex(set->on_contact ? 1 + static_cast<int>(*set->on_contact) : 0);
}

void CollisionsPanel::edit(const std::function<void(workcell::PairSet&)>& change) {
  const workcell::PairSet* set = currentSet();
  if (!set) return;
  workcell::PairSet fresh = *set;
  change(fresh);
  if (!host_.documentModel().execute(workcell::EditPairSet{set->name, fresh})) showSet();
}

workcell::EntityId CollisionsPanel::movedEntity() const {
  if (host_.snapshot() && host_.snapshot()->held) return host_.snapshot()->held;
  return host_.selection().current();
}

void CollisionsPanel::showSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) {
  const auto& settings = host_.configuration().manipulation;
  model_.setRows(pairRows(host_.documentModel().document().state(), snapshot, movedEntity(),
                          {settings.safety_distance, settings.near_miss}));
  using Show = PairTableModel::Show;
  const auto name = [this](int button, const QString& text) { show_->button(button)->setText(text); };
  name(0, tr("All %1").arg(model_.count(Show::kAll)));
  name(1, tr("Contact %1").arg(model_.count(Show::kContact)));
  name(2, tr("Near miss %1").arg(model_.count(Show::kNearMiss)));
  const int alerts = model_.count(Show::kContact) + model_.count(Show::kNearMiss);
  if (alerts == alerts_) return;
  alerts_ = alerts;
  emit alertsChanged(alerts);
}

}  // namespace hapticell::app
