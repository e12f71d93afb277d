// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/connection_relay.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <exception>
#include <string_view>
#include <utility>

#include "jostle/base/check.h"
#include "server/grpc_proxy/http2_frame_guard.h"
#include "server/util/log.h"
#include "server/util/wrong_protocol.h"

namespace jostle::server {

namespace {

constexpr std::string_view wrong_port =
    "this is the gRPC port, which requires HTTP/2; the viewer and the HTTP API have another port "
    "(setting http)";
// A trusted proxy sends the frames of as many clients as gRPC allows streams per connection.
constexpr double clients_of_proxy = 100;
constexpr auto sweep_period = std::chrono::milliseconds(20);
// While no connection waits for a time; is_responsive() expects a poll each second.
constexpr auto idle_sweep_period = std::chrono::milliseconds(250);
// A tick makes gRPC write to all its clients within one or two milliseconds. Waking up for each
// write would take 25 % more of the server's time; this delay batches many writes.
constexpr auto batching_delay = std::chrono::microseconds(250);
constexpr int events_max = 256;
// One TLS record; also the bytes moved per client before the next client gets its turn.
constexpr std::size_t up_bytes = 16 * 1024, down_bytes = 64 * 1024;
// Sustained bytes that a connection may send in addition to its messages: headers, window updates,
// pings and the frames around acks take a few kB/s per call.
constexpr double slack_bytes_per_second = 16 * 1024, slack_of_call = 4 * 1024;
// Streams that gRPC rejects itself are never reported to the server.
constexpr double streams_tolerated_per_second = 50;
// While the total limits are reached, connections below these values are still read.
constexpr double small_buffer = 64 * 1024, small_backlog = 8;

void close_if_open(int& descriptor) {
    if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

// Binds to an abstract socket address, so that gRPC's peer name identifies the connection.
bool name_socket(int descriptor, const std::string& name) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (name.size() + 1 > sizeof address.sun_path) return false;
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    return bind(descriptor, reinterpret_cast<const sockaddr*>(&address), size) == 0;
}

}  // namespace

// User data of an epoll registration.
struct ConnectionRelay::End {
    Stream* stream = nullptr;
    std::uint32_t interest = 0;
    bool is_client = false, is_registered = false;
};

struct ConnectionRelay::Stream {
    Stream(std::unique_ptr<ClientSocket> socket, std::shared_ptr<Connection> shared_connection,
           Clock::time_point now)
        : client(std::move(socket)),
          connection(std::move(shared_connection)),
          guard(now, connection->is_proxy ? clients_of_proxy : 1),
          measured(now) {}

