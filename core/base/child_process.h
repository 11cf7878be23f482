// A process forked from this one, with a pipe to or from it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lsos {

class ChildProcess {
 public:
  enum class Pipe { none, to_child, from_child };

  // How a child has ended: by an exit code, or by a signal.
  struct Ending {
    std::optional<int> code, signal;

    bool is_success() const { return code == 0; }
  };

  // Forks. Returns absent in the child, where `pipe_end` is its end of the pipe (-1: none) and stop
  // signals have their default effect, save those that are ignored. The child is killed when this
  // process ends. Throws std::runtime_error.
  static std::optional<ChildProcess> fork(Pipe pipe, int& pipe_end);
  static std::optional<ChildProcess> fork();  // without a pipe
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  // Kills a child that has not been waited for.
  ~ChildProcess();

  // Writes to the child; false when it no longer reads.
  bool write(std::string_view bytes);
  // Everything that the child writes until it closes its end.
  std::string read_all();
  void send(int signal) const;
  // How it has ended; absent while it goes on. Not to be called again once it has ended.
  std::optional<Ending> poll();
  // Closes the pipe and waits. To be called once.
  Ending wait();

 private:
  ChildProcess(pid_t id, int pipe_end) : id_(id), pipe_end_(pipe_end) {}

  void close_pipe();
  Ending ended(int status);

  pid_t id_ = -1;  // -1: it has been waited for
  int pipe_end_ = -1;
};

// Writes all bytes to a file descriptor; false when that fails.
bool write_all(int file, std::string_view bytes);

// In a child: the program that it runs inherits this descriptor.
void keep_open(int descriptor);
// In a child: runs a program with `input` as its standard input. In its own process group it does
// not receive a terminal's Ctrl-C. Ends the process with code 127 when it cannot be run.
[[noreturn]] void run_program(const std::vector<std::string>& words, int input);

// The file of a program in the folders of PATH; "" where there is none.
std::string program_in_path(const std::string& name);

struct ProgramOutput {
  int code = 0;      // its exit code; 128 + the signal that ended it; 127: it could not be run
  std::string text;  // what it wrote to standard output and error, without blanks at its ends

  bool is_success() const { return code == 0; }
};

// Runs a program of PATH to its end, without input. words[0]: its name.
ProgramOutput program_output(const std::vector<std::string>& words);

}  // namespace lsos
