#include "base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/stop_signal.h"
#include "base/text.h"

namespace lsos {

namespace {

[[noreturn]] void refuse(const char* what) {
  throw std::runtime_error(fmt::format("no {}: {}", what, std::strerror(errno)));
}

// A child that outlives the program would go on writing what nobody reads.
void end_with(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
}

// Forks with stop signals blocked, so that none reaches the child while a handler of the parent is
// still installed there and would swallow it.
pid_t fork_with_default_signals() {
  sigset_t blocked, before;
  sigemptyset(&blocked);
  for (const int signal : stop_signals) sigaddset(&blocked, signal);
  sigprocmask(SIG_BLOCK, &blocked, &before);
  const pid_t parent = getpid();
  const pid_t id = ::fork();
  if (id == 0) {
    end_with(parent);
    forget_stop_signals();
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  return id;
}

}  // namespace

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void keep_open(int descriptor) { fcntl(descriptor, F_SETFD, 0); }

void run_program(const std::vector<std::string>& words, int input) {
  setpgid(0, 0);
  std::signal(SIGPIPE, SIG_DFL);
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  if (dup2(input, STDIN_FILENO) >= 0) execv(argv[0], argv.data());
  _exit(127);
}

std::optional<ChildProcess> ChildProcess::fork(Pipe pipe, int& pipe_end) {
  std::array<int, 2> ends{-1, -1};  // the first is read from, the second written to
  if (pipe != Pipe::none && pipe2(ends.data(), O_CLOEXEC) != 0) refuse("pipe for a process");
  const auto [childs, ours] =
      pipe == Pipe::to_child ? std::pair(ends[0], ends[1]) : std::pair(ends[1], ends[0]);
  std::fflush(nullptr);  // what stands in buffers is not written twice
  const pid_t id = fork_with_default_signals();
  const int error = errno;
  if (pipe != Pipe::none) close(id == 0 ? ours : childs);
  if (id < 0) {
    if (pipe != Pipe::none) close(ours);
    errno = error;
    refuse("further process");
  }
  pipe_end = childs;
  if (id == 0) return {};
  return ChildProcess(id, ours);
}

std::optional<ChildProcess> ChildProcess::fork() {
  int pipe_end = -1;
  return fork(Pipe::none, pipe_end);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : id_(std::exchange(other.id_, -1)), pipe_end_(std::exchange(other.pipe_end_, -1)) {}

ChildProcess::~ChildProcess() {
  if (id_ < 0) return;
  send(SIGKILL);
  wait();
}

void ChildProcess::close_pipe() {
  if (pipe_end_ >= 0) close(pipe_end_);
  pipe_end_ = -1;
}

bool ChildProcess::write(std::string_view bytes) { return write_all(pipe_end_, bytes); }

std::string ChildProcess::read_all() {
  std::string bytes;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = read(pipe_end_, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void ChildProcess::send(int signal) const { kill(id_, signal); }

ChildProcess::Ending ChildProcess::wait() {
  close_pipe();
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  return ended(status);
}

std::optional<ChildProcess::Ending> ChildProcess::poll() {
  int status = 0;
  if (waitpid(id_, &status, WNOHANG) != id_) return {};
  close_pipe();
  return ended(status);
}

ChildProcess::Ending ChildProcess::ended(int status) {
  id_ = -1;
  Ending ending;
  if (WIFEXITED(status)) ending.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  return ending;
}

std::string program_in_path(const std::string& name) {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    std::string program = folder + "/" + name;
    if (!folder.empty() && access(program.c_str(), X_OK) == 0) return program;
  }
  return "";
}

ProgramOutput program_output(const std::vector<std::string>& words) {
  std::vector<std::string> command = words;
  command.front() = program_in_path(words.front());
  if (command.front().empty()) return {127, ""};
  int output = -1;
  std::optional<ChildProcess> process = ChildProcess::fork(ChildProcess::Pipe::from_child, output);
  if (!process) {
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    run_program(command, open("/dev/null", O_RDONLY | O_CLOEXEC));
  }
  const std::string text = process->read_all();
  const ChildProcess::Ending ending = process->wait();
  const int code = ending.signal ? 128 + *ending.signal : ending.code.value_or(127);
  return {code, std::string(trimmed(text))};
}

}  // namespace lsos