    std::unique_ptr<ClientSocket> client;
    std::shared_ptr<Connection> connection;
    Http2FrameGuard guard;
    int grpc = -1;  // our end of the socket pair; -1: not open yet
    End client_end{this, 0, true, false}, grpc_end{this, 0, false, false};
    // Bytes sent by one side that the other side has not accepted yet.
    std::vector<std::uint8_t> for_grpc, for_client;
    Clock::time_point read_again{};            // the client is not read before this time
    Clock::time_point deadline{};              // of the current phase; zero: none
    double unread = 0, backlog = 0;            // bytes; streams
    std::uint64_t received = 0, opened = 0;    // at the last read
    std::uint64_t consumed = 0, accepted = 0;  // at the last measurement
    Clock::time_point measured;
    bool is_queued = false;       // for its connection to gRPC
    bool client_ended = false;    // end of input
    bool grpc_ended = false;      // end of input
    bool discards_input = false;  // gRPC reads no more: input is discarded
    bool grpc_hung_up = false;    // has closed its end; the pair may hold unread bytes
    bool read_wants_write = false, write_wants_read = false;  // TLS
    bool is_dead = false;
};

ConnectionRelay::ConnectionRelay(ConnectionTable& table, RelayLimits limits,
                                 const ListenerMetrics* metrics)
    : table_(table),
      limits_(limits),
      metrics_(metrics),
      up_(up_bytes),
      down_(down_bytes),
      openings_(limits.openings_per_second, Clock::now()) {}

ConnectionRelay::~ConnectionRelay() {
    stop({});
    close_if_open(epoll_);
    close_if_open(wake_);
}

Status ConnectionRelay::start(Handler handler) {
    ASSERT(handler && !thread_.joinable());
    handler_ = std::move(handler);
    epoll_ = epoll_create1(EPOLL_CLOEXEC);
    wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    epoll_event event{.events = EPOLLIN, .data = {.ptr = nullptr}};
    if (epoll_ < 0 || wake_ < 0 || epoll_ctl(epoll_, EPOLL_CTL_ADD, wake_, &event) != 0)
        return Error{ErrorCode::unavailable,
                     fmt::format("cannot poll connections: {}", std::strerror(errno))};
    polled_at_ = Clock::now().time_since_epoch().count();
    thread_ = std::thread([this] { run(); });
    return {};
}

void ConnectionRelay::add(std::unique_ptr<ClientSocket> client,
                          std::shared_ptr<Connection> connection) {
    ASSERT(client && connection);
    auto stream = std::make_unique<Stream>(std::move(client), std::move(connection), Clock::now());
    {
        const std::lock_guard lock(mutex_);
        new_.push_back(std::move(stream));
    }
    eventfd_write(wake_, 1);
}

void ConnectionRelay::stop(Clock::duration timeout) {
    if (!thread_.joinable()) return;
    stop_at_ = (Clock::now() + timeout).time_since_epoch().count();
    eventfd_write(wake_, 1);
    thread_.join();
}

bool ConnectionRelay::is_responsive(Clock::time_point now) const {
    return now - Clock::time_point(Clock::duration(polled_at_)) < std::chrono::seconds(1);
}

void ConnectionRelay::run() {
    ClientSocket::block_broken_pipe_signal();
    std::array<epoll_event, events_max> events;
    Clock::time_point swept{};
    for (;;) {
        const bool is_idle = is_idle_ && waiting_.empty() && stop_at_ == 0;
        const auto period = is_idle ? idle_sweep_period : sweep_period;
        const int count =
            epoll_wait(epoll_, events.data(), events_max, static_cast<int>(period.count()));
        const Clock::time_point now = Clock::now();
        polled_at_ = now.time_since_epoch().count();
        for (int i = 0; i < count; i++) {
            const epoll_event& event = events[static_cast<std::size_t>(i)];
            if (!event.data.ptr) {
                add_new(now);
                continue;
            }
            End& end = *static_cast<End*>(event.data.ptr);
            guarded(*end.stream, [&] { on_event(end, event.events, now); });
        }
        delete_closed();
        open_waiting(now);
        if (now - swept >= sweep_period) {
            sweep(now);
            delete_closed();
            swept = now;
        }
        if (count > 0) {
            is_idle_ = false;
            std::this_thread::sleep_for(batching_delay);
        }
        const Clock::rep stop_at = stop_at_;
        if (stop_at != 0 && (streams_.empty() || now.time_since_epoch().count() >= stop_at)) break;
    }
    add_new(Clock::now());
    for (const auto& [stream, owned] : streams_) close(*stream);
    delete_closed();
}

void ConnectionRelay::add_new(Clock::time_point now) {
    eventfd_t ignored = 0;
    eventfd_read(wake_, &ignored);
    std::vector<std::unique_ptr<Stream>> accepted;
    {
        const std::lock_guard lock(mutex_);
        accepted.swap(new_);
    }
    for (auto& owned : accepted) {
        Stream& stream = *owned;
        streams_.emplace(&stream, std::move(owned));
        ASSERT(!stream.is_dead && stream.grpc < 0);
        stream.deadline = now + limits_.preface_timeout;
        guarded(stream, [&] {
            // The client may have sent data already, and TLS may have buffered it.
            read_client(stream, now);
            if (!stream.is_dead) update_interest(stream, now);
        });
    }
}

// If memory runs out, only this connection ends.
template <class Work>
void ConnectionRelay::guarded(Stream& stream, const Work& work) {
    try {
        work();
    } catch (const std::exception& error) {
        log_error("{}: connection closed: {}", stream.connection->peer, error.what());
        close(stream);
    }
}

void ConnectionRelay::on_event(End& end, std::uint32_t events, Clock::time_point now) {
    Stream& stream = *end.stream;
    ASSERT(end.is_registered);
    if (stream.is_dead) return;
    if (end.is_client) {
        on_client_event(stream, events, now);
    } else {
        if ((events & EPOLLOUT) != 0) flush_to_grpc(stream);
        if ((events & (EPOLLHUP | EPOLLERR)) != 0) {
            // epoll would report the hang-up repeatedly.
            epoll_ctl(epoll_, EPOLL_CTL_DEL, stream.grpc, nullptr);
            stream.grpc_hung_up = true;
            stream.deadline = now + limits_.close_timeout;
        }
        read_grpc(stream, now);
    }
    while (stream.grpc_hung_up && can_read_grpc(stream)) read_grpc(stream, now);
    if (!stream.is_dead) update_interest(stream, now);
}

void ConnectionRelay::on_client_event(Stream& stream, std::uint32_t events, Clock::time_point now) {
    const bool hung_up = (events & EPOLLHUP) != 0;
    if ((events & EPOLLERR) != 0) return close(stream);
    if (stream.is_queued && (events & EPOLLRDHUP) != 0) return close(stream);
    if (stream.grpc_ended && hung_up) return close(stream);  // both directions have ended
    if (!stream.for_client.empty() && ((events & EPOLLOUT) != 0 || stream.write_wants_read)) {
        stream.write_wants_read = false;
        const std::vector<std::uint8_t> waiting = std::exchange(stream.for_client, {});
        if (!write_client(stream, waiting)) return;
    }
    if ((events & EPOLLIN) != 0 || stream.read_wants_write) read_client(stream, now);
    // Nothing can be read now, and epoll would report the hang-up repeatedly.
    if (!stream.is_dead && hung_up && !may_read(stream, now)) close(stream);
}

void ConnectionRelay::read_client(Stream& stream, Clock::time_point now) {
    if (stream.client_ended || !may_read(stream, now)) return;
    stream.read_wants_write = false;
    const auto [state, count] = stream.client->read(up_);
    const std::uint64_t received = stream.client->received();
    ASSERT(received >= stream.received);
    const double fresh = static_cast<double>(received - std::exchange(stream.received, received));
    stream.unread += fresh;
    buffered_total_ += fresh;
    if (state == ClientSocket::State::wants_write) stream.read_wants_write = true;
    if (state == ClientSocket::State::closed) {
        stream.client_ended = true;
        if (stream.grpc < 0 || stream.grpc_ended) return close(stream);
        if (stream.for_grpc.empty()) ::shutdown(stream.grpc, SHUT_WR);
        return;
    }
    if (count == 0 || stream.discards_input) return;
    if (stream.unread > limits_.buffered_bytes_max) measure(stream, now);
    if (stream.unread > limits_.buffered_bytes_max) return drop_largest_buffer(stream, now);
    ASSERT(count <= up_.size());
    const std::span<const std::uint8_t> bytes(up_.data(), count);
    if (const Status allowed = stream.guard.take(bytes, now); !allowed.ok()) {
        if (stream.guard.has_preface()) return drop(stream, allowed.error().message, now);
        // A browser, or TLS on a plain port: a mistake rather than an attack.
        log_debug("{}: {}", stream.connection->peer, allowed.error().message);
        if (!stream.client->has_tls())
            stream.client->reply_unencrypted(wrong_protocol_reply(protocol_of(bytes), wrong_port));
        return close(stream);
    }
    const std::uint64_t opened = stream.guard.streams_opened();
    ASSERT(opened >= stream.opened);
    const double streams = static_cast<double>(opened - std::exchange(stream.opened, opened));
    stream.backlog += streams;
    backlog_total_ += streams;
    stream.read_again = now + stream.guard.throttle_delay(now);
    to_grpc(stream, bytes);
}

void ConnectionRelay::to_grpc(Stream& stream, std::span<const std::uint8_t> bytes) {
    if (stream.grpc >= 0) bytes = bytes.subspan(send_to_grpc(stream, bytes));
    if (stream.discards_input) return;
    stream.for_grpc.insert(stream.for_grpc.end(), bytes.begin(), bytes.end());
    if (stream.grpc >= 0 || !stream.guard.has_preface()) return;
    ASSERT(!stream.is_queued);
    stream.is_queued = true;
    waiting_.push_back(&stream);
}

// A connection costs gRPC far more than the client. Connections closed before their turn cost it
// nothing.
void ConnectionRelay::open_waiting(Clock::time_point now) {
    while (!waiting_.empty()) {
        Stream* const stream = waiting_.front();
        const bool is_there = streams_.contains(stream) && stream->is_queued && !stream->is_dead;
        if (is_there && !openings_.take(1, now)) return;
        waiting_.pop_front();
        if (!is_there) continue;
        ASSERT(stream->grpc < 0);
        stream->is_queued = false;
        guarded(*stream, [&] {
            open_grpc(*stream);
            if (stream->grpc >= 0) flush_to_grpc(*stream);
            if (!stream->is_dead) update_interest(*stream, now);
        });
    }
}

// Returns the number of bytes that gRPC accepted.
std::size_t ConnectionRelay::send_to_grpc(Stream& stream, std::span<const std::uint8_t> bytes) {
    const ssize_t sent = ::send(stream.grpc, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) return static_cast<std::size_t>(sent);
    // If gRPC has closed this connection, its earlier output must still be read.
    if (errno != EAGAIN && errno != EINTR) stream.discards_input = true;
    return 0;
}

void ConnectionRelay::open_grpc(Stream& stream) {
    int pair[2] = {-1, -1};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, pair) != 0 ||
        !name_socket(pair[0], stream.connection->name)) {
        log_warn("{}: connection closed: {}", stream.connection->peer, std::strerror(errno));
        close_if_open(pair[0]);
        close_if_open(pair[1]);
        return close(stream);
    }
    ASSERT(stream.grpc < 0 && pair[0] >= 0);
    stream.grpc = pair[0];
    stream.deadline = {};
    handler_(pair[1]);
}

