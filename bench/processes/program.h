// SPDX-License-Identifier: MIT
//
// A program of this project as a child process, such as jostle-server or a client. Used by
// jostle-bench and by the tests of whole programs. A Program is used by one thread.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace jostle::bench {

class Program {
public:
    // Runs the program at `path`; its stdout and stderr are appended to the file `log`.
    Program(const std::string& path, const std::vector<std::string>& flags, const std::string& log);
    ~Program();  // kills the process if it still runs
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    bool is_running();
    void signal(int number);
    // Returns the exit status (128 + n after signal n; 127: the program does not exist), or nothing
    // if the process still runs after the timeout.
    std::optional<int> wait(std::chrono::milliseconds timeout);
    std::string log() const;
    pid_t pid() const { return pid_; }

private:
    pid_t pid_ = -1;
    std::optional<int> status_;
    std::string log_;
};

// Returns the content of a file; empty if it cannot be read.
std::string read_file(const std::string& path);

// Runs work in a child process: its memory is measured separately, and a crash does not end the
// program.
struct ChildResult {
    std::string text;     // the result of the work
    std::string failure;  // why the process ended without a result; empty on success
};

// Forks, runs the work in the child and waits for it. This process must have only one thread.
ChildResult run_in_child(const std::function<std::string()>& work);

}  // namespace jostle::bench
