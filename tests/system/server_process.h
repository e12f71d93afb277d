// SPDX-License-Identifier: MIT
//
// A real jostle-server as a child process on free ports of the loopback device.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace jostle::test {

class ServerProcess {
public:
    // Starts the program; with `wait_for_ports` returns when its ports are bound, or when the
    // program ended.
    explicit ServerProcess(std::vector<std::string> flags, bool wait_for_ports = true);
    ~ServerProcess();  // kills what still runs
    ServerProcess(const ServerProcess&) = delete;
    ServerProcess& operator=(const ServerProcess&) = delete;

    bool runs();
    int grpc_port() const { return grpc_port_; }
    int http_port() const { return http_port_; }
    int admin_port() const { return admin_port_; }
    std::string grpc_address() const { return "127.0.0.1:" + std::to_string(grpc_port_); }

    void signal(int number);
    // The exit status (128 + n after signal n), or nothing when it still runs then.
    std::optional<int> wait(std::chrono::milliseconds patience);
    std::string log() const;
    double cpu_seconds() const;  // so far, user and system

private:
    bool read_ports();

    pid_t pid_ = -1;
    std::optional<int> status_;
    std::string folder_;
    int grpc_port_ = 0, http_port_ = 0, admin_port_ = 0;
};

}  // namespace jostle::test