void ConnectionRelay::flush_to_grpc(Stream& stream) {
    std::vector<std::uint8_t>& waiting = stream.for_grpc;
    const std::size_t sent = send_to_grpc(stream, waiting);
    ASSERT(sent <= waiting.size());
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(sent));
    if (stream.discards_input) waiting.clear();
    if (!waiting.empty()) return;
    waiting.shrink_to_fit();
    if (stream.client_ended) ::shutdown(stream.grpc, SHUT_WR);
}

bool ConnectionRelay::can_read_grpc(const Stream& stream) {
    return !stream.is_dead && stream.grpc >= 0 && !stream.grpc_ended && stream.for_client.empty();
}

void ConnectionRelay::read_grpc(Stream& stream, Clock::time_point now) {
    if (!can_read_grpc(stream)) return;
    const ssize_t count = ::recv(stream.grpc, down_.data(), down_.size(), 0);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) return on_grpc_ended(stream, now);
    write_client(stream, {down_.data(), static_cast<std::size_t>(count)});
}

// Returns false if the client is disconnected; the stream is then closed.
bool ConnectionRelay::write_client(Stream& stream, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const auto [state, count] = stream.client->write(bytes);
        if (state == ClientSocket::State::closed) {
            close(stream);
            return false;
        }
        if (state != ClientSocket::State::open) {
            stream.write_wants_read = state == ClientSocket::State::wants_read;
            break;
        }
        ASSERT(count <= bytes.size());
        bytes = bytes.subspan(count);
    }
    stream.for_client.assign(bytes.begin(), bytes.end());
    if (bytes.empty()) {
        stream.for_client.shrink_to_fit();
        if (stream.grpc_ended) stream.client->finish();
    }
    return true;
}

