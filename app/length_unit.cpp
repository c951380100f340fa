// SPDX-License-Identifier: BSD-3-Clause
// The table of units: every factor is exact by definition (1 inch = 25.4 mm since 1959).
#include "app/length_unit.h"

#include <fmt/format.h>

#include <cctype>
#include <initializer_list>

#include "base/error.h"

namespace octet {
namespace {

struct Row {
  const char* name;
  double millimetres;
  std::initializer_list<const char*> spellings;
};

const Row kRows[] = {
    {"millimetre", 1.0, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
    {"nanometre", 1e-6, {"nm", "nanometre", "nanometres", "nanometer", "nanometers"}},
    {"micrometre",
     1e-3,
     {"um", "micron", "microns", "micrometre", "micrometres", "micrometer", "micrometers"}},
    {"centimetre", 10.0, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
    {"metre", 1e3, {"m", "metre", "metres", "meter", "meters"}},
    {"kilometre", 1e6, {"km", "kilometre", "kilometres", "kilometer", "kilometers"}},
    {"mil", 0.0254, {"mil", "mils", "thou"}},
    {"inch", 25.4, {"in", "inch", "inches"}},
    {"foot", 304.8, {"ft", "foot", "feet"}},
    {"yard", 914.4, {"yd", "yard", "yards"}},
};

}  // namespace

LengthUnit length_unit(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const Row& row : kRows)
    for (const char* spelling : row.spellings)
      if (lower == spelling) return {row.name, row.millimetres};
  throw InputError(
      fmt::format("unknown unit '{}'; use one of mm, um, nm, cm, m, km, mil, inch, ft, yd", text));
}

}  // namespace octet
