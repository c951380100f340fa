// SPDX-License-Identifier: BSD-3-Clause
// A setting of OCCT's readers and writers for as long as it is needed.
#pragma once

#include <Interface_Static.hxx>

namespace octet {

/// A setting of all OCCT's readers and writers in the process, put back when it goes: a program that reads a
/// part within itself (ReadOptions::isolate) may read files of its own.
class ScopedSetting {
 public:
  ScopedSetting(const char* name, int value) : name_(name), before_(Interface_Static::IVal(name)) {
    Interface_Static::SetIVal(name_, value);
  }
  ~ScopedSetting() { Interface_Static::SetIVal(name_, before_); }
  ScopedSetting(const ScopedSetting&) = delete;
  ScopedSetting& operator=(const ScopedSetting&) = delete;

 private:
  const char* name_;
  int before_;
};

}  // namespace octet
