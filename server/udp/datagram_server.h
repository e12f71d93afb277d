// SPDX-License-Identifier: MIT
//
// The UDP socket for snapshots of clients that request datagrams (docs/design/datagrams.md). One
// thread receives packets in batches and passes each packet to the connection with its session id;
// packets without a known id are dropped without a response. Connections send by themselves.
//
// Threads: start() and stop() from one thread, all other functions from any. Outlives its
// connections.
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
    std::uint16_t port = 0;             // 0: any free port
    std::uint16_t advertised_port = 0;  // 0: the bound port
    Metrics* metrics = nullptr;         // null: no counting
};

class DatagramServer {
public:
    explicit DatagramServer(DatagramServerSettings settings) : settings_(std::move(settings)) {}
    ~DatagramServer();
    DatagramServer(const DatagramServer&) = delete;
    DatagramServer& operator=(const DatagramServer&) = delete;

    // An error names the address and the reason.
    Status start();
    // Stops receiving: no connection is called any more. Connections can still send.
    void stop();
    std::uint16_t port() const { return port_; }  // the bound port, after start()
    std::uint16_t advertised_port() const {
        return settings_.advertised_port != 0 ? settings_.advertised_port : port_;
    }

    // Opens a connection with new credentials. `on_message`: see DatagramConnection.
    Result<std::shared_ptr<DatagramConnection>> open(
        std::function<void(std::string_view)> on_message);
    // Drops packets for this connection from now on. A packet in progress may still be delivered.
    void close(const DatagramConnection& connection);
    std::size_t connections() const;

private:
    void run();
    void receive_packets();
    std::shared_ptr<DatagramConnection> find(std::uint64_t credentials) const;

    const DatagramServerSettings settings_;
    int socket_ = -1, wake_ = -1;
    std::uint16_t port_ = 0;
    mutable std::mutex mutex_;
    std::unordered_map<std::uint64_t, std::shared_ptr<DatagramConnection>>
        connections_;  // by session id
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace jostle::server
