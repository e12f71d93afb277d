// SPDX-License-Identifier: MIT
#include "tests/simulation/network_line.h"

#include <utility>

namespace jostle::simulation {

namespace {

// Maximum number of bytes in flight from a client; it waits beyond that.
constexpr std::size_t up_max = 4 * Pipe::capacity;
constexpr int messages_per_turn = 64;

server::Peer peer(server::PlayContext& context, const std::string& name,
                  const std::string& address) {
    return {.name = name,
            .address = address,
            .call = "jostle.v1.PlayService/Play",
            .who = context.authorizer.identify({.address = address})};
}

}  // namespace

NetworkLine::NetworkLine(server::PlayContext& context, const std::string& name,
                         const std::string& address, NetworkConditions quality, std::uint64_t seed,
                         Clock::time_point now)
    : chance_(seed), quality_(quality), session_(context, peer(context, name, address), now) {}

Clock::time_point NetworkLine::arrival(Clock::time_point now) {
    return now + quality_.delay +
           std::chrono::duration_cast<Clock::duration>(quality_.delay * chance_.in(0, 1));
}

void NetworkLine::send(std::string bytes, Clock::time_point now) {
    if (client_closed_ || over_ || up_.bytes() > up_max) return;
    if (chance_.one_in(quality_.cuts_after)) return cut(now, "the connection broke");
    up_.put(std::move(bytes), arrival(now));
}

std::optional<std::string> NetworkLine::receive(Clock::time_point now) {
    if (over_) return std::nullopt;
    std::optional<std::string> out = down_.take(now);
    if (!out && closed_ && down_.bytes() == 0) over_ = true;
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
    while (!down_.is_full()) {
        const std::optional<server::OutMessage> out = session_.take_message(now);
        if (!out) {
            if (session_.end()) {
                closed_ = true;
                if (end_.ok()) end_ = *session_.end();
            }
            return;
        }
        if (client_closed_) continue;
        down_.put(out->concatenated(), arrival(now));
    }
    session_.wait_for_write(now);
    // As in the transports: the server does not wait for a client that does not read.
    if (session_.end()) {
        closed_ = true;
        end_ = *session_.end();
    }
}

}  // namespace jostle::simulation
