// SPDX-License-Identifier: BSD-3-Clause
// In place of hdf5_file.cpp where the program is built without HDF5: no file can be made.
#include "base/error.h"
#include "io/hdf5_file.h"

namespace octet {

void check_hdf5() {
  throw InputError(
      "files of HDF5 cannot be written, for this program was built without it: take another format, or build "
      "the "
      "program where HDF5 is (Debian: libhdf5-dev)");
}

Hdf5File::Hdf5File(const OutputFile&, Order order) : order_(order) { check_hdf5(); }
Hdf5File::~Hdf5File() = default;
void Hdf5File::close() {}
void Hdf5File::group(const std::string&) {}
void Hdf5File::attribute(const std::string&, const char*, std::int32_t) {}
void Hdf5File::attribute(const std::string&, const char*, double) {}
void Hdf5File::attribute_array(const std::string&, const char*, std::int32_t) {}
void Hdf5File::attribute(const std::string&, const char*, const std::string&, std::size_t) {}
void Hdf5File::begin_array(const std::string&, Kind, const std::vector<std::uint64_t>&) {}
void Hdf5File::put(std::uint64_t, std::uint64_t, const void*) {}
void Hdf5File::end_array() {}
void Hdf5File::put_attribute(const std::string&, const char*, std::int64_t, const void*, bool) {}
void Hdf5File::texts(const std::string&, const std::vector<std::string>&, std::size_t) {}

}  // namespace octet
