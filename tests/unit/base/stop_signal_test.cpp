#include "base/stop_signal.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/child_process.h"
#include "support/sanitizer.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

struct Heard {
  std::string err;
  ChildProcess::Ending ending;
};

// Runs `work` in a child whose stop signals have their default effect, and reads its messages.
template <class Work>
Heard in_child(const Work& work) {
  int pipe_end = -1;
  std::optional<ChildProcess> child = ChildProcess::fork(ChildProcess::Pipe::from_child, pipe_end);
  if (!child) {
    for (const int signal : stop_signals) std::signal(signal, SIG_DFL);
    dup2(pipe_end, STDERR_FILENO);
    _exit(work());
  }
  Heard heard;
  heard.err = child->read_all();
  heard.ending = child->wait();
  return heard;
}

TEST(StopSignal, is_noted_and_said_with_what_is_done_first) {
  for (const int signal : stop_signals) {
    const Heard heard = in_child([&] {
      catch_stop_signals();
      const Task task("a route is planned");
      raise(signal);
      return stop_signal() == signal ? 7 : 1;
    });
    EXPECT_EQ(heard.ending.code, 7) << signal;
    EXPECT_THAT(heard.err, ::testing::StartsWith(name_of_signal(signal)));
    EXPECT_THAT(heard.err, HasSubstr(": stops; first a route is planned"));
  }
}

TEST(StopSignal, is_not_commented_without_a_task) {
  const Heard heard = in_child([] {
    catch_stop_signals();
    { const Task task("a route is planned"); }
    raise(SIGTERM);
    return stop_signal() == SIGTERM ? 7 : 1;
  });
  EXPECT_EQ(heard.ending.code, 7);
  EXPECT_EQ(heard.err, "");
}

TEST(StopSignal, that_comes_again_ends_the_program) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Heard heard = in_child([&] {
      catch_stop_signals();
      raise(signal);
      raise(signal);
      return 0;
    });
    EXPECT_EQ(heard.ending.signal, signal);
  }
}

// Past the limit of CPU time it comes each second.
TEST(StopSignal, of_cpu_time_may_come_again) {
  const Heard heard = in_child([] {
    catch_stop_signals();
    raise(SIGXCPU);
    raise(SIGXCPU);
    return stop_signal() == SIGXCPU ? 7 : 1;
  });
  EXPECT_EQ(heard.ending.code, 7);
}

TEST(StopSignal, that_comes_first_counts) {
  const Heard heard = in_child([] {
    catch_stop_signals();
    raise(SIGHUP);
    raise(SIGTERM);
    return stop_signal() == SIGHUP ? 7 : 1;
  });
  EXPECT_EQ(heard.ending.code, 7);
}

// Shells start commands in the background with SIGINT ignored, and nohup does so with SIGHUP.
TEST(StopSignal, that_the_parent_ignores_stays_ignored) {
  for (const int signal : {SIGINT, SIGHUP}) {
    const Heard heard = in_child([&] {
      std::signal(signal, SIG_IGN);
      catch_stop_signals();
      raise(signal);
      forget_stop_signals();
      raise(signal);
      // A child of the program ignores it, too.
      std::optional<ChildProcess> child = ChildProcess::fork();
      if (!child) {
        raise(signal);
        _exit(5);
      }
      return stop_signal() == 0 && child->wait().code == 5 ? 7 : 1;
    });
    EXPECT_EQ(heard.ending.code, 7) << signal;
  }
}

TEST(FatalSignal, ends_with_a_sentence) {
  if (test::is_sanitized) GTEST_SKIP() << "the sanitizer has handlers of its own";
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS}) {
    const Heard heard = in_child([&] {
      catch_fatal_signals();
      raise(signal);
      return 0;
    });
    EXPECT_EQ(heard.ending.code, 3) << signal;
    EXPECT_THAT(heard.err, HasSubstr("; a run that was under way goes on with 'lsos-host resume'"));
  }
}

TEST(FatalSignal, of_a_failed_assertion_blames_nobody) {
  if (test::is_sanitized) GTEST_SKIP() << "the sanitizer has handlers of its own";
  const Heard heard = in_child([] {
    catch_fatal_signals();
    std::terminate();
    return 0;
  });
  EXPECT_EQ(heard.ending.code, 3);
  EXPECT_THAT(heard.err, HasSubstr("the program or a library has given up (SIGABRT)"));
}

TEST(FatalSignal, leaves_a_core_dump_to_who_wants_one) {
  if (test::is_sanitized) GTEST_SKIP() << "the sanitizer has handlers of its own";
  std::string pattern;
  std::getline(std::ifstream("/proc/sys/kernel/core_pattern"), pattern);
  rlimit cores{};
  getrlimit(RLIMIT_CORE, &cores);
  if (pattern.find_first_of("|/") != std::string::npos || cores.rlim_max != RLIM_INFINITY) {
    GTEST_SKIP() << "core dumps go elsewhere, or are not allowed";
  }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("lsos_core_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const Heard heard = in_child([&] {
    std::filesystem::current_path(folder);
    const rlimit any{cores.rlim_max, cores.rlim_max};
    setrlimit(RLIMIT_CORE, &any);
    catch_fatal_signals();
    std::abort();
    return 0;
  });
  EXPECT_EQ(heard.ending.code, 3);
  EXPECT_FALSE(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder);
}

// A stack that has overflowed has no room for a handler.
TEST(FatalSignal, of_an_overflowing_stack_ends_with_a_sentence) {
  if (test::is_sanitized) GTEST_SKIP() << "the sanitizer has handlers of its own";
  const Heard heard = in_child([] {
    catch_fatal_signals();
    const auto fall = [](const auto& self, int depth) -> int {
      volatile char room[4096] = {};
      room[0] = static_cast<char>(depth);
      return depth < 0 ? 0 : self(self, depth + 1) + room[0];
    };
    return fall(fall, 0);
  });
  EXPECT_EQ(heard.ending.code, 3);
  EXPECT_THAT(heard.err, HasSubstr("(SIGSEGV)"));
}

}  // namespace
}  // namespace lsos
