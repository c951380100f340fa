// SPDX-License-Identifier: BSD-3-Clause
// Code for wider registers beside that for every machine.
#pragma once

#include <cstddef>

/// Before the definition of a function: it is compiled twice, and the loader takes the version that the
/// processor can run. Wider registers do more at once, never differently: no multiplication is fused with an
/// addition, so the bits are the same. Sanitizers do not bear with the loader's choice.
#if defined(__x86_64__) && defined(__ELF__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define OCTET_WIDE_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define OCTET_WIDE_CLONES
#endif
#if defined(__has_feature)
#if __has_feature(thread_sanitizer) || __has_feature(address_sanitizer)
#undef OCTET_WIDE_CLONES
#define OCTET_WIDE_CLONES
#endif
#endif

/// Before the definition of what such a function calls: what is inlined becomes part of each version.
#define OCTET_LANEWISE [[gnu::always_inline]] inline

// Lanes are handed over within a file alone, so that no caller need know in which registers.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace octet {

constexpr std::size_t kLanes = 4;

/// Elementwise arithmetic; a type of the compiler's, for which it makes code for several machines.
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double)), aligned(kLanes * sizeof(double))));

}  // namespace octet
