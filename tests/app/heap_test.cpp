// SPDX-License-Identifier: BSD-3-Clause
#include "app/heap.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>

// Each in a process of its own: a heap is set up once and for good.
namespace octet {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

template <class Work>
int exit_code_of(const Work& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool is_resident(std::uintptr_t place) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  unsigned char there = 0;
  return mincore(reinterpret_cast<void*>(place / page * page), page, &there) == 0 && (there & 1) != 0;
}

/// Whether the middle of a large block is still the process's after it was freed.
bool keeps_large_blocks() {
  constexpr std::size_t kSize = 64 * kMegabyte;
  void* const block = std::malloc(kSize);
  if (block == nullptr) return false;
  std::memset(block, 1, kSize);
  const std::uintptr_t middle = reinterpret_cast<std::uintptr_t>(block) + kSize / 2;
  asm volatile("" : : "r"(block) : "memory");  // the compiler may not see that nobody reads it
  std::free(block);
  return is_resident(middle);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Heap, KeepsWhatIsFreed) {
  EXPECT_EQ(exit_code_of([] { return keeps_large_blocks() ? 1 : 0; }), 0)
      << "without it: the test tests nothing";
  EXPECT_EQ(exit_code_of([] {
              set_up_heap();
              return keeps_large_blocks() ? 1 : 0;
            }),
            1);
}

TEST(Heap, TakesAddressesNotMemory) {
  EXPECT_EQ(exit_code_of([] {
              rusage before{}, after{};
              getrusage(RUSAGE_SELF, &before);
              set_up_heap();
              getrusage(RUSAGE_SELF, &after);
              return after.ru_maxrss - before.ru_maxrss < 8 * 1024 ? 0 : 1;  // kibibytes
            }),
            0);
}

TEST(Heap, IsLeftAloneWhereAddressesAreLimited) {
  EXPECT_EQ(exit_code_of([] {
              const rlimit limit{2048 * kMegabyte, 2048 * kMegabyte};
              if (setrlimit(RLIMIT_AS, &limit) != 0) return 2;
              set_up_heap();
              return keeps_large_blocks() ? 1 : 0;
            }),
            0);
}
#endif

}  // namespace
}  // namespace octet