// Data in flight still reaches the client: closing a socket while its peer is sending would discard
// data sent earlier (TCP reset).
void ConnectionRelay::on_grpc_ended(Stream& stream, Clock::time_point now) {
    stream.grpc_ended = stream.discards_input = true;
    stream.for_grpc.clear();
    if (stream.client_ended) return close(stream);
    stream.deadline = now + limits_.close_timeout;
    if (stream.for_client.empty()) stream.client->finish();
}

bool ConnectionRelay::may_read(const Stream& stream, Clock::time_point now) const {
    if (stream.discards_input) return true;
    if (stream.is_queued || (!stream.for_grpc.empty() && stream.grpc >= 0)) return false;
    if (now < stream.read_again || stream.backlog > limits_.backlog_max) return false;
    if (backlog_total_ > limits_.backlog_total_max && stream.backlog > small_backlog) return false;
    return buffered_total_ <= limits_.buffered_total_max || stream.unread <= small_buffer;
}

void ConnectionRelay::update_interest(Stream& stream, Clock::time_point now) {
    const auto set_interest = [&](End& end, int descriptor, std::uint32_t interest) {
        if (end.is_registered && interest == end.interest) return;
        epoll_event event{.events = interest, .data = {.ptr = &end}};
        const int what = end.is_registered ? EPOLL_CTL_MOD : EPOLL_CTL_ADD;
        if (epoll_ctl(epoll_, what, descriptor, &event) != 0) return close(stream);
        end.interest = interest;
        end.is_registered = true;
    };
    const bool reads = !stream.client_ended && may_read(stream, now);
    const bool writes = !stream.for_client.empty() && !stream.write_wants_read;
    set_interest(stream.client_end, stream.client->descriptor(),
                 (reads || stream.write_wants_read ? EPOLLIN : 0u) |
                     (stream.is_queued ? EPOLLRDHUP : 0u) |
                     (writes || stream.read_wants_write ? EPOLLOUT : 0u));
    if (stream.is_dead || stream.grpc < 0) return;
    if (stream.grpc_ended) return close_if_open(stream.grpc);
    if (!stream.grpc_hung_up)
        set_interest(
            stream.grpc_end, stream.grpc,
            (stream.for_client.empty() ? EPOLLIN : 0u) | (stream.for_grpc.empty() ? 0u : EPOLLOUT));
}

