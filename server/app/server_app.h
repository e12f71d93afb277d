// SPDX-License-Identifier: MIT
//
// A complete server: worlds, authentication, persistence and the listeners for gRPC, HTTP and
// operators. jostle-server runs one; a program of your own can start one in its process.
//
// Thread rule: start(), run() and stop() are called from one thread. ports() and drain() may be
// called from any thread after start().
#pragma once

#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "server/app/port_file.h"
#include "server/config/config.h"

namespace jostle::server {

class ServerApp {
public:
    struct Options {
        std::string version;         // for metrics and logs
        bool handle_signals = true;  // SIGTERM and SIGINT drain the server, from start() on
    };

    // Validates nothing: call check() and check_exposure() on the configuration first. Returns
    // after every listener accepts connections and every world ticks. Errors: the configured
    // web root contains no viewer, a scene, database, key or certificate file cannot be loaded, or
    // a port cannot be bound.
    static Result<std::unique_ptr<ServerApp>> start(Config config, const Options& options);
    ~ServerApp();
    ServerApp(const ServerApp&) = delete;
    ServerApp& operator=(const ServerApp&) = delete;

    // The bound ports; they differ from the configuration if it requested port 0.
    const Ports& ports() const;

    // Serves until a signal, drain() or an operator's Drain call ends it, then drains: clients are
    // notified and get drain_timeout_seconds to leave. Call stop() afterwards.
    void run();
    // Any thread: makes run() drain and return.
    void drain();
    // Closes the listeners, stops the worlds and writes their last checkpoints. Idempotent; the
    // destructor calls it. Ends the process with status 3 if it takes longer than 2.5 s.
    void stop();

private:
    class Impl;
    explicit ServerApp(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// Starts a server, writes its ports to `port_file` unless it is empty, runs it and stops it.
// Returns the exit status of the process: 0 success, 1 start failed.
int run_server(const Config& config, const std::string& port_file, const std::string& version);

}  // namespace jostle::server
