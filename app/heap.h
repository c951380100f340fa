// SPDX-License-Identifier: BSD-3-Clause
// The program's heap, set up for arrays of many millions of entries.
#pragma once

namespace octet {

/// What is freed stays with the process, and memory comes in large pages where the system has them: every
/// stage of a mesh makes arrays of hundreds of megabytes, and to get each of their pages from the system anew
/// is a sixth of a run. Takes addresses for a part of the machine's memory, no memory. To be called once,
/// before other threads begin; does nothing where the C library is another than glibc, or where addresses are
/// limited or counted as memory. For the program alone: a library leaves the heap to its caller.
void set_up_heap();

}  // namespace octet
