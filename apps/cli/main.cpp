// kiri, the command line of KiriSim.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "apps/cli/run.h"

namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t stopIsWanted = 0;

/// The first Ctrl-C asks the work to stop cleanly, the second one ends the program.
void askToStop(int signal) {
  stopIsWanted = 1;
  std::signal(signal, SIG_DFL);
}

/// Where the file of the running program is.
std::string programFolder() {
  std::error_code error;
  const std::filesystem::path file = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "" : file.parent_path().string();
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, askToStop);
  std::signal(SIGTERM, askToStop);
  std::signal(SIGPIPE, SIG_IGN);
  std::ios::sync_with_stdio(false);
  kiri::cli::Console console{std::cin,
                             std::cout,
                             std::cerr,
                             ::isatty(STDERR_FILENO) == 1,
                             [] { return stopIsWanted != 0; },
                             programFolder()};
  return kiri::cli::run(std::vector<std::string>(argv + 1, argv + argc), console);
}
