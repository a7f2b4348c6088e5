// SPDX-License-Identifier: Apache-2.0
#include "app/shell/status_text.h"

#include <QObject>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/shell/status_line.h"
#include "app/style/library_text.h"

namespace hapticell::app {

void StatusText::show() {
  const auto& now = host_.snapshot();
  const auto count = host_.documentModel().document().state().entities.size();
  const QString still = count == 0 ? QObject::tr("The cell is empty.")
                                   : QObject::tr("%n entities in the cell.", nullptr, static_cast<int>(count));
  if (!now) {
    line_.setSentence(Mark::kNone, still);
    StatusLine::Rates idle;
    line_.setRates(idle);
    return;
  }
  Mark mark = Mark::kNone;
  if (!now->pairs.empty() && now->pairs.front().near_miss) mark = Mark::kNearMiss;
  if (!now->limits.empty()) mark = Mark::kLimit;
  if (!now->pairs.empty() && now->pairs.front().contact) mark = Mark::kContact;
  const QString sentence = now->problem.empty() ? shownText(now->status) : shownText(now->problem);
  line_.setSentence(mark, sentence.isEmpty() ? still : sentence);
  StatusLine::Rates rates;
  rates.haptic_hz = now->server.rate_hz;
  rates.collision_hz = now->rate_manipulation_hz;
  rates.window_hz = gui_rate_;
  rates.idle = now->idle;
  rates.collision_full = host_.configuration().manipulation.rate_hz;
  rates.window_full = host_.configuration().gui.rate_hz;
  line_.setRates(rates);
}

bool StatusText::showNumbers(bool now) {
  if (!now && since_numbers_.isValid() && since_numbers_.elapsed() < 100) return false;
  since_numbers_.start();
  show();
  return true;
}

}  // namespace hapticell::app
