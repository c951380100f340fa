// SPDX-License-Identifier: BSD-3-Clause
// Entities and their adjacency, from the B-rep.
#pragma once

#include "geom/model.h"
#include "geom/occt/numbering.h"

namespace octet {

/// Fills vertices, edges, faces and regions of `parts`: adjacency, orientation, use, Euler characteristic,
/// parameter ranges. Measures (tolerance, length, area, volume) are left to measure().
/// ModelError: an edge without curve or vertices, a face without a surface.
void fill_topology(const Numbering& numbering, ModelParts& parts);

/// The exact curves, surfaces and trims; requires the edges' use, which fill_topology() tells.
void make_geometry(const Numbering& numbering, ModelParts& parts);

}  // namespace octet
