#include "base/stop_signal.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

namespace lsos {

namespace {

// Read and written by a handler.
std::atomic<int> noted{0};
std::atomic<const char*> task{nullptr};
std::atomic<bool> is_on_terminal{false};  // where a progress bar may stand
static_assert(std::atomic<int>::is_always_lock_free &&
              std::atomic<const char*>::is_always_lock_free);

// Writes in one piece, with functions that a handler may call.
void say(std::initializer_list<const char*> words) {
  std::array<char, 512> line;
  std::size_t length = 0;
  for (const char* word : words) {
    const std::size_t count = std::min(std::strlen(word), line.size() - length);
    std::memcpy(line.data() + length, word, count);
    length += count;
  }
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), length);
}

void note(int signal) {
  const int error = errno;
  int none = 0;
  const bool is_first = noted.compare_exchange_strong(none, signal);
  // A limit of CPU time is told again each second, and is no second request.
  if (signal != SIGXCPU) std::signal(signal, SIG_DFL);
  if (const char* what = task.load(); is_first && what != nullptr) {
    const char* name = name_of_signal(signal);
    const char* clear = is_on_terminal ? "\r\x1b[K" : "";
    if (signal == SIGXCPU) {
      say({clear, name, ": stops; first ", what, "\n"});
    } else {
      say({clear, name, ": stops; first ", what, "; a second ", name, " ends it at once\n"});
    }
  }
  errno = error;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_handlers = true;
#elif defined(__has_feature)
constexpr bool has_handlers = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool has_handlers = false;
#endif

// Lets a copy of the process die of the signal, which dumps the core of who has allowed that
// (ulimit -c), while this one keeps its exit code. _Fork is the one that a handler may call.
void dump_core(int signal) {
  const pid_t copy = ::_Fork();
  if (copy < 0) return;
  if (copy > 0) {
    while (::waitpid(copy, nullptr, 0) < 0 && errno == EINTR) {
    }
    return;
  }
  std::signal(signal, SIG_DFL);
  sigset_t blocked;
  sigemptyset(&blocked);
  sigaddset(&blocked, signal);
  ::sigprocmask(SIG_UNBLOCK, &blocked, nullptr);
  ::raise(signal);
  _exit(3);
}

[[noreturn]] void tell_of_fault(int signal) {
  const char* what =
      signal == SIGABRT  ? "the program or a library has given up (SIGABRT), as where memory is "
                           "short or a value is impossible"
      : signal == SIGBUS ? "a file in use was cut short, or its disk is full (SIGBUS)"
                         : "fault inside the program or a library (SIGSEGV), as where "
                           "memory is short";
  say({what, "; a run that was under way goes on with 'lsos-host resume'\n"});
  dump_core(signal);
  _exit(3);
}

}  // namespace

void catch_fatal_signals() {
  if (has_handlers) return;
  // A stack of its own, as that of the program may have overflowed.
  static std::array<char, 32768> stack_bytes;
  const stack_t other{stack_bytes.data(), 0, stack_bytes.size()};
  ::sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = tell_of_fault;
  action.sa_flags = SA_ONSTACK | SA_RESETHAND;
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS}) ::sigaction(signal, &action, nullptr);
}

void catch_signal(int signal, void (*handler)(int)) {
  struct sigaction before {};
  if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) return;
  std::signal(signal, handler);
}

void catch_stop_signals() {
  is_on_terminal = isatty(STDERR_FILENO) != 0;
  for (const int signal : stop_signals) catch_signal(signal, note);
}

void forget_stop_signals() {
  for (const int signal : stop_signals) catch_signal(signal, SIG_DFL);
}

int stop_signal() { return noted; }

const char* name_of_signal(int signal) {
  switch (signal) {
    case SIGINT:
      return "SIGINT";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    case SIGXCPU:
      return "SIGXCPU, the limit of CPU time";
    default:
      return "a signal";
  }
}

Task::Task(const char* what) : before_(task.exchange(what)) {}

Task::~Task() { task = before_; }

}  // namespace lsos
