// SPDX-License-Identifier: BSD-3-Clause
// Parts that must have a complete mesh at each of some sizes.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "app/mesh_part.h"

namespace octet::test {

inline void expect_complete(const Model& model, std::initializer_list<double> sizes,
                            const std::string& name = "") {
  for (const double size : sizes) {
    MeshOptions options;
    options.size = size;
    const MeshReport report = mesh_part(model, options).report;
    EXPECT_EQ(report.status, MeshStatus::kComplete)
        << name << " at " << size << ": " << (report.faults.empty() ? "" : report.faults[0].cause);
  }
}

}  // namespace octet::test
