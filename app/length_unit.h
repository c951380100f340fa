// SPDX-License-Identifier: BSD-3-Clause
// The units of length a user may name.
#pragma once

#include <string>
#include <string_view>

namespace octet {

struct LengthUnit {
  std::string name;          ///< "millimetre", "inch", ...
  double millimetres = 1.0;  ///< one of it, in millimetre
};

/// By name, plural or symbol, in any case: mm, cm, m, um, nm, km, in, ft, yd, mil, ... InputError otherwise.
[[nodiscard]] LengthUnit length_unit(std::string_view text);

}  // namespace octet
