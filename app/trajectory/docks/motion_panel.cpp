// SPDX-License-Identifier: Apache-2.0
// How the panel is put together; what its buttons do stands in motion_panel_edit.cpp.
#include "app/trajectory/docks/motion_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/trajectory/docks/clean_fields.h"
#include "app/trajectory/docks/motion_facts.h"
#include "app/trajectory/docks/named_field.h"
#include "app/trajectory/docks/program_fields.h"
#include "app/trajectory/docks/recording_fields.h"
#include "app/trajectory/docks/timing_fields.h"
#include "app/trajectory/motions/motion_export.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/motions/motion_player.h"
#include "app/trajectory/motions/motion_work.h"

namespace hapticell::app {
namespace {

QLabel* said(const char* name, int lines) {
  auto* label = makeLive(lines, TextRole::kSecond, true);
  label->setObjectName(name);
  return label;
}

}  // namespace

MotionPanel::MotionPanel(const Parts& parts, QWidget* parent)
    : QWidget(parent),
      list_(parts.list),
      player_(parts.player),
      work_(parts.work),
      files_(parts.files),
      bar_(parts.bar) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addRecording(*column);
  addMotion(*column);
  addShape(*column);
  addFrames(*column);
  addClean(*column);
  addTiming(*column);
  addCheck(*column);
  addExport(*column);
  column->addStretch(1);
  connect(&list_, &MotionList::changed, this, &MotionPanel::show);
  connect(&list_, &MotionList::currentChanged, this, [this] {
    setFrame({});
    show();
    showCheck();
  });
  const auto follow_robot = [this] {
    const Motion* motion = list_.current();
    program_->setRobot(motion && motion->entity ? motion->entity->robot().get() : nullptr);
  };
  connect(&list_, &MotionList::changed, this, follow_robot);
  connect(&list_, &MotionList::currentChanged, this, follow_robot);
  connect(&player_, &MotionPlayer::changed, this, &MotionPanel::showFrame);
  connect(&bar_, &TimeBar::partChanged, this, &MotionPanel::showFrame);
  show();
  showCheck();
}

QPushButton* MotionPanel::action(const char* name, const QString& text, const QString& tip, std::function<void()> act) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, std::move(act));
  need_motion_.push_back(button);
  return button;
}

void MotionPanel::addRecording(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Recording"));
  recording_ = new RecordingFields(*section, this);
  auto* words = makeLabel(tr("R records, Shift+R adds a frame. Recording starts with the first motion."),
                          TextRole::kSecond, true);
  words->setWordWrap(true);
  section->addWidget(words);
}

void MotionPanel::addMotion(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Motion"));
  facts_ = new MotionFacts(list_, *section, this);
  auto* import = new QPushButton(tr("Import…"));
  import->setObjectName("buttonImportMotion");
  connect(import, &QPushButton::clicked, this, [this] { files_.askImport(); });
  section->addWidget(sideBySide(
      {import, action("buttonRemoveMotion", tr("Remove"), tr("Removes it from the cell; its file stays"), [this] {
         if (const Motion* motion = list_.current()) list_.remove(motion->name);
       })}));
  facts_->addResult(*section);
}

void MotionPanel::addClean(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Clean"));
  clean_ = new CleanFields(*section, this);
  sections_.emplace_back(tr("Clean"), clean_->firstRow());
  section->addWidget(sideBySide(
      {action("buttonSmoothMotion", tr("Smooth"), tr("Remove hand tremor, keep the path"), [this] { smooth(); }),
       action("buttonSimplify", tr("Simplify"), tr("Keep only the frames needed"),
              [this] { work_.simplify(clean_->tolerance()); })}));
}

void MotionPanel::addTiming(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Timing"));
  timing_ = new TimingFields(*section, this);
  section->addWidget(action("buttonRetime", tr("Retime"), tr("New timing along the same path"), [this] { retime(); }));
}

void MotionPanel::addCheck(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Check"));
  section->addWidget(action("buttonCheckMotion", tr("Check the whole path"),
                            tr("Limits, singularities, configurations and collisions, also between frames"),
                            [this] { work_.check(); }));
  findings_ = new QListWidget;
  findings_->setObjectName("listFindings");
  findings_->setAccessibleName(tr("Check results"));
  findings_->setFrameShape(QFrame::NoFrame);
  findings_->setFixedHeight(108);
  findings_->setWordWrap(true);
  section->addWidget(findings_);
  connect(findings_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item && item->data(Qt::UserRole).isValid()) player_.seek(item->data(Qt::UserRole).toDouble());
  });
}

void MotionPanel::addExport(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Export"));
  program_ = new ProgramFields(*section, this);
  sections_.emplace_back(tr("Export"), program_->firstRow());
  section->addWidget(
      action("buttonExport", tr("Export…"), tr("Tool, base and safety settings stay those of the controller"),
             [this] { files_.askExport(program_->format(), program_->options(), clean_->tolerance()); }));
}

