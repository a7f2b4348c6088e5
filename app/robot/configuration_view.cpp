// SPDX-License-Identifier: Apache-2.0
#include "app/robot/configuration_view.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/controls/robot_ghosts.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/robot/joint_mover.h"
#include "app/robot/motion_worker.h"
#include "app/robot/robot_context.h"
#include "app/style/library_text.h"
#include "app/style/theme.h"
#include "app/viewport/overlay/overlay_painter.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr int kTableRow = 24;
constexpr int kMostRows = 8;  // Room for an arm's usual eight; more are scrolled.
// Of a robot with infinitely many, as kMaxAlternatives of numeric_search.cpp. Half, twice: a coarser or longer list.
constexpr std::size_t kMost = 64;
// ms after the last motion until configurations are searched. Half: searched while dragging; twice: the list lags.
constexpr int kAskMilliseconds = 120;

/// Mark and words of a row.
class ConfigurationDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    using Way = ConfigurationModel::Way;
    const Theme& theme = themeOf(option.palette);
    const Way way = static_cast<Way>(index.data(ConfigurationModel::kWayRole).toInt());
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (option.state.testFlag(QStyle::State_Selected)) {
      painter->fillRect(option.rect, theme.selected_row);
      if (index.column() == 0)
        painter->fillRect(QRect(option.rect.left(), option.rect.top(), 2, option.rect.height()), theme.selection);
    }
    QRect text = option.rect.adjusted(6, 0, -4, 0);
    if (index.column() == ConfigurationModel::kArm) {
      paintWay(*painter, way, QPointF(text.left() + 7.0, text.center().y() + 0.5), theme);
      text.adjust(22, 0, 0, 0);
    }
    const bool out = way == Way::kOutOfLimits;
    const bool stale = !option.state.testFlag(QStyle::State_Enabled);
    QColor color = out ? theme.text2 : theme.text1;
    if (stale) color = theme.text3;
    if (!stale && index.column() == ConfigurationModel::kWay && out) color = theme.words.limit;
    if (!stale && index.column() == ConfigurationModel::kWay && way == Way::kBlocked) color = theme.words.contact;
    painter->setPen(color);
    painter->drawText(text, Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, text.width()));
    painter->restore();
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return QStyledItemDelegate::sizeHint(option, index) + QSize(8, 0);  // The margins of paint().
  }

 private:
  static void paintWay(QPainter& painter, ConfigurationModel::Way way, const QPointF& center, const Theme& theme) {
    using Way = ConfigurationModel::Way;
    if (way == Way::kBlocked) return paintMark(painter, Mark::kContact, center, 10, theme);
    if (way == Way::kOutOfLimits) return paintMark(painter, Mark::kLimit, center, 10, theme);
    painter.setPen(QPen(way == Way::kNow ? theme.selection : theme.text2, 1.5,
                        way == Way::kUnknown ? Qt::DotLine : Qt::SolidLine));
    painter.setBrush(way == Way::kNow ? QBrush(theme.selection) : QBrush(Qt::NoBrush));
    painter.drawEllipse(center, 3.5, 3.5);
  }
};

QTableView* makeTable(QAbstractItemModel* model) {
  auto* table = new QTableView;
  table->setObjectName("tableConfigurations");
  table->setAccessibleName(QObject::tr("Configurations"));
  table->setModel(model);
  table->setItemDelegate(new ConfigurationDelegate(table));
  table->setShowGrid(false);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->setTabKeyNavigation(false);
  table->setMouseTracking(true);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(kTableRow);
  QHeaderView* header = table->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setSectionResizeMode(QHeaderView::Stretch);
  // The names of the arms are what is chosen by; what is on the way has a tip.
  for (const int column : {static_cast<int>(ConfigurationModel::kArm), static_cast<int>(ConfigurationModel::kFlags)})
    header->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  return table;
}

QString solutionsText(int rows, int reachable, bool are_all) {
  if (rows == 0) return {};
  if (!are_all) return ConfigurationView::tr("%1 of many, nearest first").arg(rows);
  return ConfigurationView::tr("%1 of %2 solutions within limits").arg(reachable).arg(rows);
}

