// Starts programs as a user's shell does: lsos-host itself, and the tools that read its results.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lsos::test {

using Words = std::vector<std::string>;

struct Outcome {
  int exit_code = 0;        // 128 + the signal when was_killed
  bool was_killed = false;  // ended by a signal that it did not handle
  std::string out;
  std::string err;
};

struct Surroundings {
  std::filesystem::path folder = ".";
  Words environment = {};  // "NAME=value", in addition to this process's
};

// A running program. It is killed when this object is destroyed or this process ends.
class Process {
 public:
  // words[0] is searched in PATH. Standard input is empty.
  explicit Process(const Words& words, const Surroundings& where = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool is_running();
  pid_t id() const { return pid_; }
  // What it has written to standard error so far.
  std::string err_so_far();
  void signal(int number);
  // Waits until the program has ended.
  Outcome wait();

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, CloseFile>;

  void reap(int options);

  File out_, err_;
  pid_t pid_ = -1;
  bool is_running_ = true;
  int status_ = 0;
};

// Runs any program to its end.
Outcome run_command(const Words& words, const Surroundings& where = {});

// The words that start lsos-host with these arguments, and a function that runs it to its end.
Words program(const Words& arguments);
Outcome run(const Words& arguments, const Surroundings& where = {});

}  // namespace lsos::test
