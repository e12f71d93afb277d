// SPDX-License-Identifier: MIT
//
// One passive client: a socket, its framing and its protocol. Used by its PassiveClientThread only,
// which reports epoll events and calls tick() every few milliseconds.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <string>

#include "tools/common/socket_address.h"
#include "tools/load/framing.h"
#include "tools/load/load_options.h"
#include "tools/load/passive_client_protocol.h"

namespace jostle::load {

class PassiveClient final : private Framing::Reader {
public:
    // `epoll`: descriptor for the socket's events. Plan and metrics must outlive this object.
    PassiveClient(const LoadOptions& plan, PassiveClientOptions options, int epoll,
                  LoadMetrics& metrics);
    ~PassiveClient();
    PassiveClient(const PassiveClient&) = delete;
    PassiveClient& operator=(const PassiveClient&) = delete;

    void connect(const common::SocketAddress& address);
    // Handles an epoll event; `scratch` is a reusable read buffer.
    void on_event(std::span<std::uint8_t> scratch, Clock::time_point now);
    // Reads at the read rate and sends due messages.
    void tick(Clock::time_point now);

    bool began() const { return socket_ >= 0 || closed_; }
    bool joined() const { return protocol_.joined() && !closed_; }
    PassiveClientProtocol& protocol() { return protocol_; }

private:
    void on_message(Bytes message) override;
    std::string why_closed() const;
    void receive(std::span<std::uint8_t> scratch);
    void read_waiting(Clock::time_point now);
    void send_due(Clock::time_point now);
    void flush();
    void update_epoll();
    void end(const std::string& reason);
    bool is_backpressured() const;

    const LoadOptions& plan_;
    const int epoll_;
    LoadMetrics& metrics_;
    PassiveClientProtocol protocol_;
    std::unique_ptr<Framing> framing_;
    int socket_ = -1;
    std::uint32_t epoll_events_ = 0;
    bool closed_ = false;
    Clock::time_point now_{};  // time of the current event
    // With a read rate: received messages, and the time of the next read.
    std::deque<std::string> waiting_;
    Clock::time_point next_read_{};
};

}  // namespace jostle::load
