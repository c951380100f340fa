// SPDX-License-Identifier: BSD-3-Clause
// The exceptions Octet throws: one type per cause, each with one clear line for the user.
#pragma once

#include <stdexcept>
#include <string>

#include "base/model_ref.h"

namespace octet {

/// Root of all exceptions thrown by Octet. `what()` is one line, fit to print.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The input file or an option cannot be used (missing, empty, truncated, not CAD, bad size).
class InputError : public Error {
 public:
  using Error::Error;
};

/// The part was read, but is no model that can be meshed (open shell, no solid); names the entity.
class ModelError : public InputError {
 public:
  ModelError(const std::string& message, ModelRef entity) : InputError(message), entity_(entity) {}
  [[nodiscard]] ModelRef entity() const { return entity_; }

 private:
  ModelRef entity_;
};

/// A stated limit (elements, memory, time) would be passed.
class LimitError : public Error {
 public:
  using Error::Error;
};

/// The output cannot be written (path, permission, full disk).
class OutputError : public Error {
 public:
  using Error::Error;
};

/// The observer asked to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

/// A defect of Octet itself.
class Bug : public Error {
 public:
  using Error::Error;
};

}  // namespace octet
