// SPDX-License-Identifier: MIT
//
// The UDP socket by which clients that asked for it get their snapshots (docs/protocol.md). One
// thread takes what comes, many packets at a time, and hands each to the path whose ticket it
// names; what names none is dropped, without an answer. Paths send by themselves.
//
// Thread rule: start() and stop() from one thread, all else from any. Outlives its paths.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <unordered_map>

#include "jostle/base/result.h"
#include "server/udp/datagram_connection.h"

namespace jostle::server {

struct DatagramServerSettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 0;             // 0: any that is free
    std::uint16_t advertised_port = 0;  // 0: the real one
    Metrics* metrics = nullptr;         // null: nobody counts
};

class DatagramServer {
public:
    explicit DatagramServer(DatagramServerSettings settings) : settings_(std::move(settings)) {}
    ~DatagramServer();
    DatagramServer(const DatagramServer&) = delete;
    DatagramServer& operator=(const DatagramServer&) = delete;

    // An error says which address and why.
    Status start();
    // No packet is taken any more, and no path is called. What paths send still goes out.
    void stop();
    std::uint16_t port() const { return port_; }  // the real one, after start()
    std::uint16_t advertised_port() const {
        return settings_.advertised_port != 0 ? settings_.advertised_port : port_;
    }

    // A new way, with a ticket of its own. `on_message` as of DatagramConnection.
    Result<std::shared_ptr<DatagramConnection>> open(
        std::function<void(std::string_view)> on_message);
    // Packets with this ticket are dropped from now on. One that is being handed over may still be.
    void close(const DatagramConnection& path);
    std::size_t connections() const;

private:
    void run();
    void take_packets();
    std::shared_ptr<DatagramConnection> find(std::uint64_t credentials) const;

    const DatagramServerSettings settings_;
    int socket_ = -1, wake_ = -1;
    std::uint16_t port_ = 0;
    mutable std::mutex mutex_;
    std::unordered_map<std::uint64_t, std::shared_ptr<DatagramConnection>>
        connections_;  // by ticket
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace jostle::server
