// SPDX-License-Identifier: MIT
//
// A real jostle-server as a child process on free ports of the loopback device, with a folder of
// its own for what it and those who talk to it write. Used by jostle-bench and by the tests.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "bench/processes/program.h"

namespace jostle::bench {

// Made before the server and gone after it, with all that is in it.
struct TemporaryFolder {
    TemporaryFolder();  // throws when there can be none
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path;
};

class ServerProcess {
public:
    // Starts the program at `path`; with `wait_for_ports` returns when its ports are bound, or when
    // the program ended.
    ServerProcess(const std::string& path, std::vector<std::string> flags, bool wait_for_ports);

    bool is_running() { return program_.is_running(); }
    int grpc_port() const { return grpc_port_; }
    int http_port() const { return http_port_; }
    int admin_port() const { return admin_port_; }
    pid_t pid() const { return program_.pid(); }
    std::string grpc_address() const { return "127.0.0.1:" + std::to_string(grpc_port_); }
    std::string file(const std::string& name) const { return folder_.path + "/" + name; }

    void signal(int number) { program_.signal(number); }
    // As Program::wait.
    std::optional<int> wait(std::chrono::milliseconds timeout) { return program_.wait(timeout); }
    std::string log() const { return program_.log(); }
    double cpu_seconds() const;  // so far, user and system

private:
    bool read_ports();

    TemporaryFolder folder_;
    Program program_;
    int grpc_port_ = 0, http_port_ = 0, admin_port_ = 0;
};

}  // namespace jostle::bench
