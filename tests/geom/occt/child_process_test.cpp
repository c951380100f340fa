// SPDX-License-Identifier: BSD-3-Clause
// Work that hangs, crashes or eats memory ends as one clear error, and leaves no process behind.
#include "geom/occt/child_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <TopoDS_Compound.hxx>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <gp_Pnt.hxx>
#include <sstream>
#include <string>
#include <thread>

#include "base/error.h"
#include "geom/occt/byte_stream.h"
#include "geom/occt/part_stream.h"
#include "geom/occt/read_again.h"
#include "geom/occt/reader.h"
#include "sample_parts.h"

namespace {

int kills_of_none = 0;

}  // namespace

/// In place of the C library's: counts signals to processes that are no child's, or no child's any more.
extern "C" int kill(pid_t pid, int signal) noexcept {
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) != 0) ++kills_of_none;
  return static_cast<int>(::syscall(SYS_kill, pid, signal));
}

namespace octet::test {
namespace {

std::string error_of(const ChildWork& work, const ChildLimits& limits) {
  try {
    (void)run_in_child(work, limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_no_child_left() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ChildProcess, AnswersComeBackWhole) {
  const std::string large(3'000'000, 'x');
  EXPECT_EQ(run_in_child([&](const StageLog&) { return large + "!"; }, {}), large + "!");
  expect_no_child_left();
}

TEST(ChildProcess, AHangIsRefusedInTimeAndNamesItsStage) {
  const auto start = std::chrono::steady_clock::now();
  const std::string error = error_of(
      [](const StageLog& log) -> std::string {
        log("fusing 2 solids");
        for (volatile bool run = true; run;) {
        }
        return {};
      },
      {0.3, 0});
  EXPECT_EQ(error, "fusing 2 solids took too long: the limit for reading is 0.3 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  expect_no_child_left();
}

TEST(ChildProcess, ACrashNamesItsStage) {
  const std::string error = error_of(
      [](const StageLog& log) -> std::string {
        log("triangulating Face 12");
        std::raise(SIGSEGV);
        return {};
      },
      {});
  EXPECT_NE(error.find("crashed while triangulating Face 12"), std::string::npos) << error;
  expect_no_child_left();
}

TEST(ChildProcess, NoSignalGoesToAChildThatHasBeenReaped) {
  kills_of_none = 0;
  const auto crash = [](const StageLog&) -> std::string {
    std::raise(SIGSEGV);
    return {};
  };
  EXPECT_NE(error_of(crash, {}), "no error");
  EXPECT_EQ(run_in_child([](const StageLog&) { return std::string("done"); }, {}), "done");
  EXPECT_EQ(kills_of_none, 0);
}

TEST(ChildProcess, TooMuchMemoryNamesItsStageAndTheLimit) {
  const std::string error = error_of(
      [](const StageLog& log) -> std::string {
        log("reading the file");
        std::string all;
        for (;;) all.append(10'000'000, 'x');
      },
      {60.0, 300'000'000});
  EXPECT_EQ(error, "reading the file needs too much memory: the limit for reading is 0.3 GB");
}

TEST(ChildProcess, ErrorsOfTheWorkKeepTheirTypeAndEntity) {
  try {
    (void)run_in_child(
        [](const StageLog&) -> std::string { throw ModelError("Face 7 is open", model_face(7)); }, {});
    FAIL();
  } catch (const ModelError& error) {
    EXPECT_STREQ(error.what(), "Face 7 is open");
    EXPECT_EQ(error.entity(), model_face(7));
  }
  EXPECT_THROW((void)run_in_child([](const StageLog&) -> std::string { throw Bug("no"); }, {}), Bug);
  EXPECT_THROW((void)run_in_child([](const StageLog&) -> std::string { throw std::bad_alloc(); }, {}),
               std::bad_alloc);
}

TEST(ChildProcess, AnInterruptedChildIsACancelledRun) {
  const ChildWork work = [](const StageLog&) -> std::string {
    std::raise(SIGINT);
    return {};
  };
  EXPECT_THROW((void)run_in_child(work, {}), Cancelled);
}

TEST(ByteStream, GivesBackWhatWasPut) {
  const std::vector<std::string> names = {"a", "", "a name"};
  const std::vector<std::array<Vec2, 3>> uv = {{Vec2(1, 2), Vec2(3, 4), Vec2(5, 6)}};
  const std::vector<std::vector<int>> lists = {{1, 2}, {}, {3}};
  ByteWriter out;
  out(names, uv, lists, -0.0, true);
  std::vector<std::string> names_back;
  std::vector<std::array<Vec2, 3>> uv_back;
  std::vector<std::vector<int>> lists_back;
  double zero = 1.0;
  bool yes = false;
  ByteReader in(out.bytes);
  in(names_back, uv_back, lists_back, zero, yes);
  EXPECT_EQ(names_back, names);
  EXPECT_EQ(uv_back, uv);
  EXPECT_EQ(lists_back, lists);
  EXPECT_TRUE(std::signbit(zero));
  EXPECT_TRUE(yes);
  EXPECT_THROW(in(zero), Bug);
}

/// All of a model that two ways of reading could make differ.
void expect_same(const Model& a, const Model& b) {
  for (int dim = 0; dim < 4; ++dim) EXPECT_EQ(a.count(dim), b.count(dim));
  EXPECT_EQ(a.facets().nodes, b.facets().nodes);
  EXPECT_EQ(a.facets().triangles, b.facets().triangles);
  EXPECT_EQ(a.facets().uv, b.facets().uv);
  EXPECT_EQ(a.notes(), b.notes());
  for (int f = 1; f <= a.count(2); ++f) {
    EXPECT_EQ(a.face(f).area, b.face(f).area);
    EXPECT_EQ(a.face(f).name, b.face(f).name);
    EXPECT_STREQ(a.surface(f).kind(), b.surface(f).kind());
    const Vec2 uv(0.3, 0.4);
    EXPECT_EQ(a.face_jet(f, uv, 0).p, b.face_jet(f, uv, 0).p);
  }
}

TEST(Reading, GivesTheSameModelInAChildInAHelperAndInThisProcess) {
  ReadOptions here, helper;
  here.isolate = false;
  helper.reader_program = OCTET_READER_PROGRAM;
  for (const char* name : {"blade", "two_boxes"}) {
    const Model model = sample(name);
    expect_same(model, read_part(sample_path(name), here));
    expect_same(model, read_part(sample_path(name), helper));
  }
}

TEST(Reading, SeveralThreadsReadAtOnce) {
  ReadOptions helper;
  helper.reader_program = OCTET_READER_PROGRAM;
  std::array<int, 3> faces{};
  std::vector<std::thread> threads;
  for (int& count : faces)
    threads.emplace_back([&] { count = read_part(sample_path("bracket"), helper).count(2); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_GT(faces[0], 6);
  EXPECT_EQ(faces[1], faces[0]);
  EXPECT_EQ(faces[2], faces[0]);
}

TEST(Reading, AMissingHelperIsAnError) {
  ReadOptions options;
  options.reader_program = "/nowhere/octet-reader";
  EXPECT_THROW((void)read_part(sample_path("box"), options), InputError);
}

/// Runs what asks for it beside a second thread, and returns the error.
std::string beside_a_thread(const std::function<void()>& work) {
  std::atomic<bool> done{false};
  std::thread other([&done] { done.wait(false); });
  std::string error;
  try {
    work();
  } catch (const InputError& caught) {
    error = caught.what();
  }
  done = true;
  done.notify_all();
  other.join();
  return error;
}

TEST(Reading, WithThreadsTheInstalledHelperIsUsedAndIsolationMayBeRequired) {
  ReadOptions options;
  options.require_isolation = true;
  const auto read = [&](const char* installed) {
    return beside_a_thread(
        [&] { EXPECT_TRUE(read_part(sample_path("box"), options, installed).notes().empty()); });
  };
  EXPECT_EQ(read(OCTET_READER_PROGRAM), "");
  // Where Octet is installed for all, its helper is found without a word of the package.
  const bool found = ::access("/usr/libexec/octet/octet-reader", X_OK) == 0 ||
                     ::access("/usr/local/libexec/octet/octet-reader", X_OK) == 0;
  const std::string error = read("");
  EXPECT_EQ(error.find("octet-reader was not found") != std::string::npos, !found) << error;
  options.require_isolation = false;
  EXPECT_EQ(beside_a_thread(
                [&] { EXPECT_EQ(read_part(sample_path("box"), options).notes().size(), found ? 0u : 1u); }),
            "");
  options.require_isolation = true;
  options.isolate = false;
  EXPECT_THROW((void)read_part(sample_path("box"), options), InputError);
}

/// Of the host: counts what it is sent.
class Counter : public Message_Printer {
 public:
  explicit Counter(std::atomic<int>& count) : count_(count) {}

 protected:
  void send(const TCollection_AsciiString& text, Message_Gravity) const override {
    if (text == "from the host") ++count_;
  }

 private:
  std::atomic<int>& count_;
};

TEST(Reading, InThisProcessLeavesMessagesOfOtherThreadsAlone) {
  const Handle(Message_Messenger)& messenger = Message::DefaultMessenger();
  const Message_SequenceOfPrinters before = messenger->Printers();
  std::atomic<int> received{0};
  messenger->ChangePrinters().Clear();
  messenger->AddPrinter(new Counter(received));
  std::atomic<bool> stop{false};
  int sent = 0;
  std::thread host([&] {
    for (; !stop; ++sent) messenger->Send("from the host", Message_Info);
  });
  ReadOptions options;
  options.isolate = false;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(read_part(sample_path("box"), options).count(2), 6);
  stop = true;
  host.join();
  EXPECT_GT(sent, 0);
  EXPECT_EQ(received, sent);
  messenger->ChangePrinters() = before;
}

TEST(Reading, AHelperGetsNothingThatTheHostHasOpen) {
  const std::filesystem::path program = std::filesystem::temp_directory_path() / "octet_open_files.sh";
  const std::filesystem::path list = std::filesystem::temp_directory_path() / "octet_open_files.txt";
  std::ofstream(program) << "#!/bin/sh\nls -l /proc/$$/fd > " << list.string() << "\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const int low = ::open("/dev/zero", O_RDONLY);
  const int open_file = ::fcntl(low, F_DUPFD, 20);  // the helper's own files take the lowest numbers
  ::close(low);
  ASSERT_GE(open_file, 20);
  EXPECT_THROW((void)run_in_helper(program, "any", "", {}), InputError);
  ::close(open_file);
  std::stringstream told;
  told << std::ifstream(list).rdbuf();
  EXPECT_NE(told.str().find("socket:"), std::string::npos) << told.str();
  EXPECT_EQ(told.str().find("/dev/zero"), std::string::npos) << told.str();
  std::filesystem::remove(program);
  std::filesystem::remove(list);
}

TEST(Reading, AHelperOfAnotherVersionIsNamedWithBoth) {
  try {
    (void)run_in_helper(OCTET_READER_PROGRAM, "Octet 99", "", {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), std::string("'") + OCTET_READER_PROGRAM + "' is of version " +
                                             reader_version() + ", this is Octet 99: install both together");
  }
  expect_no_child_left();
}

TEST(Reading, ALimitOfTimeIsKept) {
  ReadOptions options;
  options.time_limit = 1e-3;
  try {
    (void)read_part(sample_path("bracket"), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("took too long"), std::string::npos) << error.what();
  }
}

/// Reads as OCCT would where it comes to no end in that stage.
std::function<Model(const ReadJob&)> stuck_in(const std::string& stage) {
  return [stage](const ReadJob& job) {
    if (job.options.fuse) throw NoEnd(stage + " took too long", stage);
    return Model(read_job(job));
  };
}

TEST(Reading, SolidsThatCannotBeJoinedAreReadApart) {
  ReadJob job;
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 1, 1, 1).Solid());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 1, 1, 1).Solid());
  job.shape = both;
  EXPECT_EQ(read_model(job).count(2), 11);
  for (const char* stage : {"fusing 2 solid(s) that may touch", "looking for faces that solids have alike"}) {
    const Model model = read_at_least_apart(job, stuck_in(stage));
    EXPECT_EQ(model.count(2), 12);
    EXPECT_TRUE(model.parts().apart);
    ASSERT_EQ(model.parts().faults.size(), 1u);
    EXPECT_NE(model.parts().faults[0].cause.find(stage), std::string::npos);
  }
  EXPECT_THROW((void)read_at_least_apart(job, stuck_in("triangulating Face 1")), NoEnd);
  job.options.embed = true;
  EXPECT_THROW((void)read_at_least_apart(job, stuck_in("fusing 2 solid(s) that may touch")), NoEnd);
}

}  // namespace
}  // namespace octet::test
