// Commands of the shell, their output and exit code.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace umbral::test {

struct CommandResult {
  int exit_code;     // 128 + the signal's number where one ended it
  std::string text;  // of both output streams
};

inline CommandResult run_command(const std::string& command) {
  std::FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
  std::string text;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text};
}

}  // namespace umbral::test
