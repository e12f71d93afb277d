// SPDX-License-Identifier: MIT
#include "tests/simulation/network_line.h"

#include <utility>

namespace jostle::simulation {

namespace {

// Maximum number of bytes in transit. Beyond it the server waits; messages of a client are dropped.
constexpr std::size_t down_bytes = 64 * 1024, up_bytes = 4 * down_bytes;
constexpr int messages_per_turn = 64;

server::Peer peer(server::PlayContext& context, const std::string& name,
                  const std::string& address) {
    return {.name = name,
            .address = address,
            .call = "jostle.v1.PlayService/Play",
            .who = context.authorizer.identify({.address = address})};
}

NetworkConditions bounded(NetworkConditions conditions, std::size_t bytes, std::uint64_t seed) {
    conditions.queue_bytes = static_cast<double>(bytes);
    conditions.seed = static_cast<std::uint32_t>(seed);
    return conditions;
}

}  // namespace

NetworkLine::NetworkLine(server::PlayContext& context, const std::string& name,
                         const std::string& address, const LineSettings& settings,
                         std::uint64_t seed, Clock::time_point now)
    : chance_(seed),
      messages_to_break_(settings.messages_to_break),
      session_(context, peer(context, name, address), now),
      up_(bounded(settings.conditions, up_bytes, seed), 0),
      down_(bounded(settings.conditions, down_bytes, seed), 1) {}

void NetworkLine::send(std::string bytes, Clock::time_point now) {
    if (client_closed_ || over_ || up_.full()) return;
    if (chance_.one_in(messages_to_break_)) return cut(now, "the connection broke");
    up_.push(std::move(bytes), now);
}

std::optional<std::string> NetworkLine::receive(Clock::time_point now) {
    if (over_) return std::nullopt;
    std::optional<std::string> out = down_.take(now);
    if (!out && closed_ && down_.empty()) over_ = true;
    return out;
}

void NetworkLine::close_by_client(Clock::time_point now) {
    if (client_closed_) return;
    client_closed_ = true;
    if (!closed_) session_.on_peer_closed(now);
}

void NetworkLine::cut(Clock::time_point now, const std::string& why) {
    close_by_client(now);
    over_ = true;
    end_ = Error{ErrorCode::unavailable, why};
}

void NetworkLine::serve(Clock::time_point now) {
    if (closed_) return;
    deliver(now);
    write(now);
}

void NetworkLine::deliver(Clock::time_point now) {
    for (int i = 0; i < messages_per_turn && !client_closed_; i++) {
        const std::optional<std::string> message = up_.take(now);
        if (!message) return;
        if (!session_.end()) session_.receive(*message, now);
    }
}

void NetworkLine::write(Clock::time_point now) {
    while (!down_.full()) {
        const std::optional<server::OutMessage> out = session_.take_message(now);
        if (!out) {
            if (session_.end()) {
                closed_ = true;
                if (end_.ok()) end_ = *session_.end();
            }
            return;
        }
        if (client_closed_) continue;
        down_.push(out->concatenated(), now);
    }
    session_.wait_for_write(now);
    // As in the transports: the server does not wait for a client that does not read.
    if (session_.end()) {
        closed_ = true;
        end_ = *session_.end();
    }
}

}  // namespace jostle::simulation
