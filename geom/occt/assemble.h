// SPDX-License-Identifier: BSD-3-Clause
// An OCCT document to all that makes a model.
#pragma once

#include "geom/occt/child_process.h"
#include "geom/occt/document.h"
#include "geom/occt/heal.h"
#include "geom/occt/numbering.h"
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

struct AssembledPart {
  Numbering numbering;  ///< the shapes behind the tags
  ModelParts parts;
};

/// Solids, numbers, topology, measures, facets and marks; faces that cross or touch are dealt with as heal()
/// says. Triangulates document.shape in place. Under OcctLock.
[[nodiscard]] AssembledPart assemble(const CadDocument& document, const ReadOptions& options,
                                     const MeetingFaces& meeting, const StageLog& log);

}  // namespace octet
