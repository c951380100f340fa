// SPDX-License-Identifier: BSD-3-Clause
// glibc's heap: no mappings of its own for large blocks, nothing given back, large pages.
#include "app/heap.h"

#include <cstdint>
#include <cstdlib>  // tells whether the library is glibc
#include <fstream>

// Sanitizers have a heap of their own, in which a large block costs memory.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define OCTET_SETS_UP_HEAP 1
#else
#define OCTET_SETS_UP_HEAP 0
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#undef OCTET_SETS_UP_HEAP
#define OCTET_SETS_UP_HEAP 0
#endif
#endif

#if OCTET_SETS_UP_HEAP
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace octet {

#if OCTET_SETS_UP_HEAP
namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;
/// Addresses are taken for this share of the machine's memory; the heap goes on growing beyond them, in pages
/// of the usual size.
constexpr std::size_t kShare = 4;

bool address_space_is_limited() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY ||
         getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

/// Whether the system counts addresses as memory, of which others would then have the less.
bool addresses_are_accounted() {
  std::ifstream file("/proc/sys/vm/overcommit_memory");
  return file.get() == '2';
}

}  // namespace

void set_up_heap() {
  if (address_space_is_limited() || addresses_are_accounted()) return;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return;
  const std::size_t size = static_cast<std::size_t>(pages) * static_cast<std::size_t>(page) / kShare;
  // A block that is freed at once leaves its addresses at the end of the heap, where all others come from.
  void* const block = std::malloc(size);
  if (block == nullptr) return;
  const std::uintptr_t first =
      (reinterpret_cast<std::uintptr_t>(block) + kLargePage - 1) / kLargePage * kLargePage;
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(block) + size) / kLargePage * kLargePage;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);  // NOLINT: a wish
  std::free(block);
}
#else
void set_up_heap() {}
#endif

}  // namespace octet
