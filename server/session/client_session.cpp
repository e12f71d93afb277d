// SPDX-License-Identifier: MIT
#include "server/session/client_session.h"

#include <spdlog/fmt/fmt.h>

#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "server/messages/server_message.h"
#include "server/session/joined_world.h"
#include "server/session/session_end.h"
#include "server/util/log.h"

namespace jostle::server {

ClientSession::ClientSession(PlayContext& context, Peer peer, Clock::time_point now)
    : context_(context),
      peer_(std::move(peer)),
      timeouts_(context.config.stream, now, context.config.limits.idle_kick_seconds) {}

// --- messages of the client ---

void ClientSession::receive(std::string_view bytes, Clock::time_point now) {
    if (network_simulator_)
        network_simulator_->push_incoming(bytes, now);
    else
        handle_bytes(bytes, now);
}

void ClientSession::handle_delayed_bytes(Clock::time_point now, bool at_once) {
    if (!network_simulator_) return;
    while (const auto bytes = network_simulator_->take_incoming(now, at_once))
        handle_bytes(*bytes, now);
}

void ClientSession::handle_bytes(std::string_view bytes, Clock::time_point now) {
    if (end_) return;
    timeouts_.on_received(now);
    const auto bytes_max = static_cast<std::size_t>(context_.config.client.message_bytes_max);
    if (bytes.size() > bytes_max)
        return refuse({ErrorCode::resource_exhausted,
                       fmt::format("the message has {} bytes; at most {} are allowed", bytes.size(),
                                   bytes_max)},
                      now);
    // Checked before decoding, so that a flood costs its sender more than the server.
    if (joined_ && !joined_->inputs().admit_message(bytes.size(), now))
        return drop_excess_message(now);
    const Result<ClientMessage> message = decode_client_message(bytes);
    if (!message.ok()) return refuse(message.error(), now);
    if (!joined_ && !std::holds_alternative<Hello>(*message))
        return refuse({ErrorCode::failed_precondition, "the first message must be a Hello"}, now);
    std::visit([&](const auto& decoded) { on_message(decoded, now); }, *message);
}

void ClientSession::drop_excess_message(Clock::time_point now) {
    if (joined_->on_excess_message(now) == FloodGuard::Verdict::disconnect)
        refuse({ErrorCode::resource_exhausted,
                fmt::format("the client sent more than {} times its message rate",
                            FloodGuard::flood_factor)},
               now);
}

void ClientSession::on_message(const Hello& hello, Clock::time_point now) {
    if (joined_)
        return refuse({ErrorCode::failed_precondition,
                       "hello: the session has already begun; send one Hello per stream"},
                      now);
    const JoinedWorld::Parts parts{context_, metrics_, outbox_, resume_, peer_};
    Result<std::unique_ptr<JoinedWorld>> joined =
        enter_world(parts, hello, timeouts_.age(now), now);
    if (!joined.ok()) return refuse(joined.error(), now);
    joined_ = *std::move(joined);
    if (joined_) timeouts_.on_joined(now);
    if (joined_)
        network_simulator_ = make_network_simulator(context_.config.development,
                                                    joined_->host().name(), joined_->client());
}

void ClientSession::on_message(const InputBatch& batch, Clock::time_point now) {
    if (Status s = joined_->receive(batch, now); !s.ok()) refuse(s.error(), now);
}

void ClientSession::on_message(const Ack& ack, Clock::time_point now) {
    joined_->snapshots().on_ack(ack, now);
}

void ClientSession::on_message(const Ping& ping, Clock::time_point now) {
    outbox_.push_reply(encode_pong(ping.client_time_us, to_us(now)));
}

void ClientSession::on_message(const Leave&, Clock::time_point now) {
    finish({}, now);
}

void ClientSession::on_message(const Interest& interest, Clock::time_point now) {
    if (Status s = joined_->snapshots().set_interest(interest); !s.ok()) refuse(s.error(), now);
}

void ClientSession::take_datagrams(Clock::time_point now) {
    if (end_ || !joined_ || !joined_->datagrams()) return;
    for (const DatagramConnection::ReceivedMessage& received :
         joined_->datagrams()->take_messages()) {
        timeouts_.on_datagram(received.at);
        if (Status s = joined_->datagrams()->receive(received, now); !s.ok())
            return refuse(s.error(), now);
    }
    joined_->datagrams()->send(now);
}

// --- messages to the client ---

std::optional<OutMessage> ClientSession::take_message(Clock::time_point now) {
    handle_delayed_bytes(now);
    std::optional<OutMessage> message = next_message(now);
    if (network_simulator_) {
        for (; message; message = next_message(now))
            network_simulator_->push_outgoing(*std::move(message), now);
        message = network_simulator_->take_outgoing(now, end_.has_value());
    }
    if (message) metrics_.sent(*message, now);
    if (message) timeouts_.on_sent(message->size());
    return message;
}

std::optional<OutMessage> ClientSession::next_message(Clock::time_point now) {
    timeouts_.on_writable();
    check_end(now);
    if (std::optional<OutMessage> message = outbox_.pop()) {
        if (joined_) joined_->snapshots().on_other_sent();
        metrics_.sent_other(*message);
        return message;
    }
    if (!joined_ || end_) return std::nullopt;
    return joined_->snapshots().take_message(now);
}

void ClientSession::wait_for_write(Clock::time_point now) {
    timeouts_.on_write_blocked(now);
    if (joined_) joined_->snapshots().on_write_blocked();
    handle_delayed_bytes(now);
    check_end(now);
    if (end_) return;
    if (std::optional<Error> error = timeouts_.read_timeout(now))
        refuse(*std::move(error), now, true);
    else if (joined_)
        joined_->inputs().collect_results();
}

// --- the end ---

void ClientSession::on_peer_closed(Clock::time_point now) {
    handle_delayed_bytes(now, true);
    outbox_.clear();
    if (!end_) finish({}, now, true);
}

void ClientSession::on_fault(Clock::time_point now) {
    outbox_.clear();
    if (joined_) joined_->inputs().on_results_sent();
    finish(Error{ErrorCode::internal, "a server fault ended the session"}, now);
}

void ClientSession::refuse(Error error, Clock::time_point now, bool resumable) {
    if (end_) return;
    log_warn("refused {}: {}",
             joined_ ? fmt::format("client {} of {}", joined_->client(), peer_.name) : peer_.name,
             error.message);
    metrics_.refused(error.code);
    outbox_.push_reply(encode_notice(NoticeKind::refused, error.message));
    finish(std::move(error), now, resumable);
}

void ClientSession::finish(Status status, Clock::time_point now, bool resumable) {
    if (end_) return;
    end_ = std::move(status);
    end_time_ = now;
    if (!joined_) return;
    // A client that is connected when the server shuts down may resume in a persisted world.
    const bool is_suspended = resume_.is_open() && (resumable || context_.closing) &&
                              (joined_->host().is_persisted() || !context_.draining);
    log_info("client {} {} world {}", joined_->client(),
             is_suspended ? "was disconnected from" : "left", joined_->host().id());
    joined_->leave(is_suspended ? std::optional(now) : std::nullopt);
}

void ClientSession::check_end(Clock::time_point now) {
    if (end_) return;
    ASSERT(!joined_ || !joined_->has_left());
    timeouts_.forgive_process_stall(now);
    if (context_.closing) return finish(Error{ErrorCode::unavailable, "the server shut down"}, now);
    if (context_.draining && !std::exchange(drain_notified_, true))
        outbox_.push_reply(encode_notice(
            NoticeKind::draining,
            fmt::format("the server shuts down in {:g} s", context_.config.drain_timeout_seconds)));
    if (const auto hello = resume_.take_waiting_hello()) return on_message(*hello, now);
    if (joined_) timeouts_.on_input_sequence(joined_->inputs().last_sequence(), now);
    std::optional<SessionEnd> end =
        end_of_session(timeouts_, metrics_, resume_, outbox_, joined_.get(), now);
    if (!end) return;
    if (end->drops_outgoing) outbox_.clear();
    if (end->notice == NoticeKind::refused)
        return refuse(std::move(end->error), now, end->resumable);
    if (end->notice) outbox_.push_reply(encode_notice(*end->notice, end->error.message));
    finish(std::move(end->error), now, end->resumable);
}

}  // namespace jostle::server
