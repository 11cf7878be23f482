#include "picture/film.h"

#include <fcntl.h>
#include <fmt/format.h>
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

#include "base/error.h"
#include "base/files.h"
#include "base/output_error.h"

namespace lsos {

namespace {

std::string ffmpeg() {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    std::string program = folder + "/ffmpeg";
    if (!folder.empty() && access(program.c_str(), X_OK) == 0) return program;
  }
  throw InputError({},
                   "films are made by the program ffmpeg, which is not installed: apt-get "
                   "install ffmpeg");
}

// Runs in the child, which reads pictures from its standard input. In its own process group it does
// not receive a terminal's Ctrl-C; this program handles that.
[[noreturn]] void exec_child(const std::vector<std::string>& words, int from_parent) {
  setpgid(0, 0);
  std::signal(SIGPIPE, SIG_DFL);
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  if (dup2(from_parent, STDIN_FILENO) >= 0) execv(argv[0], argv.data());
  _exit(127);
}

}  // namespace

Film::Film(const std::string& file, int width_px, int height_px)
    : file_(file), part_(file + std::string(part_suffix)) {
  const std::vector<std::string> words{ffmpeg(),       "-loglevel",
                                       "error",        "-y",
                                       "-f",           "rawvideo",
                                       "-pix_fmt",     "rgb24",
                                       "-video_size",  fmt::format("{}x{}", width_px, height_px),
                                       "-framerate",   std::to_string(film_frames_per_s),
                                       "-i",           "-",
                                       "-pix_fmt",     "yuv420p",
                                       "-movflags",    "+faststart",
                                       "-f",           "mp4",
                                       "file:" + part_};
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  child_ = fork();
  if (child_ == 0) exec_child(words, ends[0]);
  close(ends[0]);
  to_child_ = ends[1];
  if (child_ < 0) throw std::runtime_error(std::strerror(errno));
}

Film::~Film() {
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  end();
  std::remove(part_.c_str());
}

int Film::end() {
  close(to_child_);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void Film::add(std::span<const std::uint8_t> rgb) {
  while (!rgb.empty()) {
    const ssize_t written = write(to_child_, rgb.data(), rgb.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw OutputError(fmt::format("{}: ffmpeg has ended", file_));
    rgb = rgb.subspan(static_cast<std::size_t>(written));
  }
}

void Film::finish() {
  const int code = end();
  if (code == 0 && std::rename(part_.c_str(), file_.c_str()) == 0) return;
  const std::string why = code == 0 ? std::strerror(errno) : fmt::format("ffmpeg's code {}", code);
  std::remove(part_.c_str());
  throw OutputError(fmt::format("{}: cannot be made: {}", file_, why));
}

}  // namespace lsos
