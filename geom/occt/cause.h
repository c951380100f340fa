// SPDX-License-Identifier: BSD-3-Clause
// What an exception of OCCT's says.
#pragma once

#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>
#include <string>

namespace octet {

/// Its message; the name of its class where it has none, as most have.
[[nodiscard]] inline std::string cause_of(const Standard_Failure& failure) {
  const std::string message = failure.GetMessageString();
  return message.empty() ? std::string("OCCT raised ") + failure.DynamicType()->Name() : message;
}

}  // namespace octet
