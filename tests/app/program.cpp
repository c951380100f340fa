// SPDX-License-Identifier: BSD-3-Clause
// fork and exec, with the outputs in files: no pipe can fill up.
#include "tests/app/program.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace octet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void become_octet(const std::vector<std::string>& arguments, const ProgramLimits& limits,
                               const std::string& out, const std::string& err) {
  if (std::freopen("/dev/null", "r", stdin) == nullptr || std::freopen(out.c_str(), "w", stdout) == nullptr ||
      std::freopen(err.c_str(), "w", stderr) == nullptr)
    std::_Exit(126);
  if (limits.file_bytes > 0) {
    const auto most = static_cast<rlim_t>(limits.file_bytes);
    const rlimit limit{most, most};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) std::_Exit(126);
  }
  std::vector<char*> argv{const_cast<char*>(OCTET_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::execv(OCTET_PROGRAM, argv.data());
  std::_Exit(127);
}

}  // namespace

ProgramRun run_octet(const std::vector<std::string>& arguments, const ProgramLimits& limits) {
  const TemporaryDirectory streams;
  const std::string out = streams.file("out"), err = streams.file("err");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) become_octet(arguments, limits, out, err);
  int status = 0;
  ::waitpid(child, &status, 0);
  ProgramRun run;
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  run.out = read_bytes(out);
  run.err = read_bytes(err);
  return run;
}

TemporaryDirectory::TemporaryDirectory() {
  std::string name = (fs::temp_directory_path() / "octet-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryDirectory::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string model_file(const std::string& name) { return (fs::path(OCTET_MODELS) / name).string(); }

}  // namespace octet
