// SPDX-License-Identifier: BSD-3-Clause
// A setting of OCCT's readers and writers for as long as it is needed.
#pragma once

#include <Interface_Static.hxx>
#include <type_traits>

namespace octet {

/// A setting, a whole number or a real one, of all OCCT's readers and writers in the process, put back when
/// it goes: a program that reads a part within itself (ReadOptions::isolate) may read files of its own.
template <class Value>
class ScopedSetting {
 public:
  ScopedSetting(const char* name, Value value) : name_(name), before_(now()) { set(value); }
  ~ScopedSetting() { set(before_); }
  ScopedSetting(const ScopedSetting&) = delete;
  ScopedSetting& operator=(const ScopedSetting&) = delete;

 private:
  static constexpr bool kWhole = std::is_same_v<Value, int>;

  [[nodiscard]] Value now() const {
    if constexpr (kWhole)
      return Interface_Static::IVal(name_);
    else
      return Interface_Static::RVal(name_);
  }
  void set(Value value) const {
    if constexpr (kWhole)
      Interface_Static::SetIVal(name_, value);
    else
      Interface_Static::SetRVal(name_, value);
  }

  const char* name_;
  Value before_;
};

}  // namespace octet
