// SPDX-License-Identifier: Apache-2.0
#include "app/robot/tools_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/controls/entity_icon.h"
#include "app/kit/form.h"
#include "app/controls/pose_text.h"
#include "app/robot/load_line.h"
#include "app/robot/robot_context.h"
#include "app/style/icon.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr double kFrameLength = 0.12;  // m, of the drawn axes.
constexpr int kRow = 24;

QListWidget* makeList(const char* name, const QString& accessible, int rows) {
  auto* list = new QListWidget;
  list->setObjectName(QLatin1String(name));
  list->setAccessibleName(accessible);
  list->setUniformItemSizes(true);
  list->setFixedHeight(rows * kRow + 4);
  return list;
}

}  // namespace

std::string freeToolName(const std::vector<workcell::ToolFrame>& tools) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(tools.begin(), tools.end(), [&](const auto& tool) { return tool.name == name; });
  };
  const std::string base = QObject::tr("Tool").toStdString();
  if (!taken(base)) return base;
  int number = 2;
  while (taken(base + " " + std::to_string(number))) ++number;
  return base + " " + std::to_string(number);
}

ToolsPanel::ToolsPanel(RobotContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addTools(*column);
  addCarried(*column);
  column->addStretch(1);
  connect(&context_, &RobotContext::robotChanged, this, &ToolsPanel::show);
  connect(&context_, &RobotContext::documentChanged, this, &ToolsPanel::show);
  connect(&context_.host().viewport(), &ViewportWidget::sceneChanged, this, &ToolsPanel::drawFrame);
  show();
}

ToolsPanel::~ToolsPanel() = default;

void ToolsPanel::addTools(QVBoxLayout& column) {
  QVBoxLayout* rows = addSection(column, tr("Tool centre points"));
  tools_ = makeList("listTools", tr("Tools"), 4);
  rows->addWidget(tools_);
  auto* add = makeButton("buttonNewTool", tr("New"), tr("Copies the selected tool, or adds one at the flange"));
  remove_ = makeButton("buttonRemoveTool", tr("Remove"));
  use_ = makeButton("buttonUseTool", tr("Use this one"));
  use_->setProperty("main", true);
  rows->addWidget(sideBySide({add, remove_, use_}));
  name_ = new QLineEdit;
  name_->setObjectName("editToolName");
  addRow(*rows, tr("Name"), name_, 56);
  link_ = new QComboBox;
  link_->setObjectName("comboToolLink");
  addRow(*rows, tr("On link"), link_, 56);
  const char* const axes[6]{"X", "Y", "Z", "A", "B", "C"};
  for (std::size_t i = 0; i < 6; ++i) {
    pose_[i] = new ValueField({i < 3 ? QStringLiteral("mm") : QStringLiteral("°"), 1, -1e5, 1e5, 1.0});
    pose_[i]->setObjectName(QStringLiteral("toolPose%1").arg(QLatin1String(axes[i])));
    connect(pose_[i], &ValueField::edited, this, &ToolsPanel::editTool);
  }
  addRow(*rows, tr("X Y Z"), sideBySide({pose_[0], pose_[1], pose_[2]}), 56);
  addRow(*rows, tr("A B C"), sideBySide({pose_[3], pose_[4], pose_[5]}), 56);
  for (std::size_t i = 0; i < 6; ++i) pose_[i]->setAccessibleName(QLatin1String(axes[i]));
  pick_ = makeButton("buttonPickTool", tr("Pick in the scene"),
                     tr("Pick a face, an edge or a corner for the tool's origin and direction"));
  rows->addWidget(pick_);
  connect(tools_, &QListWidget::currentRowChanged, this, &ToolsPanel::showTool);
  connect(tools_, &QListWidget::itemDoubleClicked, this, &ToolsPanel::useTool);
  connect(name_, &QLineEdit::editingFinished, this, &ToolsPanel::editTool);
  connect(link_, &QComboBox::activated, this, &ToolsPanel::editTool);
  connect(add, &QPushButton::clicked, this, &ToolsPanel::addTool);
  connect(remove_, &QPushButton::clicked, this, &ToolsPanel::removeTool);
  connect(use_, &QPushButton::clicked, this, &ToolsPanel::useTool);
  connect(pick_, &QPushButton::clicked, this, &ToolsPanel::pick);
}

