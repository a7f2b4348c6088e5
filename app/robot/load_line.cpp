// SPDX-License-Identifier: Apache-2.0
#include "app/robot/load_line.h"

#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/robot/robot_context.h"
#include "app/style/live_label.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "workcell/robots/robot_library.h"

namespace hapticell::app {
namespace {

QString kilogramText(double kilograms) {
  return QObject::tr("%1 kg").arg(kilograms, 0, 'g', 4);
}

/// The robot and all that hangs on it, directly or not: the load depends on nothing else.
void addHanging(const workcell::DocumentState& state, const std::shared_ptr<const workcell::Entity>& carrier,
                std::vector<std::shared_ptr<const workcell::Entity>>& found) {
  found.push_back(carrier);
  for (const auto& entity : state.entities)
    if (entity->attachment.to == carrier->name) addHanging(state, entity, found);
}

}  // namespace

QString loadText(const workcell::CarriedLoad& load, double payload) {
  const QString allowed = payload > 0.0 ? kilogramText(payload) : QString();
  if (load.parts.empty())
    return allowed.isEmpty() ? QObject::tr("Load: none, payload unknown")
                             : QObject::tr("Load: none, payload %1").arg(allowed);
  const auto verdict = workcell::verdictOn(load, payload);
  QString text = allowed.isEmpty() ? QObject::tr("Load %1, payload unknown") : QObject::tr("Load %1 of %2 allowed");
  if (verdict == workcell::LoadVerdict::kTooHeavy) text = QObject::tr("Too heavy: %1 of %2 allowed");
  text = allowed.isEmpty() ? text.arg(kilogramText(load.mass)) : text.arg(kilogramText(load.mass), allowed);
  text +=
      QObject::tr(", centre %1 from %2").arg(lengthText(glm::length(load.p_LC), 0), QString::fromStdString(load.link));
  if (load.starting.empty()) return text;
  QStringList names;
  for (const std::string& name : load.starting) names << QString::fromStdString(name);
  return text + QLatin1Char('\n') +
         QObject::tr("Mass not entered, 1 kg assumed: %1").arg(names.join(QStringLiteral(", ")));
}

LoadLine::LoadLine(RobotContext& context, const char* name, QWidget* parent)
    : QWidget(parent), context_(context), words_(makeLive(3, TextRole::kSecond)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  words_->setObjectName(QLatin1String(name));
  column->addWidget(words_);
  connect(&context_, &RobotContext::robotChanged, this, &LoadLine::showLoad);
  connect(&context_, &RobotContext::documentChanged, this, &LoadLine::showLoad);
}

void LoadLine::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showLoad();
}

void LoadLine::showLoad() {
  const workcell::Entity* robot = context_.robot();
  if (!isVisible()) return;
  const workcell::DocumentState& state = context_.host().documentModel().document().state();
  std::vector<std::shared_ptr<const workcell::Entity>> hanging;
  for (const auto& entity : state.entities)
    if (robot && entity->id == robot->id) addHanging(state, entity, hanging);
  if (hanging == weighed_) return;
  weighed_ = std::move(hanging);
  if (weighed_.empty() || context_.isMechanism()) return words_->clear();
  const workcell::CarriedLoad load = workcell::carriedLoad(state, *robot);
  const Expected<double> payload = workcell::ratedPayload(robot->source.path);
  const double allowed = payload ? *payload : 0.0;
  words_->setText(loadText(load, allowed));
  const Theme& theme = themeOf(palette());
  const bool heavy = workcell::verdictOn(load, allowed) == workcell::LoadVerdict::kTooHeavy;
  QPalette colors = words_->palette();
  colors.setColor(QPalette::WindowText, heavy ? theme.words.limit : theme.text2);
  words_->setPalette(colors);
}

}  // namespace hapticell::app
