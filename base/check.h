// SPDX-License-Identifier: BSD-3-Clause
// CHECK: cheap, always on, a bug of ours when it fails. DCHECK: the same in debug builds only.
#pragma once

namespace octet {

/// Throws `Bug` (base/error.h) with the condition's text and place.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace octet

#define OCTET_CHECK(condition) ((condition) ? void(0) : ::octet::check_failed(#condition, __FILE__, __LINE__))

#ifdef NDEBUG
#define OCTET_DCHECK(condition) void(0)
#else
#define OCTET_DCHECK(condition) OCTET_CHECK(condition)
#endif
