// SPDX-License-Identifier: BSD-3-Clause
// Which errors are the caller's.
#include "app/failure.h"

#include <new>

#include "base/error.h"

namespace octet {

Failure failure_of(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const Cancelled& error) {
    return {kExitFailed, error.what()};
  } catch (const Bug& error) {
    return {kExitFailed, error.what()};
  } catch (const Error& error) {
    return {kExitBadInput, error.what()};
  } catch (const std::bad_alloc&) {
    return {kExitFailed, "out of memory; ask for a larger --size"};
  } catch (const std::exception& error) {
    return {kExitFailed, std::string("internal error: ") + error.what()};
  } catch (...) {
    return {kExitFailed, "internal error"};
  }
}

}  // namespace octet
