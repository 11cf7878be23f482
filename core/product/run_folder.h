// The folder of a run's files, and the rules for changing it: a finished run of this program may be
// replaced, an unfinished one only when forced, anything else never.
#pragma once

#include <string>
#include <vector>

namespace lsos {

// "out/PLAN-NAME" for "some/where/PLAN-NAME.kml".
std::string default_run_folder(const std::string& plan_file);

// Whether its log has a checkpoint, from which a run that has not finished can go on.
bool has_checkpoint(const std::string& folder);

// Locks the folder against other writers until destroyed.
class RunFolder {
 public:
  // Checks that `path` may become the folder of a run and locks it. Missing folders are created;
  // existing files are not touched. Throws InputError with advice when another program writes
  // there, when it holds an unfinished run and `force` is not given, when it holds anything that is
  // no run of this program, when it is a link, and when it is not writable.
  RunFolder(const std::string& path, bool force);
  // The folder of a run that is to go on. Throws InputError when it holds no run, when another
  // program writes there, and when it is not writable.
  static RunFolder of_run(const std::string& path) { return {path}; }
  // Releases the lock. If neither `prepare` nor `reopen` was called, the folder is as it was found.
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::string& path() const { return path_; }
  // The path of a file in the folder.
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  // Moves the files of an earlier run into a folder within; other files stay. From now on the
  // folder holds an unfinished run until it has a summary. To be called only when the plan has
  // passed its checks, right before the log is created. Throws OutputError. The earlier run is kept
  // until `settle` removes it, or `discard` puts it back; after a kill in between the next
  // RunFolder does.
  void prepare();
  // Removes the earlier run: the new one has begun.
  void settle();
  // Removes what was made of the run's log, and keeps the log and the plan. From now on the run is
  // unfinished. To be called when the run can go on. Throws OutputError.
  void reopen();
  // Removes what was written of a run that failed to begin. The folder then is as it was before
  // `prepare`.
  void discard();
  // Removes a run that nobody needs, and the folder unless something else lies in it.
  void clear();

 private:
  RunFolder(const std::string& path);
  void make_folders();
  void lock();
  // Throws InputError if `prepare` would fail halfway.
  void check_replaceable();
  void mark_unfinished();
  void remove(const char* name);
  void remove_replaced();
  // Puts back an earlier run that lies aside: the one that was to replace it has not begun.
  void take_back();
  void release();

  std::string path_;
  std::vector<std::string> made_folders_;  // outermost first
  int lock_ = -1;                          // file descriptor
  bool has_made_lock_file_ = false;
  bool is_prepared_ = false;
  bool has_run_aside_ = false;   // from `prepare` on, until the new run has begun or failed to
  bool was_unfinished_ = false;  // the earlier run, before `prepare`
};

}  // namespace lsos
