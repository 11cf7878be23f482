#include "system/process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "support/reference_data.h"

namespace lsos::test {

namespace {

[[noreturn]] void become(const Words& words, const Surroundings& where, int out, int err) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = open("/dev/null", O_RDONLY);
  if (dup2(nothing, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) _exit(126);
  if (chdir(where.folder.c_str()) != 0) _exit(126);
  if (where.cpu_max_s > 0) {
    const auto most = static_cast<rlim_t>(where.cpu_max_s);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_CPU, &limit);
  }
  // Rasters of the reference data are named by plans that lie elsewhere.
  if (std::filesystem::is_directory(reference_folder())) {
    setenv("LSOS_REFERENCE_DATA", reference_folder().c_str(), 0);
  }
  for (const std::string& variable : where.environment) {
    putenv(const_cast<char*>(variable.c_str()));
  }
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  dprintf(2, "cannot run %s\n", argv[0]);
  _exit(127);
}

std::string all_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char buffer[4096];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;) text.append(buffer, n);
  return text;
}

}  // namespace

Process::Process(const Words& words, const Surroundings& where)
    : out_(std::tmpfile()), err_(std::tmpfile()) {
  if (!out_ || !err_) throw std::runtime_error("no temporary file");
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ == 0) become(words, where, fileno(out_.get()), fileno(err_.get()));
}

Process::~Process() {
  if (!is_running()) return;
  signal(SIGKILL);
  reap(0);
}

void Process::reap(int options) {
  if (is_running_ && wait4(pid_, &status_, options, &usage_) == pid_) is_running_ = false;
}

bool Process::is_running() {
  reap(WNOHANG);
  return is_running_;
}

void Process::signal(int number) {
  if (is_running_) kill(pid_, number);
}

std::string Process::err_so_far() {
  std::string text;
  char buffer[4096];
  // Read by place, as the program writes at the file's own.
  for (ssize_t count = 0; (count = pread(fileno(err_.get()), buffer, sizeof buffer,
                                         static_cast<off_t>(text.size()))) > 0;) {
    text.append(buffer, static_cast<std::size_t>(count));
  }
  return text;
}

Outcome Process::wait() {
  reap(0);
  Outcome outcome;
  outcome.was_killed = WIFSIGNALED(status_);
  outcome.exit_code = outcome.was_killed ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  outcome.cpu_s = seconds(usage_.ru_utime) + seconds(usage_.ru_stime);
  outcome.memory_mib = static_cast<double>(usage_.ru_maxrss) / 1024;
  outcome.out = all_of(out_.get());
  outcome.err = all_of(err_.get());
  return outcome;
}

Outcome run_command(const Words& words, const Surroundings& where) {
  return Process(words, where).wait();
}

Words program(const Words& arguments) {
  Words words = {LSOS_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

Outcome run(const Words& arguments, const Surroundings& where) {
  return run_command(program(arguments), where);
}

}  // namespace lsos::test
