#include "system/own_slurm.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

namespace lsos::test {

namespace {

namespace fs = std::filesystem;

// A port that nobody listens at now.
int free_port() {
  const int end = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  bind(end, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(end, reinterpret_cast<sockaddr*>(&address), &size);
  close(end);
  return ntohs(address.sin_port);
}

std::string machine() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  const std::string whole = name.data();
  return whole.substr(0, whole.find('.'));
}

std::string user() {
  std::string name = run_command({"id", "-un"}).out;
  return name.substr(0, name.find('\n'));
}

std::string config(const std::string& folder, int array_size_max) {
  const std::string name = machine(), text = R"(ClusterName=own
SlurmctldHost=)" + name + R"((127.0.0.1)
SlurmctldPort=)" + std::to_string(free_port()) +
                                             R"(
SlurmdPort=)" + std::to_string(free_port()) + R"(
SlurmUser=)" + user() + R"(
SlurmdUser=)" + user() + R"(
AuthType=auth/munge
AuthInfo=socket=DIR/munge/socket
StateSaveLocation=DIR/state
SlurmdSpoolDir=DIR/spool
SlurmctldPidFile=DIR/slurmctld.pid
SlurmdPidFile=DIR/slurmd.pid
SlurmctldLogFile=DIR/slurmctld.log
SlurmdLogFile=DIR/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
KillWait=10
SchedulerParameters=batch_sched_delay=0,bf_interval=2,sched_interval=2
MaxArraySize=)" + std::to_string(array_size_max) +
                                             R"(
NodeName=)" + name + R"( NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PreemptType=preempt/partition_prio
PreemptMode=CANCEL
SlurmctldParameters=preempt_send_user_signal
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP PriorityTier=1 GraceTime=60
PartitionName=urgent Nodes=ALL MaxTime=INFINITE State=UP PriorityTier=2
)";
  std::string filled = text;
  for (std::size_t at; (at = filled.find("DIR/")) != std::string::npos;) {
    filled.replace(at, 3, folder);
  }
  return filled;
}

std::string tail(const std::string& text) {
  constexpr std::size_t most = 1500;
  return text.size() > most ? text.substr(text.size() - most) : text;
}

}  // namespace

bool comes_true(const std::function<bool()>& condition, int within_s) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(within_s);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  return true;
}

bool OwnSlurm::is_installed() {
  for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol"}) {
    const std::string look = std::string("command -v ") + program;
    // Daemons lie in a folder that only root has in PATH.
    if (run_command({"sh", "-c", "PATH=$PATH:/usr/sbin; " + look}).exit_code != 0) return false;
  }
  return true;
}

OwnSlurm::OwnSlurm(int array_size_max) {
  const std::string folder = folder_.path();
  for (const char* name : {"state", "spool", "munge"}) {
    fs::create_directory(folder_ / name);
    fs::permissions(folder_ / name, fs::perms::owner_all);
  }
  std::string key;
  std::random_device random;
  for (int i = 0; i < 1024; ++i) key += static_cast<char>(random() % 256);
  fs::permissions(folder_.write("munge/key", key), fs::perms::owner_read);
  folder_.write("slurm.conf", config(folder, array_size_max));
  const std::string munge = folder + "/munge/";
  const auto daemon = [&](Words words) {
    words.front() = "/usr/sbin/" + words.front();
    return std::make_unique<Process>(words, Surroundings{folder_.path(), {environment()}});
  };
  munged_ = daemon({"munged", "--foreground", "--force", "--socket=" + munge + "socket",
                    "--key-file=" + munge + "key", "--pid-file=" + munge + "pid",
                    "--log-file=" + munge + "log", "--seed-file=" + munge + "seed"});
  if (!comes_true([&] { return fs::exists(munge + "socket"); }, 60)) return;
  controller_ = daemon({"slurmctld", "-D", "-c"});
  node_ = daemon({"slurmd", "-D"});
  is_up_ = comes_true(
      [&] {
        return ask({"sinfo", "--noheader", "--format=%t"}).find("idle") != std::string::npos;
      },
      120);
}

OwnSlurm::~OwnSlurm() {
  ask({"scancel", "--user=" + user()});
  comes_true([&] { return ask({"squeue", "--noheader"}).empty(); }, 60);
  for (Process* each : {node_.get(), controller_.get(), munged_.get()}) {
    if (each == nullptr) continue;
    each->signal(SIGTERM);
    comes_true([&] { return !each->is_running(); }, 30);
  }
}

std::string OwnSlurm::ask(const Words& words) const {
  return run_command(words, {.folder = folder_.path(), .environment = {environment()}}).out;
}

std::string OwnSlurm::state_of(const std::string& job) const {
  const std::string state = ask({"squeue", "--noheader", "--states=all", "--format=%T", "-j", job});
  return state.substr(0, state.find('\n'));
}

std::string OwnSlurm::logs() const {
  return tail(read_text(folder_ / "slurmctld.log")) + "\n" +
         tail(read_text(folder_ / "slurmd.log"));
}

}  // namespace lsos::test
