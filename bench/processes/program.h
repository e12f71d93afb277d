// SPDX-License-Identifier: MIT
//
// Another program of this project as a child process: jostle-server, and who talks to it. Used by
// jostle-bench and by the tests of whole programs. One thread owns one of these.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace jostle::bench {

class Program {
public:
    // Runs the file at `path`; what it writes, on both streams, is added to the file `log`.
    Program(const std::string& path, const std::vector<std::string>& flags, const std::string& log);
    ~Program();  // kills what still runs
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    bool is_running();
    void signal(int number);
    // The exit status (128 + n after signal n; 127: there is no such program), or nothing when it
    // still runs then.
    std::optional<int> wait(std::chrono::milliseconds timeout);
    std::string log() const;
    pid_t pid() const { return pid_; }

private:
    pid_t pid_ = -1;
    std::optional<int> status_;
    std::string log_;
};

// The whole of a file; empty when it cannot be read.
std::string read_file(const std::string& path);

}  // namespace jostle::bench
