// SPDX-License-Identifier: BSD-3-Clause
// A fault: a goal not met, told in the terms of the CAD part.
#pragma once

#include <string>

#include "base/model_ref.h"
#include "base/vec.h"

namespace octet {

/// One thing that is wrong or was not met; a value in the report, never an exception.
struct Fault {
  ModelRef entity;            ///< the model entity at fault, in the user's numbering
  Vec3 place = Vec3::Zero();  ///< where, in model units (millimetre)
  std::string cause;          ///< what is wrong, one sentence
  std::string advice;         ///< what the user can do about it, one sentence
  ModelRef as_read{};         ///< what of the file, by its number as read, where the model has nothing of it
};

}  // namespace octet
