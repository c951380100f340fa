// SPDX-License-Identifier: BSD-3-Clause
// From tags to numbers as read to ids.
#include "app/ids_in_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace octet {

IdsInFile::IdsInFile(const Model& model) : model_(model) {
  if (model.provenance().id_mark.empty()) return;
  for (int dim = 0; dim < 4; ++dim)
    if (!model.provenance().as_read[static_cast<std::size_t>(dim)].empty())
      sources_[static_cast<std::size_t>(dim)] = sources(model.provenance(), dim, model.count(dim));
}

std::vector<std::string> IdsInFile::of(ModelRef entity) const {
  if (!entity.valid()) return {};
  const auto& numbers = sources_[static_cast<std::size_t>(entity.dim)];
  const auto tag = static_cast<std::size_t>(entity.tag);
  if (tag >= numbers.size()) return {};
  return ids_in_file(model_.provenance(), entity.dim, numbers[tag]);
}

std::string IdsInFile::text(ModelRef entity) const {
  constexpr std::size_t kTold = 3;
  std::vector<std::string> ids = of(entity);
  if (ids.empty()) return {};
  const std::size_t more = ids.size() > kTold ? ids.size() - kTold : 0;
  ids.resize(ids.size() - more);
  return fmt::format(" ({}{})", fmt::join(ids, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace octet