void MotionPanel::addShape(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Change"));
  const auto one = [](auto&& made) -> Expected<std::vector<trajectory::Trajectory>> {
    return std::vector<trajectory::Trajectory>{std::forward<decltype(made)>(made)};
  };
  section->addWidget(sideBySide(
      {action("buttonMarkPart", tr("Range"),
              tr("Brackets in the time bar: the range that Trim keeps and Delete removes"),
              [this] {
                if (bar_.part()) return bar_.setPart({});
                const auto& playback = player_.playback();
                const double length = playback.end() - playback.begin();
                bar_.setPart(TimeBar::Part{playback.begin() + 0.25 * length, playback.begin() + 0.75 * length});
              }),
       action("buttonTrimMotion", tr("Trim"), tr("Keep the range between the brackets"), [this] { trim(); }),
       action("buttonSplit", tr("Split"), tr("Split at the cursor"), [this] {
         const double t = player_.playback().time();
         work_.edit(tr("split"), [t](const auto& given) -> Expected<std::vector<trajectory::Trajectory>> {
           auto parts = trajectory::splitAt(given, t);
           HAPTICELL_TRY(parts);
           return std::vector<trajectory::Trajectory>{std::move(parts->first), std::move(parts->second)};
         });
       })}));
  mirror_ = new QComboBox;
  mirror_->setObjectName("comboMirror");
  mirror_->setAccessibleName(tr("Mirror plane"));
  mirror_->addItems({tr("on X = 0"), tr("on Y = 0"), tr("on Z = 0")});
  mirror_->setCurrentIndex(1);
  section->addWidget(sideBySide(
      {action("buttonReverseMotion", tr("Reverse"), tr("Play the motion backwards"),
              [this, one] {
                work_.edit(tr("reversed"), [one](const auto& given) { return one(trajectory::reversed(given)); });
              }),
       action("buttonMirrorMotion", tr("Mirror"), tr("Mirror the motion, as a partner on the other side would do it"),
              [this, one] {
                dvec3 normal(0.0);
                normal[mirror_->currentIndex()] = 1.0;
                work_.edit(tr("mirrored"), [one, normal](const auto& given) {
                  return one(trajectory::mirrored(given, dvec3(0.0), normal));
                });
              }),
       mirror_}));
  way_ = namedField("fieldWay", {tr("mm"), 0, 1, 2000, 10}, 50);
  way_->setToolTip(tr("Length of the approach or retract, along the tool's axis"));
  section->addWidget(sideBySide(
      {action("buttonApproach", tr("Approach"), tr("Add a straight move to the first frame"), [this] { addWay(true); }),
       action("buttonRetract", tr("Retract"), tr("Add a straight move from the last frame"), [this] { addWay(false); }),
       way_}));
  section->addWidget(action("buttonJoin", tr("Join with the next"),
                            tr("This motion and the one below it, one after the other"), [this] {
                              const auto& all = list_.motions();
                              for (std::size_t i = 0; i + 1 < all.size(); ++i)
                                if (list_.current() && all[i].name == list_.current()->name)
                                  return work_.join({all[i].name, all[i + 1].name});
                              showLine(tr("There is no motion below this one."), true);
                            }));
}

void MotionPanel::addFrames(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Frame"));
  frame_label_ = said("labelFrame", 2);
  section->addWidget(frame_label_);
  reach_ = namedField("fieldReach", {tr("s"), 2, 0, 60, 0.1}, 0.5);
  reach_->setToolTip(tr("Frames within this time follow when you move a frame"));
  addRow(*section, tr("Blend over"), reach_);
  dwell_ = namedField("fieldDwell", {tr("s"), 2, 0, 3600, 0.5}, 0.0);
  auto* dwell =
      action("buttonDwell", tr("Dwell here"), tr("Process point: the motion pauses here for this time"), [this] {
        if (!frame_) return;
        work_.edit(
            tr("with a dwell"),
            [i = *frame_, s = dwell_->value()](const auto& given) -> Expected<std::vector<trajectory::Trajectory>> {
              auto made = trajectory::withDwell(given, i, s);
              HAPTICELL_TRY(made);
              return std::vector<trajectory::Trajectory>{std::move(*made)};
            });
      });
  section->addWidget(sideBySide({dwell, dwell_}));
  auto* insert = action("buttonInsertFrame", tr("Insert"), tr("Add a frame at the cursor, then drag it in the scene"),
                        [this] { insertFrame(); });
  auto* remove = action("buttonDeleteFrame", tr("Delete"), tr("Delete the frame, or all frames between the brackets"),
                        [this] { deletePart(); });
  section->addWidget(sideBySide({insert, remove}));
  need_frame_ = {dwell};
}

}  // namespace hapticell::app
