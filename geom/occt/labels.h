// SPDX-License-Identifier: BSD-3-Clause
// Names, colours, layers and materials of an XCAF document, and its tree of parts.
#pragma once

#include <TDocStd_Document.hxx>

#include "geom/occt/document.h"

namespace octet {

/// Fills shape, labels and tree of `result` from the document's free shapes.
void collect_labels(const Handle(TDocStd_Document) & document, CadDocument& result);

}  // namespace octet
