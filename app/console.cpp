// SPDX-License-Identifier: BSD-3-Clause
// The only mutable global of the program is the flag that a signal handler may set.
#include "app/console.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "io/write.h"

namespace octet {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void on_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void ignore_file_size_signal() {
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);
#endif
}

Console::Console(ConsoleOptions options) : options_(std::move(options)) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

void Console::stage(std::string_view name, double fraction) {
  const int percent = static_cast<int>(100.0 * onward_(fraction));
  if (options_.notes) {
    note(fmt::format("[{:3}%] {}", percent, name));
  } else if (options_.progress) {
    std::fputs(fmt::format("\r\033[K[{:3}%] {}", percent, name).c_str(), stderr);
    std::fflush(stderr);
    line_ = true;
  }
}

void Console::note(std::string_view text) {
  if (!options_.notes) return;
  clear();
  std::fputs(fmt::format("octet: {}\n", text).c_str(), stderr);
}

void Console::dump(std::string_view stage, const Mesh& mesh) {
  const std::string file = fmt::format("{:02}-{}.vtu", ++dumps_, stage);
  write_mesh(options_.dump_directory / file, mesh, {}, MeshFormat::kVtu);
}

bool Console::cancelled() const { return interrupted != 0; }

void Console::clear() {
  if (line_) std::fputs("\r\033[K", stderr);
  line_ = false;
}

}  // namespace octet
