// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/reach_lines.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/mannequin/figure_drag.h"
#include "app/mannequin/hand_gizmo.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/icon.h"
#include "app/style/library_text.h"
#include "app/style/theme.h"
#include "app/style/units.h"

namespace hapticell::app {

ReachLines::ReachLines(MannequinContext& context, FigureDrag& drag, QVBoxLayout& section, QObject* parent)
    : QObject(parent), context_(context), drag_(drag) {
  auto* line = new QHBoxLayout;
  mark_ = new QLabel;
  mark_->setFixedWidth(18);
  words_ = makeLive(2, TextRole::kText);
  words_->setObjectName("labelReach");
  line->addWidget(mark_, 0, Qt::AlignTop);
  line->addWidget(words_, 1);
  section.addLayout(line);
  advice_ = makeLive(2, TextRole::kSecond, true);
  advice_->setObjectName("labelReachAdvice");
  section.addWidget(advice_);
}

void ReachLines::show() {
  const HoldChoice& choice = context_.host().holdChoice();
  QString text = reachText(drag_, choice.movedBy()), advice;
  const auto& snapshot = context_.host().snapshot();
  if (context_.isHeld() && snapshot && !snapshot->limits.empty() && snapshot->limits.front().holds)
    text = shownText(snapshot->limits.front().text);
  if (!text.isEmpty() && drag_.reach() && drag_.reach()->obstacle.empty()) {
    advice = choice.hands().locks.trunk
                 ? QObject::tr("At full reach with the trunk locked. Unlock the trunk, or move it %1 closer.")
                 : QObject::tr("At full reach. Move it %1 closer, or unlock the feet.");
    advice = advice.arg(lengthText(0.01 * std::ceil(100.0 * drag_.reach()->short_m + 0.8), 0));
  }
  const bool any = !text.isEmpty();
  mark_->setPixmap(any ? icon("limit", themeOf(words_->palette()).limit).pixmap(16, 16) : QPixmap());
  words_->setText(any ? text : QObject::tr("Drag the arrows at the hand, or hold it with the stylus."));
  words_->setForegroundRole(any ? QPalette::WindowText : kQuietText);
  advice_->setText(advice);
}

}  // namespace hapticell::app
