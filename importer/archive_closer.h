// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <archive.h>

namespace hapticell::importer {

struct ArchiveCloser {
  void operator()(archive* a) const { archive_read_free(a); }
};

}  // namespace hapticell::importer
