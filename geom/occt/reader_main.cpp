// SPDX-License-Identifier: BSD-3-Clause
// octet-reader: reads a part for a program with several threads. Started by the library, not by hand.
#include "geom/occt/reader.h"

int main() { return octet::serve_helper(octet::reader_version(), octet::serve_job); }