void ToolsPanel::addCarried(QVBoxLayout& column) {
  QVBoxLayout* rows = addSection(column, tr("Carried: moves with the link and is checked with it"));
  carried_ = makeList("listCarried", tr("Carried parts"), 3);
  rows->addWidget(carried_);
  release_ = makeButton("buttonRelease", tr("Release"), tr("It stays where it is"));
  part_ = new QComboBox;
  part_->setObjectName("comboPart");
  auto* pick_part = makeButton("buttonPickPart", tr("Pick"), tr("Click the part in the scene"));
  pick_part->setFixedWidth(64);
  auto* choice = new QWidget;
  auto* line = new QHBoxLayout(choice);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  line->addWidget(part_, 1);
  line->addWidget(pick_part);
  addRow(*rows, tr("Part"), choice, 56);
  part_->setAccessibleName(tr("Part to attach"));
  carrier_link_ = new QComboBox;
  carrier_link_->setObjectName("comboCarrierLink");
  addRow(*rows, tr("On link"), carrier_link_, 56);
  attach_ = makeButton("buttonAttach", tr("Attach"), tr("At its current placement"));
  mount_ = makeButton("buttonMount", tr("Mount"), tr("Moves the part's origin to the frame of the link, then attaches it"));
  rows->addWidget(sideBySide({release_, attach_, mount_}));
  rows->addWidget(new LoadLine(context_, "labelToolsLoad"));
  connect(carried_, &QListWidget::currentRowChanged, this, [this](int row) { release_->setEnabled(row >= 0); });
  connect(release_, &QPushButton::clicked, this, [this] {
    if (const QListWidgetItem* item = carried_->currentItem())
      context_.host().documentModel().execute(workcell::Detach{item->data(Qt::UserRole).toULongLong()});
  });
  connect(attach_, &QPushButton::clicked, this, [this] { attach(part_->currentData().toULongLong()); });
  connect(mount_, &QPushButton::clicked, this, [this] { mount(part_->currentData().toULongLong()); });
  // What the user has just imported or clicked is what the robot is to carry.
  connect(&context_.host().selection(), &Selection::changed, this, [this] {
    const int row = part_->findData(static_cast<qulonglong>(context_.host().selection().current()));
    if (row >= 0) part_->setCurrentIndex(row);
  });
  connect(pick_part, &QPushButton::clicked, this, [this] {
    context_.host().viewport().startPick(
        {{.faces = true, .edges = false, .vertices = false},
         tr("Click the part for the robot to carry"),
         [this](const std::optional<PickedFeature>& feature) {
           const int row = feature ? part_->findData(static_cast<qulonglong>(feature->entity)) : -1;
           if (row >= 0) part_->setCurrentIndex(row);
         }});
  });
}

int ToolsPanel::chosen() const {
  const workcell::Entity* robot = context_.robot();
  const int row = tools_->currentRow();
  return robot && row >= 0 && row < static_cast<int>(robot->jointed().tools.size()) ? row : -1;
}

void ToolsPanel::show() {
  if (!isVisible() && tools_->count() > 0) return;
  const workcell::Entity* robot = context_.robot();
  showing_ = true;
  const int row = tools_->currentRow();
  tools_->clear();
  link_->clear();
  setEnabled(robot && !context_.isMechanism());
  if (robot) {
    for (const auto& tool : robot->jointed().tools)
      tools_->addItem(QString::fromStdString(tool.name) +
                      (tool.name == robot->jointed().tool ? tr("  (in use)") : QString()));
    for (const auto& link : robot->robot()->links) link_->addItem(QString::fromStdString(link.name));
    tools_->setCurrentRow(std::min(std::max(row, 0), tools_->count() - 1));
  }
  showing_ = false;
  showTool();
  showCarried();
}