void ConnectionRelay::measure(Stream& stream, Clock::time_point now) const {
    const double seconds = std::chrono::duration<double>(now - stream.measured).count();
    stream.measured = now;
    const std::uint64_t consumed = stream.connection->consumed.load(std::memory_order_relaxed);
    const std::uint64_t accepted =
        stream.connection->calls_accepted.load(std::memory_order_relaxed);
    const auto calls =
        static_cast<double>(stream.connection->calls.load(std::memory_order_relaxed));
    ASSERT(consumed >= stream.consumed);
    stream.unread -= static_cast<double>(consumed - std::exchange(stream.consumed, consumed)) +
                     seconds * (slack_bytes_per_second + slack_of_call * calls);
    stream.unread = std::max(0.0, stream.unread);
    ASSERT(accepted >= stream.accepted);
    stream.backlog -= static_cast<double>(accepted - std::exchange(stream.accepted, accepted)) +
                      seconds * streams_tolerated_per_second;
    stream.backlog = std::max(0.0, stream.backlog);
}

void ConnectionRelay::sweep(Clock::time_point now) {
    buffered_total_ = backlog_total_ = 0;
    Stream* largest = nullptr;
    for (const auto& [stream, owned] : streams_) {
        measure(*stream, now);
        if (stream->unread > limits_.buffered_bytes_max)
            drop_largest_buffer(*stream, now);
        else if (stream->deadline != Clock::time_point{} && now >= stream->deadline)
            close(*stream);
        if (stream->is_dead) continue;
        buffered_total_ += stream->unread;
        backlog_total_ += stream->backlog;
        if (!largest || stream->unread > largest->unread) largest = stream;
    }
    ASSERT(buffered_total_ >= 0 && backlog_total_ >= 0);
    if (buffered_total_ > limits_.buffered_total_max && largest) {
        buffered_total_ -= largest->unread;
        drop(*largest,
             fmt::format("{:.0f} bytes of incomplete messages, the most of all connections at the "
                         "total limit",
                         largest->unread),
             now);
    }
    is_idle_ = true;
    for (const auto& [stream, owned] : streams_) {
        if (stream->is_dead) continue;
        update_interest(*stream, now);
        is_idle_ &= stream->deadline == Clock::time_point{} &&
                    (stream->client_ended || may_read(*stream, now));
    }
}

void ConnectionRelay::drop_largest_buffer(Stream& stream, Clock::time_point now) {
    drop(stream, fmt::format("{:.0f} bytes of incomplete messages", stream.unread), now);
}

void ConnectionRelay::drop(Stream& stream, const std::string& why, Clock::time_point now) {
    log_warn("{}: connection closed as an attack: {}", stream.connection->peer, why);
    table_.penalize(*stream.connection, now);
    dropped_++;
    if (metrics_) metrics_->refused(ConnectionRefusal::attack).Increment();
    close(stream);
}

void ConnectionRelay::close(Stream& stream) {
    if (std::exchange(stream.is_dead, true)) return;
    dead_.push_back(&stream);
}

// Deferred to the end of an event round, because an event may refer to a stream that an earlier
// event closed.
void ConnectionRelay::delete_closed() {
    for (Stream* stream : dead_) {
        ASSERT(stream->is_dead && streams_.contains(stream));
        table_.remove(*stream->connection);
        close_if_open(stream->grpc);
        streams_.erase(stream);
    }
    dead_.clear();
}

}  // namespace jostle::server
