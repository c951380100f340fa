// SPDX-License-Identifier: BSD-3-Clause
// The library's functions are looked up by name when the first file is written, and stay.
#include "io/hdf5_file.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <hdf5.h>

#include <cerrno>
#include <system_error>

#include "base/check.h"
#include "base/error.h"

namespace octet {
namespace {

#define OCTET_HDF5_FUNCTIONS(F)                                                                             \
  F(H5open)                                                                                                 \
  F(H5Eget_auto2)                                                                                           \
  F(H5Eset_auto2)                                                                                           \
  F(H5Fcreate)                                                                                              \
  F(H5Fclose)                                                                                               \
  F(H5Gcreate2)                                                                                             \
  F(H5Gclose) F(H5Oopen) F(H5Oclose) F(H5Acreate2) F(H5Awrite) F(H5Aclose) F(H5Screate) F(H5Screate_simple) \
      F(H5Sselect_hyperslab) F(H5Sclose) F(H5Tcopy) F(H5Tset_size) F(H5Tarray_create2) F(H5Tclose)          \
          F(H5Pcreate) F(H5Pset_obj_track_times) F(H5Pset_fill_time) F(H5Pset_link_creation_order)          \
              F(H5Pclose) F(H5Dcreate2) F(H5Dget_space) F(H5Dwrite) F(H5Dclose)
/// Numbers that are known once the library has been opened.
#define OCTET_HDF5_NUMBERS(F)                                                                   \
  F(H5T_NATIVE_INT8_g)                                                                          \
  F(H5T_NATIVE_INT32_g)                                                                         \
  F(H5T_NATIVE_FLOAT_g)                                                                         \
  F(H5T_NATIVE_DOUBLE_g) F(H5T_C_S1_g) F(H5P_CLS_FILE_CREATE_ID_g) F(H5P_CLS_GROUP_CREATE_ID_g) \
      F(H5P_CLS_DATASET_CREATE_ID_g)

constexpr unsigned kKeepOrder = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;

/// H5F_ACC_TRUNC, which as a macro calls the library itself.
constexpr unsigned kTruncate = 2;

struct Library {
#define F(name) decltype(&::name) name = nullptr;
  OCTET_HDF5_FUNCTIONS(F)
#undef F
#define F(name) hid_t name = -1;
  OCTET_HDF5_NUMBERS(F)
#undef F
  std::string trouble;  ///< why it cannot be used; empty when it can
};

/// A number that the library keeps. Where the program itself is linked with HDF5, what the library sets may
/// be the program's copy, and its own stays below 0.
hid_t number(void* handle, const char* name) {
  for (void* const scope : {handle, RTLD_DEFAULT})
    if (const void* const found = dlsym(scope, name))
      if (const hid_t value = *static_cast<const hid_t*>(found); value >= 0) return value;
  return -1;
}

Library load() {
  Library library;
  // Never closed: the library has work to do when the process ends.
  void* const handle = dlopen(OCTET_HDF5_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    library.trouble = dlerror();
    return library;
  }
  const auto find = [&](const char* name) {
    void* const found = dlsym(handle, name);
    if (found == nullptr && library.trouble.empty()) library.trouble = fmt::format("it lacks {}", name);
    return found;
  };
#define F(name) library.name = reinterpret_cast<decltype(&::name)>(find(#name));
  OCTET_HDF5_FUNCTIONS(F)
#undef F
  if (!library.trouble.empty()) return library;
  if (library.H5open() < 0) {
    library.trouble = "it cannot be started";
    return library;
  }
#define F(name)                         \
  library.name = number(handle, #name); \
  if (library.name < 0) library.trouble = "it lacks " #name;
  OCTET_HDF5_NUMBERS(F)
#undef F
  return library;
}

std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

const Library& loaded() {
  static const Library library = load();
  return library;
}

/// By Hdf5File's kinds.
hid_t type_of(int kind) {
  const Library& h5 = loaded();
  const hid_t types[] = {h5.H5T_NATIVE_INT8_g, h5.H5T_NATIVE_INT32_g, h5.H5T_NATIVE_FLOAT_g,
                         h5.H5T_NATIVE_DOUBLE_g};
  return types[kind];
}

/// What fails is told by exceptions, and by the library itself only where its host has asked for that.
class Quiet {
 public:
  explicit Quiet(const Library& h5) : h5_(h5) {
    h5_.H5Eget_auto2(H5E_DEFAULT, &tell_, &with_);
    h5_.H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { h5_.H5Eset_auto2(H5E_DEFAULT, tell_, with_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  const Library& h5_;
  H5E_auto2_t tell_ = nullptr;
  void* with_ = nullptr;
};

/// Something of HDF5 that is closed again.
class Open {
 public:
  Open(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Open() {
    const Quiet quiet(loaded());
    if (id_ >= 0) close_(id_);
  }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

}  // namespace

void check_hdf5() {
  const std::unique_lock<std::mutex> alone(one_at_a_time());
  if (!loaded().trouble.empty())
    throw InputError(
        fmt::format("a file of HDF5 cannot be written, for its library cannot be used ({}): install "
                    "HDF5 (Debian: libhdf5-103-1), or take another format",
                    loaded().trouble));
}

// Every call of the library comes through here: what is below 0 has failed. The system's reason is told,
// where it has one: a full disk above all.
#define OCTET_HDF5_CALL(function, ...)                  \
  [&] {                                                 \
    const Quiet quiet(loaded());                        \
    errno = 0;                                          \
    const auto result = loaded().function(__VA_ARGS__); \
    if (result < 0) fail(#function, errno);             \
    return result;                                      \
  }()

void Hdf5File::fail(const char* function, int error) const {
  const std::string reason =
      error == 0 ? std::string() : fmt::format(" ({})", std::generic_category().message(error));
  throw OutputError(fmt::format("cannot write \"{}\": HDF5's {} failed{}", named_, function, reason));
}

Hdf5File::Hdf5File(const OutputFile& file, Order order) : named_(file.named().string()), order_(order) {
  check_hdf5();
  alone_ = std::unique_lock<std::mutex>(one_at_a_time());
  if (file.temporary().empty())
    throw OutputError(fmt::format("cannot write \"{}\": a file of HDF5 needs a regular file", named_));
  const Open options(OCTET_HDF5_CALL(H5Pcreate, loaded().H5P_CLS_FILE_CREATE_ID_g), loaded().H5Pclose);
  if (order_ == Order::kAsMade) OCTET_HDF5_CALL(H5Pset_link_creation_order, options, kKeepOrder);
  file_ = OCTET_HDF5_CALL(H5Fcreate, file.temporary().string().c_str(), kTruncate, options, H5P_DEFAULT);
}

Hdf5File::~Hdf5File() {
  if (array_ < 0 && file_ < 0) return;
  const Quiet quiet(loaded());
  if (array_ >= 0) loaded().H5Dclose(array_);
  if (file_ >= 0) loaded().H5Fclose(file_);
}

void Hdf5File::close() {
  const hid_t file = file_;
  file_ = -1;
  OCTET_HDF5_CALL(H5Fclose, file);
  alone_.unlock();
}

void Hdf5File::group(const std::string& path) {
  const Library& h5 = loaded();
  const Open options(OCTET_HDF5_CALL(H5Pcreate, h5.H5P_CLS_GROUP_CREATE_ID_g), h5.H5Pclose);
  if (order_ == Order::kAsMade) OCTET_HDF5_CALL(H5Pset_link_creation_order, options, kKeepOrder);
  const Open group(OCTET_HDF5_CALL(H5Gcreate2, file_, path.c_str(), H5P_DEFAULT, options, H5P_DEFAULT),
                   h5.H5Gclose);
}

void Hdf5File::put_attribute(const std::string& path, const char* name, std::int64_t type, const void* value,
                             bool as_array) {
  const Library& h5 = loaded();
  const Open object(OCTET_HDF5_CALL(H5Oopen, file_, path.c_str(), H5P_DEFAULT), h5.H5Oclose);
  const hsize_t one = 1;
  const Open space(
      as_array ? OCTET_HDF5_CALL(H5Screate_simple, 1, &one, nullptr) : OCTET_HDF5_CALL(H5Screate, H5S_SCALAR),
      h5.H5Sclose);
  const Open attribute(OCTET_HDF5_CALL(H5Acreate2, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                       h5.H5Aclose);
  OCTET_HDF5_CALL(H5Awrite, attribute, type, value);
}

void Hdf5File::attribute(const std::string& path, const char* name, std::int32_t value) {
  put_attribute(path, name, loaded().H5T_NATIVE_INT32_g, &value);
}

void Hdf5File::attribute(const std::string& path, const char* name, double value) {
  put_attribute(path, name, loaded().H5T_NATIVE_DOUBLE_g, &value);
}

void Hdf5File::attribute_array(const std::string& path, const char* name, std::int32_t value) {
  put_attribute(path, name, loaded().H5T_NATIVE_INT32_g, &value, true);
}

void Hdf5File::attribute(const std::string& path, const char* name, const std::string& text,
                         std::size_t length) {
  const Library& h5 = loaded();
  std::string bytes = text;
  bytes.resize(std::max(text.size(), length) + 1);
  const Open type(OCTET_HDF5_CALL(H5Tcopy, h5.H5T_C_S1_g), h5.H5Tclose);
  OCTET_HDF5_CALL(H5Tset_size, type, bytes.size());
  put_attribute(path, name, type, bytes.data());
}

void Hdf5File::begin_array(const std::string& path, Kind kind, const std::vector<std::uint64_t>& dims) {
  OCTET_CHECK(array_ < 0 && (dims.size() == 1 || dims.size() == 2));
  const Library& h5 = loaded();
  const std::vector<hsize_t> extent(dims.begin(), dims.end());
  const Open space(OCTET_HDF5_CALL(H5Screate_simple, static_cast<int>(extent.size()), extent.data(), nullptr),
                   h5.H5Sclose);
  const Open options(OCTET_HDF5_CALL(H5Pcreate, h5.H5P_CLS_DATASET_CREATE_ID_g), h5.H5Pclose);
  // No time of day: the same mesh gives the same bytes.
  OCTET_HDF5_CALL(H5Pset_obj_track_times, options, false);
  OCTET_HDF5_CALL(H5Pset_fill_time, options, H5D_FILL_TIME_NEVER);
  kind_ = kind;
  dims_ = dims;
  array_ = OCTET_HDF5_CALL(H5Dcreate2, file_, path.c_str(), type_of(static_cast<int>(kind)), space,
                           H5P_DEFAULT, options, H5P_DEFAULT);
}

void Hdf5File::put(std::uint64_t first, std::uint64_t count, const void* values) {
  const Library& h5 = loaded();
  const hsize_t start[2] = {first, 0};
  const hsize_t extent[2] = {count, dims_.back()};
  const Open in_file(OCTET_HDF5_CALL(H5Dget_space, array_), h5.H5Sclose);
  OCTET_HDF5_CALL(H5Sselect_hyperslab, in_file, H5S_SELECT_SET, start, nullptr, extent, nullptr);
  const Open in_memory(OCTET_HDF5_CALL(H5Screate_simple, static_cast<int>(dims_.size()), extent, nullptr),
                       h5.H5Sclose);
  OCTET_HDF5_CALL(H5Dwrite, array_, type_of(static_cast<int>(kind_)), in_memory, in_file, H5P_DEFAULT,
                  values);
}

void Hdf5File::end_array() {
  const hid_t array = array_;
  array_ = -1;
  OCTET_HDF5_CALL(H5Dclose, array);
}

void Hdf5File::texts(const std::string& path, const std::vector<std::string>& texts, std::size_t width) {
  const Library& h5 = loaded();
  std::string bytes;
  for (const std::string& text : texts)
    bytes.append(text, 0, width).append(width - std::min(width, text.size()), '\0');
  const hsize_t each = width, count = texts.size();
  const Open type(OCTET_HDF5_CALL(H5Tarray_create2, h5.H5T_NATIVE_INT8_g, 1, &each), h5.H5Tclose);
  const Open space(OCTET_HDF5_CALL(H5Screate_simple, 1, &count, nullptr), h5.H5Sclose);
  const Open options(OCTET_HDF5_CALL(H5Pcreate, h5.H5P_CLS_DATASET_CREATE_ID_g), h5.H5Pclose);
  OCTET_HDF5_CALL(H5Pset_obj_track_times, options, false);
  const Open array(
      OCTET_HDF5_CALL(H5Dcreate2, file_, path.c_str(), type, space, H5P_DEFAULT, options, H5P_DEFAULT),
      h5.H5Dclose);
  OCTET_HDF5_CALL(H5Dwrite, array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
}

}  // namespace octet
