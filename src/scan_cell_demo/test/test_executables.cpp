// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <regex>
#include <set>

#include "scan_cell_common/files/files.h"

namespace fs = std::filesystem;

namespace {

/// Every executable of the suite that is installed and built: benchmarks and fuzzers may be
/// missing.
std::set<std::string> installed_executables() {
  const std::regex installed(R"(DESTINATION "[^"]*/lib/[^"/]+" TYPE (EXECUTABLE|PROGRAM)[^"]*FILES)"
                             R"( "([^"]+)\")");
  std::set<std::string> programs;
  for (const fs::directory_entry& package : fs::directory_iterator(BUILD_FOLDER)) {
    const fs::path script = package.path() / "cmake_install.cmake";
    if (!fs::exists(script)) continue;
    const std::string text = scan_cell_common::read_file(script.string());
    for (std::sregex_iterator at(text.begin(), text.end(), installed), end; at != end; ++at) {
      if (fs::exists((*at)[2].str())) programs.insert((*at)[2]);
    }
  }
  return programs;
}

/// From now on this process and its successor are killed (SIGSYS) if they open a socket, except
/// local ones (AF_UNIX): glog asks the name service for the user before main().
bool forbid_sockets() {
  sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_socket, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_UNIX, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter = {sizeof rules / sizeof rules[0], rules};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

struct Answer {
  int status;        //!< from waitpid()
  std::string text;  //!< of both outputs
};

/// Runs a program in a folder, with one argument, no ROS master, and without access to sockets.
Answer ask(const std::string& program, const char* question, const fs::path& folder) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    constexpr unsigned kLongest = 30;  // [s] on a busy machine
    const bool ready = dup2(ends[1], STDOUT_FILENO) >= 0 && dup2(ends[1], STDERR_FILENO) >= 0 &&
                       dup2(open("/dev/null", O_RDONLY), STDIN_FILENO) >= 0 &&
                       chdir(folder.c_str()) == 0 && unsetenv("ROS_MASTER_URI") == 0 &&
                       close(ends[0]) == 0 && forbid_sockets();
    alarm(kLongest);
    if (ready) execl(program.c_str(), program.c_str(), question, nullptr);
    _exit(127);
  }
  close(ends[1]);
  Answer answer{0, ""};
  char bytes[4096];
  for (ssize_t size; (size = read(ends[0], bytes, sizeof bytes)) > 0;)
    answer.text.append(bytes, static_cast<std::size_t>(size));
  close(ends[0]);
  waitpid(child, &answer.status, 0);
  return answer;
}

std::string version_in(const fs::path& package_xml) {
  const std::string text = scan_cell_common::read_file(package_xml.string());
  std::smatch found;
  return std::regex_search(text, found, std::regex("<version>([^<]+)</version>"))
             ? found[1].str()
             : "none in " + package_xml.string();
}

std::string suite_version() {
  return version_in(fs::path(SOURCE_FOLDER) / "scan_cell_common/package.xml");
}

}  // namespace

TEST(Executables, AnswerHelpAndVersionAndStartNothing) {
  const std::set<std::string> programs = installed_executables();
  constexpr std::size_t kNodesAndTools = 25;
  ASSERT_GE(programs.size(), kNodesAndTools);
  const fs::path folder = testing::TempDir() + "executables_" + std::to_string(getpid());
  fs::create_directories(folder);
  for (const std::string& program : programs) {
    SCOPED_TRACE(program);
    const Answer help = ask(program, "--help", folder);
    EXPECT_EQ(help.status, 0) << help.text;
    for (const char* part : {"--help", "--version"})
      EXPECT_NE(help.text.find(part), std::string::npos) << help.text;
    const Answer version = ask(program, "--version", folder);
    EXPECT_EQ(version.status, 0) << version.text;
    EXPECT_TRUE(std::regex_match(version.text, std::regex("[a-z0-9_.]+ " + suite_version() + "\n")))
        << version.text;
    EXPECT_TRUE(fs::is_empty(folder));
  }
  fs::remove_all(folder);
}

TEST(Executables, RefuseAnOptionTheyDoNotKnow) {
  for (const std::string& program : installed_executables()) {
    const Answer answer = ask(program, "--hepl", testing::TempDir());
    EXPECT_TRUE(WIFEXITED(answer.status) && WEXITSTATUS(answer.status) != 0) << program;
    if (fs::path(program).extension() == ".py") continue;
    EXPECT_NE(answer.text.find("did you mean --help?"), std::string::npos)
        << program << ": " << answer.text;
  }
}

TEST(Packages, AreAllOfTheSuitesVersion) {
  for (const fs::directory_entry& package : fs::directory_iterator(SOURCE_FOLDER)) {
    const fs::path file = package.path() / "package.xml";
    if (!fs::exists(file)) continue;
    EXPECT_EQ(version_in(file), suite_version()) << file;
  }
}
