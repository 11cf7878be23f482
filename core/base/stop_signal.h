// Signals by which a user, a terminal or a batch system asks the program to stop, and those of
// faults that end it.
#pragma once

#include <array>
#include <csignal>

namespace lsos {

// The last comes each second once the limit of CPU time (ulimit -t) has passed.
inline constexpr std::array stop_signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

// From now on the first of them is noted instead of ending the program. What the program still does
// is then said on standard error at once, see Task. The same signal a second time ends it, which no
// other does: a batch system may send two kinds in one go. A signal that the parent ignores stays
// ignored, as SIGINT in the background of a shell script and SIGHUP under nohup.
void catch_stop_signals();
// Gives those that are caught their default effect.
void forget_stop_signals();

// The signal that was noted; 0: none.
int stop_signal();
// "SIGINT"
const char* name_of_signal(int signal);

// From now on SIGABRT, SIGSEGV and SIGBUS end the program with a sentence on standard error and
// exit code 3, after a core dump where the user allows them. Libraries raise them where memory is
// short: GDAL aborts, the renderer's compiler writes through null; so does std::terminate. Does
// nothing in a build with a sanitizer, which has handlers of its own.
void catch_fatal_signals();

// Installs `handler`, unless the parent ignores the signal.
void catch_signal(int signal, void (*handler)(int));

// What the program does while an object exists, for whoever asks it to stop: "the report is
// written". One thread has tasks.
class Task {
 public:
  // `what` must outlive all tasks.
  explicit Task(const char* what);
  ~Task();
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

 private:
  const char* before_;
};

}  // namespace lsos