/// At the foot where no other configuration is seen in the scene.
QString footText(int rows, bool chosen, bool has_inverse) {
  if (!has_inverse) return ConfigurationView::tr("No inverse kinematics. Jog the joints instead.");
  if (rows == 0) return {};  // Not computed yet.
  return chosen ? ConfigurationView::tr("This is the current configuration.")
                : ConfigurationView::tr("Select a row to see it in the scene.");
}

}  // namespace

ConfigurationView::ConfigurationView(RobotContext& context, MotionWorker& worker, JointMover& mover, QWidget* parent)
    : QWidget(parent), context_(context), worker_(worker), mover_(mover) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* top = new QHBoxLayout;
  count_ = makeLabel({}, TextRole::kSecond, true);
  count_->setObjectName("labelConfigurations");
  top->addWidget(makeLabel(tr("Configuration"), TextRole::kSection, true), 1);
  top->addWidget(count_);
  column->addLayout(top);
  table_ = makeTable(&model_);
  table_->viewport()->installEventFilter(this);
  table_->setFixedHeight(26 + kTableRow * kMostRows + 2);  // However many there are: what is below stays.
  column->addWidget(table_);
  auto* bottom = new QHBoxLayout;
  foot_ = makeLive(3, TextRole::kSecond, true);
  take_ = new QPushButton(tr("Apply"));
  take_->setObjectName("buttonTake");
  take_->setProperty("main", true);
  bottom->addWidget(foot_, 1);
  bottom->addWidget(take_);
  column->addLayout(bottom);
  ask_.setSingleShot(true);
  connect(&ask_, &QTimer::timeout, this, &ConfigurationView::askAgain);
  const auto later = [this] {
    const workcell::Entity* robot = context_.robot();
    if ((robot ? robot->id : 0) != asked_robot_) show({});  // What is listed is of another robot, or of one that is gone.
    if (robot && robot->joints() != asked_) showStale();
    ask_.start(kAskMilliseconds);
  };
  connect(&context_, &RobotContext::robotChanged, this, later);
  connect(&context_, &RobotContext::documentChanged, this, later);
  connect(take_, &QPushButton::clicked, this, &ConfigurationView::take);
  connect(table_, &QTableView::doubleClicked, this, &ConfigurationView::take);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
    keep_ = row.isValid() ? model_.solution(row.row()).q : std::vector<double>{};
    showGhost();
  });
  show({});
}

void ConfigurationView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  asked_.clear();
  ask_.start(0);
}

void ConfigurationView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  worker_.dropWays();
  context_.host().viewport().scene().setGhosts("configuration", {});
  context_.host().viewport().refresh();
}

void ConfigurationView::askAgain() {
  const workcell::Entity* robot = context_.robot();
  if (!robot || !isVisible() || !context_.inverse()) return show({});
  if (mover_.isOpen() || mover_.isBusy() || context_.isHeld()) return ask_.start(kAskMilliseconds);
  worker_.listSolutions(*robot, robot->joints(),
                        [this, id = robot->id, joints = robot->joints()](std::vector<kinematics::ListedSolution> list) {
                          // The robot may have been deleted or moved, or another one been selected: it is asked again.
                          const workcell::Entity* now = context_.robot();
                          if (now && now->id == id && now->joints() == joints) show(std::move(list));
                        });
}

/// The robot stands elsewhere than the list says: greyed until the next one is there.
void ConfigurationView::showStale() {
  hovered_ = -1;
  table_->setEnabled(false);
  take_->setEnabled(false);
  worker_.dropWays();
  context_.host().viewport().scene().setGhosts("configuration", {});
}

