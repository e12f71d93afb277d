// SPDX-License-Identifier: MIT
//
// A jostle-server as a child process on free ports of the loopback device, with its own folder for
// the files of the server and its clients. Used by jostle-bench and by the tests.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "bench/processes/program.h"

namespace jostle::bench {

// A temporary folder; the destructor removes it with its content.
struct TemporaryFolder {
    TemporaryFolder();  // throws if the folder cannot be created
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path;
};

class ServerProcess {
public:
    // Starts the program at `path`. With `wait_for_ports` it returns when the ports are bound, when
    // the program has ended, or after 20 s.
    ServerProcess(const std::string& path, std::vector<std::string> flags, bool wait_for_ports);

    bool is_running() { return program_.is_running(); }
    int grpc_port() const { return grpc_port_; }
    int http_port() const { return http_port_; }
    int admin_port() const { return admin_port_; }
    pid_t pid() const { return program_.pid(); }
    std::string grpc_address() const { return "127.0.0.1:" + std::to_string(grpc_port_); }
    std::string file(const std::string& name) const { return folder_.path + "/" + name; }

    void signal(int number) { program_.signal(number); }
    // See Program::wait.
    std::optional<int> wait(std::chrono::milliseconds timeout) { return program_.wait(timeout); }
    std::string log() const { return program_.log(); }
    double cpu_seconds() const;  // user and system time since the start

private:
    bool read_ports();

    TemporaryFolder folder_;
    Program program_;
    int grpc_port_ = 0, http_port_ = 0, admin_port_ = 0;
};

}  // namespace jostle::bench
