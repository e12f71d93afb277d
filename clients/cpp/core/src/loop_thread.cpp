// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/loop_thread.h"

#include <algorithm>

#include "jostle/client/loop.h"
#include "jostle/grpc_status/grpc_status.h"

namespace jostle::client {
namespace {

// Sufficient for inputs, pings and reconnects; messages are handled as they arrive.
constexpr auto housekeeping_period_max = std::chrono::milliseconds(5);
// Messages of a simulated network arrive on time, independent of other events.
constexpr auto simulated_network_period = std::chrono::milliseconds(1);
constexpr auto reconnect_delay_max = std::chrono::seconds(5);
constexpr auto leave_timeout = std::chrono::milliseconds(100);

// The error of a stream that ended without a request of this client.
Error stream_error(const Status& end) {
    if (end.ok()) return {ErrorCode::aborted, "stream closed by the server"};
    return {end.error().code, "stream failed: " + end.error().message};
}

}  // namespace

LoopThread::LoopThread() : thread_([this] { run(); }) {}

LoopThread::~LoopThread() {
    stopping_ = true;
    thread_.join();
}

void LoopThread::add(std::shared_ptr<ClientState> client) {
    const std::lock_guard lock(mutex_);
    new_clients_.push_back(std::move(client));
}

void LoopThread::take_new_clients() {
    const std::lock_guard lock(mutex_);
    clients_.insert(clients_.end(), new_clients_.begin(), new_clients_.end());
    new_clients_.clear();
}

void LoopThread::run() {
    Clock::time_point housekeeping = Clock::now();
    while (!stopping_) {
        void* tag = nullptr;
        bool ok = false;
        const auto wait = std::max(Clock::duration::zero(), housekeeping - Clock::now());
        const auto next = queue_.AsyncNext(&tag, &ok, std::chrono::system_clock::now() + wait);
        const Clock::time_point now = Clock::now();
        if (next == grpc::CompletionQueue::GOT_EVENT && tag == poller_.get())
            read_ready(now);
        else if (next == grpc::CompletionQueue::GOT_EVENT)
            handle(*static_cast<Connection::Tag*>(tag), ok, now);
        if (now < housekeeping) continue;
        take_new_clients();
        for (const auto& client : clients_) advance(*client, now);
        std::erase_if(clients_, [](const auto& client) { return client->finished; });
        housekeeping = now + housekeeping_period();
    }
    drain();
}

Clock::duration LoopThread::housekeeping_period() const {
    for (const auto& client : clients_)
        if (client->incoming) return simulated_network_period;
    return housekeeping_period_max;
}

void LoopThread::handle(const Connection::Tag& tag, bool ok, Clock::time_point now) {
    // A client stays on the list until its connection has no pending operation.
    ClientState& client = *static_cast<ClientState*>(tag.owner);
    const std::string* received = client.connection->handle(tag.event, ok);
    if (received && client.incoming) {
        client.incoming->push(*received, now);
    } else if (received) {
        const std::lock_guard lock(client.mutex);
        client.protocol.receive(*received, now);
    }
    advance(client, now);
}

// Handles messages that arrived over a simulated network.
void LoopThread::receive(ClientState& client, Clock::time_point now) {
    if (!client.incoming) return;
    const std::lock_guard lock(client.mutex);
    while (const auto message = client.incoming->take(now)) client.protocol.receive(*message, now);
}

// Handles datagrams of sockets with new data.
void LoopThread::read_ready(Clock::time_point now) {
    for (const std::uint64_t name : poller_->take_ready()) {
        const auto at = clients_by_socket_.find(name);
        if (at == clients_by_socket_.end()) continue;
        read_datagrams(*at->second, now);
        send_datagrams(*at->second, now);
    }
}

void LoopThread::read_datagrams(ClientState& client, Clock::time_point now) {
    while (const auto message = client.datagrams->receive(now)) {
        const std::lock_guard lock(client.mutex);
        client.protocol.receive_datagram(*message, now);
    }
}

// Opens the socket once the server has sent the credentials.
void LoopThread::open_datagrams(ClientState& client, Clock::time_point now) {
    const std::lock_guard lock(client.mutex);
    const auto& ticket = client.protocol.datagram_ticket();
    if (!ticket) return;
    auto opened = DatagramSocket::open(*ticket, client.connection->peer(), now);
    if (!opened.ok()) return client.protocol.datagrams_failed(opened.error());
    client.datagrams = *std::move(opened);
    client.socket_id = ++next_socket_id_;
    if (!poller_) poller_ = std::make_unique<SocketPoller>(queue_);
    clients_by_socket_[client.socket_id] = &client;
    poller_->add(client.datagrams->descriptor(), client.socket_id);
}

// Sends due datagrams and reports their state to the protocol.
void LoopThread::send_datagrams(ClientState& client, Clock::time_point now) {
    if (!client.datagrams) open_datagrams(client, now);
    if (!client.datagrams) return;
    std::optional<std::string> message;
    {
        const std::lock_guard lock(client.mutex);
        client.protocol.set_datagrams(client.datagrams->alive(now),
                                      client.datagrams->timed_out(now));
        message = client.protocol.take_datagram(now);
    }
    if (message) client.datagrams->send(*message);
}

void LoopThread::write(ClientState& client, Clock::time_point now) {
    while (client.connection->ready_to_write()) {
        std::optional<std::string> message;
        bool ready_to_close = false;
        {
            const std::lock_guard lock(client.mutex);
            message = client.protocol.take_message(now);
            ready_to_close = client.protocol.leave_sent();
        }
        if (client.outgoing) {
            if (message) client.outgoing->push(*std::move(message), now);
            message = client.outgoing->take(now);
            ready_to_close = ready_to_close && client.outgoing->empty();
        }
        if (message)
            client.connection->write(*message);
        else if (ready_to_close)
            client.connection->close_writes();
        else
            break;
    }
}

// Starts what is due: a connection, the next write, the next attempt.
void LoopThread::advance(ClientState& client, Clock::time_point now) {
    if (client.finished) return;
    if (!client.connection) {
        if (now < client.connect_at) return;
        const std::lock_guard lock(client.mutex);
        if (client.destroyed || client.protocol.leaving()) {
            client.finished = true;
            return;
        }
        client.protocol.begin(now);
        const ClientOptions& options = client.protocol.options();
        if (options.network_conditions.impaired()) {
            client.incoming.emplace(options.network_conditions, 0);
            client.outgoing.emplace(options.network_conditions, 1);
        }
        client.connection = std::make_unique<Connection>(options, queue_, &client);
        return;
    }
    if (client.destroyed) disconnect(client, now);
    if (client.connection->finished()) {
        if (client.connection->idle()) on_stream_end(client, now);
        return;
    }
    receive(client, now);
    send_datagrams(client, now);
    write(client, now);
}

// Sends a Leave if that is possible immediately, so that the server does not retain the session.
void LoopThread::disconnect(ClientState& client, Clock::time_point now) {
    if (!client.disconnect_deadline) {
        const std::lock_guard lock(client.mutex);
        client.protocol.abandon();
        client.disconnect_deadline = client.protocol.stats().connected ? now + leave_timeout : now;
    }
    if (now >= *client.disconnect_deadline) client.connection->cancel();
}

void LoopThread::on_stream_end(ClientState& client, Clock::time_point now) {
    const Status end = from_grpc(client.connection->status());
    client.connection.reset();
    clients_by_socket_.erase(client.socket_id);
    client.datagrams.reset();
    const std::lock_guard lock(client.mutex);
    const bool requested = client.destroyed || client.protocol.leaving();
    if (client.protocol.stats().connected) client.reconnect_delay = std::chrono::milliseconds(250);
    client.protocol.ended(requested ? Status() : stream_error(end));
    if (requested || !client.protocol.options().reconnect) {
        client.finished = true;
        return;
    }
    client.connect_at = now + client.reconnect_delay;
    client.reconnect_delay =
        std::min<Clock::duration>(client.reconnect_delay * 2, reconnect_delay_max);
}

// Cancels all connections and removes the last events from the queue.
void LoopThread::drain() {
    for (const auto& client : clients_)
        if (client->connection) client->connection->cancel();
    poller_.reset();
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    // No new operation may start, so the events are discarded.
    while (queue_.Next(&tag, &ok)) {
    }
    for (const auto& client : clients_) client->connection.reset();
}

Loop::Loop() : thread_(std::make_unique<LoopThread>()) {}
Loop::~Loop() = default;

}  // namespace jostle::client
