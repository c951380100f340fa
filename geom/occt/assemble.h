// SPDX-License-Identifier: BSD-3-Clause
// An OCCT document to all that makes a model.
#pragma once

#include "geom/occt/document.h"
#include "geom/occt/read_part.h"

namespace octet {

/// OCCT's readers, mesher and boolean operations keep global state: whoever calls assemble() or
/// read_document() holds this lock.
class OcctLock {
 public:
  OcctLock();
  ~OcctLock();
  OcctLock(const OcctLock&) = delete;
  OcctLock& operator=(const OcctLock&) = delete;
};

/// Solids, numbers, topology, measures and facets. Triangulates document.shape in place. Under OcctLock.
[[nodiscard]] ModelParts assemble(const CadDocument& document, const ReadOptions& options);

}  // namespace octet
