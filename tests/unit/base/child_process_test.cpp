#include "base/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

namespace lsos {
namespace {

// Forks a child that ends with the exit code that `work` returns for its end of the pipe.
template <class Work>
ChildProcess child(ChildProcess::Pipe pipe, const Work& work) {
  int pipe_end = -1;
  std::optional<ChildProcess> process = ChildProcess::fork(pipe, pipe_end);
  if (!process) _exit(work(pipe_end));
  return std::move(*process);
}

TEST(ChildProcess, is_read_until_it_ends) {
  const std::string long_text(1'000'000, 'x');  // more than a pipe holds
  ChildProcess process = child(ChildProcess::Pipe::from_child, [&](int pipe_end) {
    return write_all(pipe_end, long_text) ? 7 : 1;
  });
  EXPECT_EQ(process.read_all(), long_text);
  EXPECT_EQ(process.wait().code, 7);
}

TEST(ChildProcess, reads_what_it_is_written) {
  ChildProcess process = child(ChildProcess::Pipe::to_child, [](int pipe_end) {
    char letter = 0;
    int count = 0;
    while (::read(pipe_end, &letter, 1) == 1) ++count;
    return count;
  });
  EXPECT_TRUE(process.write("twelve bytes"));
  EXPECT_EQ(process.wait().code, 12);
}

TEST(ChildProcess, that_no_longer_reads_is_written_nothing) {
  std::signal(SIGPIPE, SIG_IGN);
  ChildProcess process = child(ChildProcess::Pipe::to_child, [](int) { return 0; });
  bool is_read = true;
  for (int i = 0; i < 1000 && is_read; ++i) is_read = process.write(std::string(4096, 'x'));
  EXPECT_FALSE(is_read);
  EXPECT_TRUE(process.wait().is_success());
  std::signal(SIGPIPE, SIG_DFL);
}

TEST(ChildProcess, ends_by_the_signal_that_it_is_sent) {
  ChildProcess process = child(ChildProcess::Pipe::none, [](int) { return pause(); });
  process.send(SIGTERM);
  const ChildProcess::Ending ending = process.wait();
  EXPECT_EQ(ending.signal, SIGTERM);
  EXPECT_FALSE(ending.code);
  EXPECT_FALSE(ending.is_success());
}

// Were it not killed, the destructor would wait for ever.
TEST(ChildProcess, that_is_not_waited_for_is_killed) {
  child(ChildProcess::Pipe::from_child, [](int) { return pause(); });
}

TEST(ChildProcess, runs_a_program_on_its_input) {
  int pipe_end = -1;
  std::optional<ChildProcess> process = ChildProcess::fork(ChildProcess::Pipe::to_child, pipe_end);
  if (!process) run_program({"/bin/sh"}, pipe_end);
  process->write("exit 5\n");
  EXPECT_EQ(process->wait().code, 5);
  process.reset();
  std::optional<ChildProcess> absent = ChildProcess::fork(ChildProcess::Pipe::to_child, pipe_end);
  if (!absent) run_program({"/no/such/program"}, pipe_end);
  EXPECT_EQ(absent->wait().code, 127);
}

TEST(ProgramOutput, says_what_a_program_printed_and_how_it_ended) {
  const ProgramOutput said = program_output({"sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(said.text, "out\nerr");
  EXPECT_EQ(said.code, 3);
  EXPECT_EQ(program_output({"sh", "-c", "kill -9 $$"}).code, 128 + 9);
  EXPECT_TRUE(program_output({"cat"}).is_success()) << "it has no input";
}

TEST(ProgramOutput, is_that_of_no_program_where_there_is_none) {
  EXPECT_EQ(program_in_path("no-such-program"), "");
  EXPECT_EQ(program_output({"no-such-program"}).code, 127);
}

}  // namespace
}  // namespace lsos
