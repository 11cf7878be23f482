// Ground that a plan from elsewhere names, and who notices that it is opened.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/inotify.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>

#include "system/temp_folder.h"

namespace lsos::test {

inline constexpr const char* crs_of_moon =
    "GEOGCS[\"Moon\",DATUM[\"D_Moon\",SPHEROID[\"Moon\",1737400,0]],PRIMEM[\"Reference\",0],"
    "UNIT[\"Degree\",0.0174532925199433]]";

// Level ground around longitude 31, latitude 20.
inline void write_raster(const TempFolder& folder, const std::string& name) {
  std::string grid = "ncols 40\nnrows 40\nxllcorner 30.98\nyllcorner 19.98\ncellsize 0.001\n";
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) grid += "100 ";
    grid += "\n";
  }
  folder.write(name + ".asc", grid);
  folder.write(name + ".prj", crs_of_moon);
}

// Notices that a file is opened or read, by whatever program.
class Watched {
 public:
  explicit Watched(const std::filesystem::path& file) : descriptor_(inotify_init1(IN_NONBLOCK)) {
    inotify_add_watch(descriptor_, file.c_str(), IN_OPEN | IN_ACCESS);
  }
  ~Watched() { close(descriptor_); }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  bool was_opened() const {
    char buffer[4096];
    return read(descriptor_, buffer, sizeof buffer) > 0;
  }

 private:
  int descriptor_;
};

// A server on this machine that hangs up on who calls.
class Listener {
 public:
  Listener() : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        listen(socket_, 8) != 0 ||
        getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      ADD_FAILURE() << "no socket on the loopback";
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] {
      for (int call = 0; (call = accept(socket_, nullptr, nullptr)) >= 0; close(call)) ++calls_;
    });
  }
  ~Listener() {
    shutdown(socket_, SHUT_RDWR);  // accept then fails
    thread_.join();
    close(socket_);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  int port() const { return port_; }
  int calls() const { return calls_; }

 private:
  int socket_;
  int port_ = 0;
  std::atomic<int> calls_ = 0;
  std::thread thread_;
};

}  // namespace lsos::test
