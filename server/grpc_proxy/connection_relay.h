// SPDX-License-Identifier: MIT
//
// Relays bytes between the clients of the gRPC port and gRPC: between a client socket and one end
// of a local socket pair, whose other end gRPC owns. The server therefore controls TLS, the frames
// that a client may send and the amount of buffered data; gRPC only gets connections that have
// started HTTP/2.
//
// A client that sends frames no regular client sends is disconnected, and its address is penalized
// (http2_frame_guard.h). A client that is only fast, or ahead of the responses, is read more
// slowly, so that TCP flow control throttles it.
//
// Has its own thread. add() from any thread; start() and stop() once, from one thread.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "jostle/base/result.h"
#include "server/grpc_proxy/client_socket.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/metrics/metrics.h"
#include "server/util/token_bucket.h"

namespace jostle::server {

struct RelayLimits {
    double buffered_bytes_max = 8.0 * 1024 * 1024;  // of one connection, without a complete message
    double buffered_total_max = 64.0 * 1024 * 1024;  // of all; beyond it the largest is closed
    // Streams that a client has opened and gRPC has not reported yet.
    double backlog_max = 100, backlog_total_max = 2000;
    double openings_per_second = 500;  // connections to gRPC, also the burst
    // until the HTTP/2 preface has arrived
    Clock::duration preface_timeout = std::chrono::seconds(5);
    // after gRPC ends a connection, until it is closed
    Clock::duration close_timeout = std::chrono::seconds(2);
};

class ConnectionRelay {
public:
    // Takes ownership of the descriptor. Called on the relay's thread.
    using Handler = std::function<void(int descriptor)>;

    // Table and metrics outlive the relay; null metrics: no counting.
    ConnectionRelay(ConnectionTable& table, RelayLimits limits,
                    const ListenerMetrics* metrics = nullptr);
    ~ConnectionRelay();

    Status start(Handler handler);
    void add(std::unique_ptr<ClientSocket> client, std::shared_ptr<Connection> connection);
    // Sends gRPC's remaining output to the clients for at most `timeout`, then closes all
    // connections.
    void stop(Clock::duration timeout);

    // Any thread.
    std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }
    bool is_responsive(Clock::time_point now) const;  // its thread has polled within 1 s

private:
    struct Stream;
    struct End;

    void run();
    void add_new(Clock::time_point now);
    template <class Work>
    void guarded(Stream& stream, const Work& work);
    void on_event(End& end, std::uint32_t events, Clock::time_point now);
    void on_client_event(Stream& stream, std::uint32_t events, Clock::time_point now);
    void read_client(Stream& stream, Clock::time_point now);
    void to_grpc(Stream& stream, std::span<const std::uint8_t> bytes);
    std::size_t send_to_grpc(Stream& stream, std::span<const std::uint8_t> bytes);
    void open_waiting(Clock::time_point now);
    void open_grpc(Stream& stream);
    void flush_to_grpc(Stream& stream);
    static bool can_read_grpc(const Stream& stream);
    void read_grpc(Stream& stream, Clock::time_point now);
    bool write_client(Stream& stream, std::span<const std::uint8_t> bytes);
    void on_grpc_ended(Stream& stream, Clock::time_point now);
    bool may_read(const Stream& stream, Clock::time_point now) const;
    void update_interest(Stream& stream, Clock::time_point now);
    void sweep(Clock::time_point now);
    void measure(Stream& stream, Clock::time_point now) const;
    void drop_largest_buffer(Stream& stream, Clock::time_point now);
    void drop(Stream& stream, const std::string& why, Clock::time_point now);
    void close(Stream& stream);
    void delete_closed();

    ConnectionTable& table_;
    const RelayLimits limits_;
    const ListenerMetrics* const metrics_;
    Handler handler_;
    int epoll_ = -1, wake_ = -1;
    std::mutex mutex_;  // guards new_
    std::vector<std::unique_ptr<Stream>> new_;
    std::map<Stream*, std::unique_ptr<Stream>> streams_;
    std::vector<Stream*> dead_;
    std::deque<Stream*> waiting_;          // for a connection to gRPC; some may be closed
    std::vector<std::uint8_t> up_, down_;  // scratch buffers of one transfer
    TokenBucket openings_;
    double buffered_total_ = 0, backlog_total_ = 0;
    bool is_idle_ = false;  // at the last sweep no connection waited for a time; no event since
    std::atomic<std::uint64_t> dropped_{0};
    std::atomic<Clock::rep> polled_at_{0};
    std::atomic<Clock::rep> stop_at_{0};  // 0: not stopping
    std::thread thread_;
};

}  // namespace jostle::server
