// SPDX-License-Identifier: BSD-3-Clause
// Second readings: of parts whose solids cannot be joined, or of whose faces some cross or touch.
#pragma once

#include <functional>
#include <string>

#include "geom/model.h"
#include "geom/occt/reader.h"

namespace octet {

/// What `read` makes of the job. Where its solids cannot be joined, for that takes too long, needs too much
/// memory or crashes OCCT, what it makes of the job without: each by itself, with a fault that says so.
[[nodiscard]] Model read_at_least_apart(const ReadJob& job, const std::function<Model(const ReadJob&)>& read);

/// The job read with the faces that cross cut along each other, and of the solids what they enclose: three
/// times at most, as long as fewer cross by it and nothing else changes, or `model` as it was, with a note
/// that says why. The job is left with the pairs that were cut. `model`: of the job as it is.
[[nodiscard]] Model read_united(ReadJob& job, Model model);

/// The job read with the faces that touch imprinted on each other, where nothing is lost by it; or `model` as
/// it was, with a note that says why. `model`: of the job as it is.
[[nodiscard]] Model read_imprinted(ReadJob job, Model model);

/// The model with one note more.
[[nodiscard]] Model with_note(const Model& model, const std::string& note);

}  // namespace octet
