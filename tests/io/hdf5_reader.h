// SPDX-License-Identifier: BSD-3-Clause
// Reads files of HDF5 with its library, which the tests are linked with.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace octet::test {

class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path)
      : file_(H5Fopen(path.string().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    EXPECT_GE(file_, 0) << path;
  }
  ~Hdf5Reader() { H5Fclose(file_); }
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  bool has(const std::string& path) const {
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
      if (H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
      if (end == std::string::npos) return true;
    }
  }
  std::vector<int> ints(const std::string& path) const { return all<int>(path, H5T_NATIVE_INT); }
  std::vector<double> doubles(const std::string& path) const { return all<double>(path, H5T_NATIVE_DOUBLE); }
  std::vector<std::uint64_t> dims(const std::string& path) const {
    const hid_t array = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(array, 0) << path;
    const hid_t space = H5Dget_space(array);
    std::vector<hsize_t> dims(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, dims.data(), nullptr);
    H5Sclose(space);
    H5Dclose(array);
    return {dims.begin(), dims.end()};
  }
  int int_attribute(const std::string& path, const char* name) const {
    int value = 0;
    const hid_t attribute = H5Aopen_by_name(file_, path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(attribute, 0) << path << " " << name;
    EXPECT_GE(H5Aread(attribute, H5T_NATIVE_INT, &value), 0);
    H5Aclose(attribute);
    return value;
  }
  std::string text_attribute(const std::string& path, const char* name) const {
    const hid_t attribute = H5Aopen_by_name(file_, path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(attribute, 0) << path << " " << name;
    const hid_t type = H5Aget_type(attribute);
    std::string text(H5Tget_size(type), '?');
    EXPECT_GE(H5Aread(attribute, type, text.data()), 0);
    H5Tclose(type);
    H5Aclose(attribute);
    return text;
  }
  /// All bytes of an array of arrays of bytes.
  std::string bytes(const std::string& path) const {
    const hid_t array = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(array, 0) << path;
    const hid_t type = H5Dget_type(array), space = H5Dget_space(array);
    std::string text(H5Tget_size(type) * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)), '?');
    H5Sclose(space);
    EXPECT_GE(H5Dread(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), 0);
    H5Tclose(type);
    H5Dclose(array);
    return text;
  }
  std::vector<std::string> members(const std::string& path, H5_index_t order = H5_INDEX_NAME) const {
    std::vector<std::string> names;
    const hid_t group = H5Gopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(group, 0) << path;
    H5Literate(
        group, order, H5_ITER_INC, nullptr,
        [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
          static_cast<std::vector<std::string>*>(out)->emplace_back(name);
          return 0;
        },
        &names);
    H5Gclose(group);
    return names;
  }

 private:
  template <class T>
  std::vector<T> all(const std::string& path, hid_t type) const {
    std::size_t n = 1;
    for (const std::uint64_t d : dims(path)) n *= d;
    std::vector<T> values(n);
    const hid_t array = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(H5Dread(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << path;
    H5Dclose(array);
    return values;
  }

  hid_t file_;
};

}  // namespace octet::test
