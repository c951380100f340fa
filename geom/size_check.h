// SPDX-License-Identifier: BSD-3-Clause
// Whether sizes make sense, before anything is done with them.
#pragma once

#include "geom/size_plan.h"

namespace octet {

/// InputError for a number that is none, negative where it must not be, or without an effect: also of the
/// attributes, whose text it names. What they name is another question (selected_entities()).
void check_control(const SizeControl& control);

/// The field, with an InputError where it has a size that is no positive number; empty as it is.
[[nodiscard]] SizeField checked(SizeField field);

}  // namespace octet
