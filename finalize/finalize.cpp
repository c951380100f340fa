// SPDX-License-Identifier: BSD-3-Clause
// Mesh finalization: the shapes of a valid classified mesh made good, on the exact geometry.
#include "finalize/finalize.h"

#include <optional>

#include "base/check.h"
#include "finalize/in_blocks.h"
#include "finalize/schedule.h"

namespace octet {

FinalizeReport finalize(Mesh& mesh, const Model& model, const FinalizeOptions& options, Observer& observer) {
  OCTET_CHECK(static_cast<bool>(options.size_at));
  if (std::optional<FinalizeReport> report = finalize_in_blocks(mesh, model, options, observer))
    return *report;
  Workshop shop(mesh, model, options);
  Scheduled result = run_schedule(shop, Chosen::kByScope, observer);
  if (result.better) mesh = *std::move(result.better);
  return result.report;
}

}  // namespace octet