void ConfigurationView::show(std::vector<kinematics::ListedSolution> solutions) {
  const workcell::Entity* robot = context_.robot();
  const auto all = solutions.size();
  if (solutions.size() > kMost) solutions.resize(kMost);
  const std::vector<double> chosen = keep_;
  hovered_ = -1;
  asked_robot_ = robot ? robot->id : 0;
  asked_ = robot ? robot->joints() : std::vector<double>{};
  table_->setEnabled(true);
  static const char* const kMakers[]{"", "KUKA", "ABB", "FANUC"};
  const QString maker =
      robot ? QLatin1String(kMakers[static_cast<int>(kinematics::makerOf(*robot->robot()))]) : QString();
  model_.setSolutions(robot ? robot->robot().get() : nullptr, std::move(solutions),
                      robot ? robot->joints() : std::vector<double>{}, maker);
  table_->setColumnHidden(ConfigurationModel::kFlags, !model_.hasFlags());
  const int rows = model_.rowCount();
  count_->setText(solutionsText(rows, model_.reachable(), all <= kMost));
  // What was chosen stays chosen while the list says the same again.
  if (const int row = chosen.empty() ? -1 : model_.rowOf(chosen); row >= 0) table_->selectRow(row);
  std::vector<std::vector<double>> targets;
  std::vector<int> rows_of;
  for (int i = 0; i < rows; ++i) {
    if (model_.way(i) != ConfigurationModel::Way::kUnknown) continue;
    targets.push_back(model_.solution(i).q);
    rows_of.push_back(i);
  }
  worker_.dropWays();
  if (robot && context_.isFree())
    worker_.checkWays(robot->id, std::move(targets), [this, rows_of](std::size_t i, const auto& motion) {
      const bool free = motion && motion->complete;
      const QString reason = motion ? shownText(motion->reason) : shownText(motion.error());
      model_.setWay(rows_of[i], free, motion ? QString::fromStdString(motion->obstacle) : QString(), reason);
      showGhost();
    });
  showGhost();
  emit listed();
}

int ConfigurationView::shownRow() const {
  if (hovered_ >= 0 && hovered_ < model_.rowCount()) return hovered_;
  const QModelIndex row = table_->currentIndex();
  return row.isValid() ? row.row() : -1;
}

void ConfigurationView::showGhost() {
  using Way = ConfigurationModel::Way;
  const int row = shownRow();
  ViewportWidget& viewport = context_.host().viewport();
  std::vector<GhostPose> ghosts;
  if (row >= 0 && context_.robot() && model_.way(row) != Way::kNow)
    ghosts = robotGhosts(context_.host().documentModel().document().state(), context_.robot()->id,
                         model_.solution(row).q, model_.way(row) == Way::kBlocked);
  viewport.scene().setGhosts("configuration", std::move(ghosts));
  viewport.refresh();
  showFoot();
}

void ConfigurationView::showFoot() {
  using Way = ConfigurationModel::Way;
  const QModelIndex chosen = table_->currentIndex();
  const int row = shownRow();
  const Way way = row >= 0 ? model_.way(row) : Way::kNow;
  const QString dashed = tr("The selected row is dashed in the scene.");
  switch (way) {
    case Way::kNow:
      foot_->setText(footText(model_.rowCount(), row >= 0, !context_.robot() || context_.inverse()));
      break;
    case Way::kUnknown:
      foot_->setText(dashed + QLatin1Char(' ') + tr("Checking the path…"));
      break;
    case Way::kFree:
      foot_->setText(dashed + QLatin1Char(' ') + tr("The path is free."));
      break;
    default:
      foot_->setText(dashed + QLatin1Char(' ') +
                     model_.data(model_.index(row, 0), Qt::ToolTipRole).toString().section('\n', 1) + QLatin1Char('.'));
  }
  const bool can = chosen.isValid() && context_.isFree() &&
                   (model_.way(chosen.row()) == Way::kFree || model_.way(chosen.row()) == Way::kUnknown);
  take_->setEnabled(can);
}

void ConfigurationView::take() {
  const QModelIndex chosen = table_->currentIndex();
  if (!chosen.isValid() || !take_->isEnabled() || !context_.robot()) return;
  const QString text = tr("Move %1 to configuration %2")
                           .arg(QString::fromStdString(context_.robot()->name),
                                model_.data(model_.index(chosen.row(), 0), Qt::DisplayRole).toString());
  mover_.travel(text, model_.solution(chosen.row()).q);
}

bool ConfigurationView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && (event->type() == QEvent::MouseMove || event->type() == QEvent::Leave)) {
    const int row = event->type() == QEvent::Leave
                        ? -1
                        : table_->rowAt(static_cast<const QMouseEvent*>(event)->position().toPoint().y());
    if (row != hovered_) {
      hovered_ = row;
      showGhost();
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace hapticell::app
