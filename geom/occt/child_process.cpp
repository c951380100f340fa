// SPDX-License-Identifier: BSD-3-Clause
// Work that may hang, crash or take all memory, run in a process of its own.
//
// Parent and child share a socket. The child sends frames: a kind, a length, that many bytes. A frame 's'
// names the stage that begins; 'r' holds the answer and 'e' an error, and either is the last. A helper
// program says its version first, 'v', before it looks at the request: what follows means something to its
// like alone.
#include "geom/occt/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>

#include "base/error.h"
#include "geom/occt/byte_stream.h"

namespace octet {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kHelperSocket = 3;
constexpr std::size_t kChunk = 1 << 16;
constexpr int kWatchMilliseconds = 20;

enum class Failure : std::uint8_t { kInput, kModel, kLimit, kBug, kMemory };

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

/// A child that is killed and reaped when it goes.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  [[nodiscard]] pid_t pid() const { return pid_; }
  ~Child() {
    // Of one that is reaped the number may be another's by now.
    if (!status_) ::kill(pid_, SIGKILL);
    (void)wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  int wait() {
    if (!status_) {
      int status = 0;
      while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
      }
      status_ = status;
    }
    return *status_;
  }

 private:
  pid_t pid_;
  std::optional<int> status_;
};

/// MSG_NOSIGNAL: an end that is gone is an error here, no signal for the whole process.
bool send_all(int fd, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = ::send(fd, data, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool send_frame(int fd, char kind, std::string_view payload) {
  std::array<char, 9> head{kind};
  const auto size = static_cast<std::uint64_t>(payload.size());
  std::memcpy(head.data() + 1, &size, sizeof size);
  return send_all(fd, head.data(), head.size()) && send_all(fd, payload.data(), payload.size());
}

std::string pack_failure(Failure kind, const std::string& message, ModelRef entity = {}) {
  ByteWriter out;
  out(kind, message, entity.dim, entity.tag);
  return std::move(out.bytes);
}

[[noreturn]] void throw_failure(std::string_view payload) {
  ByteReader in(payload);
  Failure kind{};
  std::string message;
  ModelRef entity;
  in(kind, message, entity.dim, entity.tag);
  switch (kind) {
    case Failure::kModel:
      throw ModelError(message, entity);
    case Failure::kLimit:
      throw LimitError(message);
    case Failure::kBug:
      throw Bug(message);
    case Failure::kMemory:
      throw std::bad_alloc();
    case Failure::kInput:
      break;
  }
  throw InputError(message);
}

/// In the child: nothing of what it does may outlive the parent, print, or be handled by the parent's own
/// handlers.
void become_child() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGSEGV, SIGFPE, SIGABRT, SIGBUS, SIGILL})
    std::signal(signal, SIG_DFL);
  const int null = ::open("/dev/null", O_RDWR);
  if (null >= 0) {
    ::dup2(null, STDOUT_FILENO);
    ::dup2(null, STDERR_FILENO);
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
}