void ToolsPanel::showTool() {
  if (showing_) return;
  const int row = chosen();
  for (QWidget* widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(link_), static_cast<QWidget*>(remove_),
                          static_cast<QWidget*>(use_), static_cast<QWidget*>(pick_)})
    widget->setEnabled(row >= 0);
  for (ValueField* field : pose_) field->setEnabled(row >= 0);
  drawFrame();
  if (row < 0) return name_->clear();
  const workcell::ToolFrame& tool = context_.robot()->jointed().tools[static_cast<std::size_t>(row)];
  use_->setEnabled(tool.name != context_.robot()->jointed().tool);
  if (!name_->hasFocus()) name_->setText(QString::fromStdString(tool.name));
  link_->setCurrentText(QString::fromStdString(tool.tip_link));
  const auto numbers = poseNumbers(tool.X_LT);
  for (std::size_t i = 0; i < 6; ++i) pose_[i]->setValue(numbers[i]);
}

void ToolsPanel::showCarried() {
  const workcell::Entity* robot = context_.robot();
  const QVariant kept = part_->currentData();
  const QString link = carrier_link_->currentText();
  carried_->clear();
  part_->clear();
  carrier_link_->clear();
  release_->setEnabled(false);
  attach_->setEnabled(false);
  mount_->setEnabled(false);
  if (!robot) return;
  for (const auto& entity : context_.host().documentModel().document().state().entities) {
    const QString name = QString::fromStdString(entity->name);
    if (entity->attachment.to == robot->name) {
      auto* item =
          new QListWidgetItem(icon(entityIcon(*entity)),
                              tr("%1 on %2").arg(name, QString::fromStdString(entity->attachment.link)), carried_);
      item->setData(Qt::UserRole, static_cast<qulonglong>(entity->id));
    } else if (entity->attachment.to.empty() && entity->id != robot->id && !entity->locked &&
               (entity->mesh() || entity->robot() || entity->kind() == workcell::EntityKind::kFrame)) {
      part_->addItem(icon(entityIcon(*entity)), name, static_cast<qulonglong>(entity->id));
    }
  }
  for (const auto& other : robot->robot()->links) carrier_link_->addItem(QString::fromStdString(other.name));
  carrier_link_->setCurrentText(carrier_link_->findText(link) >= 0 ? link
                                                                   : QString::fromStdString(robot->jointed().tip_link));
  if (const int row = part_->findData(kept); kept.isValid() && row >= 0) part_->setCurrentIndex(row);
  attach_->setEnabled(part_->count() > 0);
  mount_->setEnabled(part_->count() > 0);
}

void ToolsPanel::drawFrame() {
  std::vector<SceneCurve> curves;
  const workcell::Entity* robot = context_.robot();
  if (const int row = chosen(); row >= 0 && isVisible()) {
    workcell::Entity with = *robot;
    with.editJointed().tip_link = robot->jointed().tools[static_cast<std::size_t>(row)].tip_link;
    with.editJointed().X_LT = robot->jointed().tools[static_cast<std::size_t>(row)].X_LT;
    const Pose X_WT = tcpPose_W(with, context_.base_W(), context_.joints());
    using Role = SceneCurve::Role;
    const Role roles[3]{Role::kAxisX, Role::kAxisY, Role::kAxisZ};
    const char* const names[3]{"X", "Y", "Z"};
    for (int i = 0; i < 3; ++i) {
      dvec3 along(0.0);
      along[i] = kFrameLength;
      curves.push_back({{X_WT.p, X_WT * along}, roles[i], SceneCurve::Style::kSolid, 2.0, names[i]});
    }
  }
  context_.host().viewport().setCurves("tools", std::move(curves));
}

void ToolsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show();
}

void ToolsPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  drawFrame();
}

void ToolsPanel::change(int row, const std::function<void(std::vector<workcell::ToolFrame>&)>& edit) {
  const workcell::Entity* robot = context_.robot();
  if (!robot) return;
  workcell::SetTools command{robot->id, robot->jointed().tools};
  edit(command.tools);
  context_.host().documentModel().execute(command);
  tools_->setCurrentRow(row);
  show();
}

