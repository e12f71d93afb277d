// SPDX-License-Identifier: MIT
//
// One sink: a socket, its framing and its conversation. Lives on the thread of its
// PassiveClientThread, which tells it what epoll says and calls on it every few milliseconds.
#pragma once

#include <sys/socket.h>

#include <deque>
#include <memory>
#include <span>
#include <string>

#include "tools/load/framing.h"
#include "tools/load/load_options.h"
#include "tools/load/passive_client_protocol.h"

namespace jostle::load {

struct ServerAddress {
    sockaddr_storage bytes{};
    socklen_t size = 0;
};
Result<ServerAddress> resolve(const std::string& target);

class PassiveClient final : private Framing::Reader {
public:
    // `epoll`: where it registers its socket. Plan and figures outlive it.
    PassiveClient(const LoadOptions& plan, PassiveClientOptions options, int epoll,
                  LoadMetrics& metrics);
    ~PassiveClient();
    PassiveClient(const PassiveClient&) = delete;
    PassiveClient& operator=(const PassiveClient&) = delete;

    void connect(const ServerAddress& address);
    // Something arrived, or may be sent; `scratch` is free to be read into.
    void on_event(std::span<std::uint8_t> scratch, Clock::time_point now);
    // Reads what may be read by now, and says what is due.
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
    void end(const std::string& why);
    bool is_backpressured() const;

    const LoadOptions& plan_;
    const int epoll_;
    LoadMetrics& metrics_;
    PassiveClientProtocol protocol_;
    std::unique_ptr<Framing> framing_;
    int socket_ = -1;
    std::uint32_t epoll_events_ = 0;
    bool closed_ = false;
    Clock::time_point now_{};  // of the event that is handled
    // Of one that reads at a rate of its own: what has arrived, and when it reads the next.
    std::deque<std::string> waiting_;
    Clock::time_point next_read_{};
};

}  // namespace jostle::load
