// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/zone_contacts.h"

#include "collision/contacts/contact_finder.h"

namespace hapticell::collision {

ZoneContacts zoneContacts(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                          const ZoneOptions& options) {
  return ContactFinder(ContactFinder::Ways::kFacets).find(moving, environment, options);
}

}  // namespace hapticell::collision