void ToolsPanel::addTool() {
  const workcell::Entity* robot = context_.robot();
  if (!robot) return;
  workcell::ToolFrame made{freeToolName(robot->jointed().tools), robot->jointed().tip_link, robot->jointed().X_LT};
  if (const int row = chosen(); row >= 0) {
    made.tip_link = robot->jointed().tools[static_cast<std::size_t>(row)].tip_link;
    made.X_LT = robot->jointed().tools[static_cast<std::size_t>(row)].X_LT;
  }
  change(static_cast<int>(robot->jointed().tools.size()), [&](auto& tools) { tools.push_back(made); });
}

void ToolsPanel::editTool() {
  const int row = chosen();
  if (row < 0 || showing_) return;
  const workcell::ToolFrame& before = context_.robot()->jointed().tools[static_cast<std::size_t>(row)];
  workcell::ToolFrame now = before;
  now.name = name_->text().trimmed().toStdString();
  now.tip_link = link_->currentText().toStdString();
  std::array<double, 6> numbers{};
  for (std::size_t i = 0; i < 6; ++i) numbers[i] = pose_[i]->value();
  const auto shown = poseNumbers(before.X_LT);
  const bool moved = !std::equal(numbers.begin(), numbers.end(), shown.begin(),
                                 [](double a, double b) { return std::abs(a - b) < 0.0501; });
  // Numbers that were not touched keep the digits that the fields do not show.
  for (std::size_t i = 0; i < 6; ++i)
    if (std::abs(numbers[i] - shown[i]) < 0.0501) numbers[i] = shown[i];
  if (moved) now.X_LT = poseFromNumbers(numbers);
  if (now.name == before.name && now.tip_link == before.tip_link && !moved) return;
  if (now.name.empty()) return showTool();
  change(row, [&](auto& tools) { tools[static_cast<std::size_t>(row)] = now; });
}

void ToolsPanel::removeTool() {
  const int row = chosen();
  if (row >= 0) change(std::max(0, row - 1), [&](auto& tools) { tools.erase(tools.begin() + row); });
}

void ToolsPanel::useTool() {
  if (const int row = chosen(); row >= 0)
    context_.host().documentModel().execute(workcell::ChooseTool{
        context_.robot()->id, context_.robot()->jointed().tools[static_cast<std::size_t>(row)].name});
}

void ToolsPanel::pick() {
  context_.host().viewport().startPick(
      {{},
       tr("Click a face, an edge or a corner for the tool centre point"),
       [this](const std::optional<PickedFeature>& feature) {
         const int row = chosen();
         if (!feature || row < 0) return;
         workcell::Entity with = *context_.robot();
         const workcell::ToolFrame& tool = with.jointed().tools[static_cast<std::size_t>(row)];
         with.editJointed().tip_link = tool.tip_link;
         with.editJointed().X_LT = Pose::identity();
         const Pose X_WL = tcpPose_W(with, context_.base_W(), context_.joints());
         const Pose X_LT = X_WL.inverse() * featureFrame_W(*feature);
         change(row, [&](auto& tools) { tools[static_cast<std::size_t>(row)].X_LT = X_LT; });
       }});
}

void ToolsPanel::attach(workcell::EntityId part) {
  const workcell::Entity* robot = context_.robot();
  if (!robot || part == 0) return;
  context_.host().documentModel().execute(
      workcell::Attach{part, robot->id, carrier_link_->currentText().toStdString()});
}

void ToolsPanel::mount(workcell::EntityId part) {
  const workcell::Entity* robot = context_.robot();
  DocumentModel& document = context_.host().documentModel();
  const workcell::Entity* carried = document.document().find(part);
  if (!robot || !carried) return;
  workcell::Entity with = *robot;
  with.editJointed().tip_link = carrier_link_->currentText().toStdString();
  with.editJointed().X_LT = Pose::identity();
  const Pose X_WL = tcpPose_W(with, context_.base_W(), context_.joints());
  document.executeAll(
      tr("Mount %1 on %2").arg(QString::fromStdString(carried->name), QString::fromStdString(robot->name)),
      {workcell::SetConfiguration{part, X_WL, carried->robot() ? carried->joints() : std::vector<double>{}},
       workcell::Attach{part, robot->id, with.jointed().tip_link}});
}

}  // namespace hapticell::app
