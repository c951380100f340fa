// SPDX-License-Identifier: BSD-3-Clause
// The program's observer: progress and notes on stderr, stage dumps, and Ctrl-C.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "base/observer.h"
#include "base/onward.h"

namespace octet {

struct ConsoleOptions {
  bool progress = false;                 ///< one line that is rewritten; for terminals
  bool notes = false;                    ///< a line per stage and note
  std::filesystem::path dump_directory;  ///< empty: no dumps
};

/// Makes a file size limit a failed write instead of a signal. Called once, by main.
void ignore_file_size_signal();

/// Where there is one, Ctrl-C and SIGTERM end the run at the next question; the second one kills. A command
/// without one asks no questions, and is ended at once.
class Console : public Observer {
 public:
  explicit Console(ConsoleOptions options);
  ~Console() override { clear(); }
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void stage(std::string_view name, double fraction) override;
  void note(std::string_view text) override;
  void dump(std::string_view stage, const Mesh& mesh) override;
  [[nodiscard]] bool wants_dumps() const override { return !options_.dump_directory.empty(); }
  [[nodiscard]] bool cancelled() const override;
  /// Takes the progress line away.
  void clear();

 private:
  ConsoleOptions options_;
  Onward onward_;
  bool line_ = false;
  int dumps_ = 0;
};

}  // namespace octet
