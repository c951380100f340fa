// SPDX-License-Identifier: BSD-3-Clause
// JSON with keys in the order in which they are given.
#pragma once

#include <nlohmann/json.hpp>

#include "base/vec.h"

namespace octet {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline Json vec_json(const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); }

}  // namespace octet
