// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/contacts/contact_finder.h"

namespace hapticell::manipulation {

class PreparedScene;

/// Looks for contacts in a thread of its own, one question after the other, while the manipulation loop goes on.
///
/// All calls belong to one thread (the loop's) and never wait longer than it takes to move a pointer.
class ContactSearch {
 public:
  /// What collision::ContactFinder::find() is asked, and what came of it. `mask` is its pair mask.
  struct Question {
    std::shared_ptr<collision::ContactFinder> finder;
    std::shared_ptr<const PreparedScene> scene;  ///< Keeps the parts' shapes.
    std::vector<collision::ZonePart> moving, environment;
    std::vector<std::uint8_t> mask;
    collision::ZoneOptions options;
    collision::ZoneContacts found;
  };

  /// Starts the thread.
  ContactSearch();
  /// Waits for the search that is under way, if any.
  ~ContactSearch();
  ContactSearch(const ContactSearch&) = delete;
  ContactSearch& operator=(const ContactSearch&) = delete;

  /// No search is under way and no answer waits.
  bool isFree() const;
  /// Takes a question; it isFree() (contract).
  void ask(std::unique_ptr<Question> question);
  bool isAnswered() const;
  /// The answered question; null while there is none.
  std::unique_ptr<Question> take();
  /// The answer to what was asked is not wanted any more.
  void drop();

 private:
  struct Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace hapticell::manipulation
