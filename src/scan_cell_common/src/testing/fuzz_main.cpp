// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/testing/fuzzing.h"
#include "scan_cell_common/tools/tool_main.h"

namespace scan_cell_common {
namespace {

struct Options {
  std::string target;
  std::uint64_t runs = 100000;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  std::string save;
  std::string seeds;
};

/// The present run, for the signal handler.
struct Now {
  const char* target = "";
  std::uint64_t seed = 0;
  volatile std::uint64_t run = 0;
};
Now now;

void tell_and_exit(int signal) {
  const char* const what = signal == SIGPROF ? "no end within 10 s" : "crashed";
  std::array<char, 256> text;
  const int size = std::snprintf(text.data(), text.size(), "%s, seed %llu, run %llu: %s\n",
                                 now.target, static_cast<unsigned long long>(now.seed),
                                 static_cast<unsigned long long>(now.run), what);
  if (write(STDERR_FILENO, text.data(), static_cast<std::size_t>(size)) < 0) _exit(2);
  _exit(1);
}

void watch_for_crashes() {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGPROF})
    std::signal(signal, tell_and_exit);
#ifndef __SANITIZE_ADDRESS__
  const rlimit memory{rlim_t{2} << 30, rlim_t{2} << 30};
  setrlimit(RLIMIT_AS, &memory);
#endif
}

/// In processor time, since a busy machine is not a fault. 0: never.
void end_after(time_t seconds) {
  const itimerval timer{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &timer, nullptr);
}

void fuzz_and_tell(const FuzzTarget& target, const Options& options) {
  constexpr time_t kLongest = 10;  // [s]
  constexpr double kTell = 10;     // [s]
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  };
  const Clock::time_point start = Clock::now();
  Clock::time_point told = start;
  FuzzCount count;
  const auto tell = [&](const char* end) {
    std::cerr << '\r' << target.name << ": " << count.taken + count.refused << " runs, "
              << count.taken << " taken, " << count.refused << " refused, " << since(start) << " s"
              << end << std::flush;
  };
  now.target = target.name.c_str();
  now.seed = options.seed;
  for (std::uint64_t run = options.first; run < options.first + options.runs / target.cost; ++run) {
    now.run = run;
    end_after(kLongest);
    fuzz_once(target, fuzz_input(target, options.seed, run), count);
    constexpr std::uint64_t kLook = 1024;
    if (run % kLook != 0 || since(told) < kTell) continue;
    tell("");
    told = Clock::now();
  }
  end_after(0);
  tell("\n");
}

void save_seeds(const FuzzTarget& target, const std::string& folder) {
  for (std::size_t i = 0; i < target.seeds.size(); ++i)
    save_text(fmt::format("{}/{}_{}", folder, target.name, i), target.seeds[i]);
}

void add_options(CLI::App& app, Options& options, const std::vector<FuzzTarget>& targets) {
  std::vector<std::string> names;
  for (const FuzzTarget& target : targets)
    names.push_back(target.name);
  app.add_option("--target", options.target, "one of the readers; default: all")
      ->check(CLI::IsMember(names));
  app.add_option("--runs", options.runs, "per reader; fewer for slow ones")->capture_default_str();
  app.add_option("--seed", options.seed, "of the changes")->capture_default_str();
  app.add_option("--first", options.first, "number of the first run")->capture_default_str();
  app.add_option("--save", options.save, "writes the input of the first run here, and ends");
  app.add_option("--seeds", options.seeds, "writes the unchanged files into this folder, and ends");
}

/// @throw FuzzFault
void run(const Options& options, const std::vector<FuzzTarget>& targets) {
  if (options.save.empty() && options.seeds.empty()) watch_for_crashes();
  for (const FuzzTarget& target : targets) {
    if (!options.target.empty() && target.name != options.target) continue;
    if (!options.save.empty()) {
      save_text(options.save, fuzz_input(target, options.seed, options.first));
      return;
    }
    if (options.seeds.empty()) {
      fuzz_and_tell(target, options);
    } else {
      save_seeds(target, options.seeds);
    }
  }
}

}  // namespace

int fuzz_main(int argc, char** argv, const std::vector<FuzzTarget>& targets) {
  Options options;
  CLI::App app("Gives readers changed valid files: each must be taken or refused with an Error.");
  add_options(app, options, targets);
  const std::string name = std::filesystem::path(argv[0]).filename();
  return tool_main(name, app, argc, argv, [&] {
    try {
      run(options, targets);
      return 0;
    } catch (const FuzzFault& fault) {
      std::cerr << '\n'
                << now.target << ", seed " << now.seed << ", run " << now.run << ": "
                << fault.what() << '\n';
      return 1;
    }
  });
}

int fuzz_bytes(const std::vector<FuzzTarget>& targets, const std::uint8_t* data, std::size_t size) {
  const char* const name = std::getenv("FUZZ_TARGET");
  for (const FuzzTarget& target : targets) {
    if (name == nullptr || target.name != name) continue;
    FuzzCount count;
    fuzz_once(target, std::string(reinterpret_cast<const char*>(data), size), count);
    return 0;
  }
  std::cerr << "FUZZ_TARGET names none of the readers\n";
  std::exit(1);
}

}  // namespace scan_cell_common
