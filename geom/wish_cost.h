// SPDX-License-Identifier: BSD-3-Clause
// What a size asked for at a place costs, before anything is made of it.
#pragma once

#include <utility>
#include <vector>

#include "geom/size_plan.h"

namespace octet {

using SizedEntities = std::vector<std::pair<ModelRef, double>>;

/// Tetrahedra that the attribute asks for by itself, by lengths, areas and volumes: to a factor of two on
/// most parts, for sizes double away from it and octants come in powers of two. `sized`: its entities with
/// the sizes wished for, empty for a shape, which has the size of the attribute. What is no finer than
/// `coarsest`, the size elsewhere, costs nothing; vertices cost nothing.
[[nodiscard]] WishCost wish_cost(const Model& model, const SizeAttribute& attribute,
                                 const SizedEntities& sized, double coarsest, std::size_t max_elements);

/// LimitError where the attribute alone asks for so many elements that no octree for it has fewer than the
/// limit, or for octants smaller than there are.
void check_wish(const Model& model, const SizeAttribute& attribute, const SizedEntities& sized,
                const WishCost& cost, std::size_t max_elements);

/// The line of a LimitError.
[[nodiscard]] std::string too_costly(const WishCost& cost, std::size_t max_elements);

}  // namespace octet