/// Bytes of memory that a process holds now; 0 when it is gone.
std::size_t resident_bytes(pid_t pid) {
  std::ifstream in(fmt::format("/proc/{}/statm", pid));
  std::size_t mapped = 0, resident = 0;
  in >> mapped >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Runs the work and sends what comes of it.
int answer(int fd, const ChildWork& work) {
  std::string failure;
  try {
    const std::string result = work([fd](const std::string& stage) { (void)send_frame(fd, 's', stage); });
    return send_frame(fd, 'r', result) ? 0 : 1;
  } catch (const ModelError& error) {
    failure = pack_failure(Failure::kModel, error.what(), error.entity());
  } catch (const InputError& error) {
    failure = pack_failure(Failure::kInput, error.what());
  } catch (const LimitError& error) {
    failure = pack_failure(Failure::kLimit, error.what());
  } catch (const Bug& error) {
    failure = pack_failure(Failure::kBug, error.what());
  } catch (const std::bad_alloc&) {
    failure = pack_failure(Failure::kMemory, "");
  } catch (const std::exception& error) {
    failure = pack_failure(Failure::kBug, error.what());
  }
  return send_frame(fd, 'e', failure) ? 0 : 1;
}

/// Reads the child's frames until the last one.
class Follower {
 public:
  Follower(int fd, Child& child, const ChildLimits& limits)
      : fd_(fd),
        child_(child),
        limits_(limits),
        start_(Clock::now()),
        start_bytes_(resident_bytes(child.pid())) {}

  /// InputError: the helper's first words are not this version's.
  void expect_version(const std::filesystem::path& program, const std::string& version) {
    char kind = 0;
    const std::string theirs = next_frame(kind);
    if (kind == 'v' && theirs == version) return;
    throw InputError(fmt::format("'{}' is of version {}, this is {}: install both together", program.string(),
                                 kind == 'v' ? theirs : "unknown", version));
  }

  std::string run() {
    for (;;) {
      char kind = 0;
      std::string payload = next_frame(kind);
      if (kind == 's') stage_ = std::move(payload);
      if (kind == 'r') return payload;
      if (kind == 'e') throw_failure(payload);
    }
  }

 private:
  std::string next_frame(char& kind) {
    std::string head = read_bytes(9);
    kind = head[0];
    std::uint64_t size = 0;
    std::memcpy(&size, head.data() + 1, sizeof size);
    return read_bytes(size);
  }

  std::string read_bytes(std::uint64_t size) {
    std::string bytes;
    while (bytes.size() < size) {
      wait_for_bytes();
      const std::size_t have = bytes.size();
      bytes.resize(have + std::min<std::uint64_t>(kChunk, size - have));
      const ssize_t got = ::recv(fd_, bytes.data() + have, bytes.size() - have, 0);
      bytes.resize(have + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
      if (got == 0 || (got < 0 && errno != EINTR)) throw_died();
    }
    return bytes;
  }

  /// Looks at the child's memory and at the clock until it has something to say. Memory is watched from here:
  /// OCCT takes a failed allocation for damage of the file, or hides it.
  void wait_for_bytes() {
    for (;;) {
      int milliseconds = -1;
      if (limits_.bytes > 0) {
        check_memory();
        milliseconds = kWatchMilliseconds;
      }
      if (limits_.seconds > 0.0) {
        const double left = limits_.seconds - std::chrono::duration<double>(Clock::now() - start_).count();
        if (left <= 0.0)
          no_end(fmt::format("{} took too long: the limit for reading is {:g} s", stage_, limits_.seconds));
        const int wait = static_cast<int>(std::min(1e6, std::ceil(1e3 * left)));
        milliseconds = milliseconds < 0 ? wait : std::min(milliseconds, wait);
      }
      pollfd events{fd_, POLLIN, 0};
      if (::poll(&events, 1, milliseconds) > 0) return;
    }
  }

  void check_memory() {
    const std::size_t now = resident_bytes(child_.pid());
    if (now > start_bytes_ + limits_.bytes) throw_memory();
  }

  [[noreturn]] void no_end(const std::string& message) const { throw NoEnd(message, stage_); }

  [[noreturn]] void throw_memory() const {
    constexpr double kGigabyte = 1e9;
    no_end(fmt::format("{} needs too much memory: the limit for reading is {:.3g} GB", stage_,
                       static_cast<double>(limits_.bytes) / kGigabyte));
  }

  [[noreturn]] void throw_died() const {
    const int status = child_.wait();
    if (!WIFSIGNALED(status)) no_end(fmt::format("the CAD kernel gave up while {}", stage_));
    const int signal = WTERMSIG(status);
    if (signal == SIGINT || signal == SIGTERM) throw Cancelled();
    if (signal == SIGKILL) no_end(fmt::format("{} was killed, by a lack of memory as it seems", stage_));
    no_end(fmt::format("the CAD kernel crashed while {} ({})", stage_, ::strsignal(signal)));
  }

  int fd_;
  Child& child_;
  ChildLimits limits_;
  Clock::time_point start_;
  std::size_t start_bytes_;
  std::string stage_ = "starting to read";
};

/// Numbers above those of the standard streams, even where these are closed.
std::array<int, 2> make_sockets() {
  std::array<int, 2> low{}, fd{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, low.data()) != 0)
    throw LimitError(std::string("no socket for a child process: ") + std::strerror(errno));
  for (int i = 0; i < 2; ++i) {
    fd[i] = ::fcntl(low[i], F_DUPFD_CLOEXEC, kHelperSocket + 1);
    ::close(low[i]);
  }
  return fd;
}

pid_t start_program(const std::filesystem::path& program, int socket) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, socket, kHelperSocket);
#if __GLIBC_PREREQ(2, 34)
  // What the host has open without O_CLOEXEC is not the helper's.
  ::posix_spawn_file_actions_addclosefrom_np(&actions, kHelperSocket + 1);
#endif
  std::string name = program.string();
  std::array<char*, 2> arguments{name.data(), nullptr};
  pid_t pid = -1;
  const int error = ::posix_spawn(&pid, name.c_str(), &actions, nullptr, arguments.data(), ::environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw InputError(fmt::format("cannot start '{}': {}", name, std::strerror(error)));
  return pid;
}

std::string read_to_end(int fd) {
  std::string bytes;
  for (;;) {
    const std::size_t have = bytes.size();
    bytes.resize(have + kChunk);
    const ssize_t got = ::recv(fd, bytes.data() + have, kChunk, 0);
    bytes.resize(have + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0 || (got < 0 && errno != EINTR)) return bytes;
  }
}

}  // namespace

bool has_one_thread() {
  std::error_code error;
  int count = 0;
  for (std::filesystem::directory_iterator it("/proc/self/task", error), end; !error && it != end;
       it.increment(error))
    ++count;
  return !error && count == 1;
}

std::string run_in_child(const ChildWork& work, const ChildLimits& limits) {
  const std::array<int, 2> sockets = make_sockets();
  Descriptor ours(sockets[0]), theirs(sockets[1]);
  const pid_t pid = ::fork();
  if (pid < 0) throw LimitError(std::string("no child process can be started: ") + std::strerror(errno));
  if (pid == 0) {
    become_child();
    // _exit: buffers and destructors are the parent's affair.
    ::_exit(answer(theirs.get(), work));
  }
  Child child(pid);
  theirs.close();
  return Follower(ours.get(), child, limits).run();
}

std::string run_in_helper(const std::filesystem::path& program, const std::string& version,
                          std::string_view request, const ChildLimits& limits) {
  const std::array<int, 2> sockets = make_sockets();
  Descriptor ours(sockets[0]), theirs(sockets[1]);
  Child child(start_program(program, theirs.get()));
  theirs.close();
  // A helper that dies early is told by its silence.
  (void)send_all(ours.get(), request.data(), request.size());
  ::shutdown(ours.get(), SHUT_WR);
  Follower follower(ours.get(), child, limits);
  follower.expect_version(program, version);
  return follower.run();
}

int serve_helper(const std::string& version,
                 const std::function<std::string(std::string_view, const StageLog&)>& work) {
  become_child();
  if (!send_frame(kHelperSocket, 'v', version)) return 1;
  const std::string request = read_to_end(kHelperSocket);
  return answer(kHelperSocket, [&](const StageLog& log) { return work(request, log); });
}

}  // namespace octet
