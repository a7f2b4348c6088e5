// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "agents/runner/agent_session.h"
#include "app/agents/agent_hand.h"
#include "app/agents/agent_setup.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class AgentRow;
class Host;
class LiveLabel;
class ValueField;

/// Sets up a run of agents on the open cell, shows it while it goes on in a thread of its own, and adopts its result.
/// The document changes only when the result is adopted. GUI thread.
class AgentsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit AgentsPanel(Host& host, QWidget* parent = nullptr);
  ~AgentsPanel() override;
  /// Ends the run; the entity is again where the document has it.
  void stop();
  /// The run; null: none.
  const agents::AgentSession* session() const { return session_.get(); }

 private:
  void addSetup(QVBoxLayout& column);
  void addAgents(QVBoxLayout& column);
  void addRun(QVBoxLayout& column);
  void addResult(QVBoxLayout& column);
  QPushButton* button(const char* name, const QString& text, void (AgentsPanel::*act)());
  void takeEntity();
  void takeGoal();
  void pickGoal();
  void setGoal(const dvec3& p_WG, workcell::EntityId look_at);
  void showSetup();
  void makeRows();
  void sendRows();
  void start();
  void pause();
  void stepOnce();
  void begin(bool one_step);
  void look();
  void showRun();
  void showButtons();
  void askPlanner();
  void takeByHand();
  void adopt();
  void keepMotion();
  void saveWishes();
  QString words(const agents::AgentSession::State& state) const;

  Host& host_;
  AgentSetup setup_;
  std::unique_ptr<agents::AgentSession> session_;
  std::optional<agents::AgentSession::State> last_;
  std::vector<AgentRow*> rows_;
  AgentHand hand_;
  struct Widgets {
    LiveLabel *entity = nullptr, *look_at = nullptr, *says = nullptr, *figures = nullptr;
    QComboBox* side = nullptr;
    QWidget* side_row = nullptr;
    ValueField* goal[3] = {};
    QVBoxLayout* rows = nullptr;
    QPushButton *start = nullptr, *pause = nullptr, *step = nullptr, *stop = nullptr, *planner = nullptr,
                *by_hand = nullptr, *adopt = nullptr, *motion = nullptr, *wishes = nullptr;
    QCheckBox* stylus = nullptr;
  } on_;
  bool preparing_ = false;
  QString problem_;
};

}  // namespace hapticell::app
