// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/contacts/contact_finder.h"

namespace hapticell::manipulation {

class PreparedScene;

/// Searches for contacts in a separate thread, one question after the other, while the manipulation loop continues.
///
/// All calls belong to one thread (the loop's) and never wait longer than it takes to move a pointer.
class ContactSearch {
 public:
  /// The arguments of collision::ContactFinder::find() and its answer. `mask` is its pair mask.
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
  /// Waits for a running search.
  ~ContactSearch();
  ContactSearch(const ContactSearch&) = delete;
  ContactSearch& operator=(const ContactSearch&) = delete;

  /// True if no search runs and no answer waits.
  bool isFree() const;
  /// Starts the search for a question. Contract: isFree().
  void ask(std::unique_ptr<Question> question);
  bool isAnswered() const;
  /// The answered question; null if there is no answer yet.
  std::unique_ptr<Question> take();
  /// Discards the answer of the running search.
  void drop();

 private:
  struct Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace hapticell::manipulation
