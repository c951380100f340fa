// SPDX-License-Identifier: BSD-3-Clause
// Names, colours, layers and materials from the file's labels to the model's entities.
#pragma once

#include "geom/model.h"
#include "geom/occt/document.h"
#include "geom/occt/numbering.h"

namespace octet {

/// Marks the entities of `parts` and fills its provenance; after number_entities() and fill_topology().
/// A whole's colour and layer go down to its solids and faces, its material to its solids, the name of a part
/// (not of an assembly) to its solids; what a label says of a sub-shape itself goes before that. Of entities
/// that became one, the lowest number's marks stand where it has any.
void mark_entities(const CadDocument& document, const ShapeMaps& as_read, const Numbering& numbering,
                   ModelParts& parts);

}  // namespace octet
