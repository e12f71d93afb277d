// SPDX-License-Identifier: MIT
#include "server/session/session_timeouts.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

namespace jostle::server {

void SessionTimeouts::on_datagram(Clock::time_point arrived) {
    if (arrived >= last_received_) on_received(arrived);
}

void SessionTimeouts::on_input_sequence(std::uint32_t sequence, Clock::time_point now) {
    if (std::exchange(input_sequence_, sequence) != sequence) last_input_ = now;
}

void SessionTimeouts::on_write_blocked(Clock::time_point now) {
    if (!blocked_since_) blocked_since_ = now;
}

void SessionTimeouts::forgive_process_stall(Clock::time_point now) {
    const Clock::duration pause = now - std::exchange(checked_, now);
    if (pause <= process_stall_min) return;
    begun_ += pause;
    last_received_ = std::min(last_received_ + pause, now);
    last_input_ = std::min(last_input_ + pause, now);
    if (blocked_since_) blocked_since_ = std::min(*blocked_since_ + pause, now);
}

std::optional<Error> SessionTimeouts::hello_timeout(Clock::time_point now) const {
    if (now - begun_ <= from_seconds(settings_.hello_timeout_seconds)) return std::nullopt;
    return Error{ErrorCode::deadline_exceeded,
                 fmt::format("no Hello arrived within {:g} s; the first message must be a Hello",
                             settings_.hello_timeout_seconds)};
}

double SessionTimeouts::transfer_seconds(std::size_t bytes) {
    constexpr double slowest = 32e3;  // bytes per second
    return std::min(static_cast<double>(bytes) / slowest, 120.0);
}

std::optional<Error> SessionTimeouts::client_timeout(Clock::time_point now) const {
    constexpr double answer_seconds = 2;
    const double patience =
        std::max(settings_.client_timeout_seconds, transfer_seconds(sent_bytes_) + answer_seconds);
    if (now - last_received_ <= from_seconds(patience)) return std::nullopt;
    return Error{ErrorCode::deadline_exceeded,
                 fmt::format("no message arrived for {:g} s; send an Ack or a Ping more often",
                             settings_.client_timeout_seconds)};
}

std::optional<Error> SessionTimeouts::idle_timeout(Clock::time_point now) const {
    if (idle_kick_seconds_ <= 0 || now - last_input_ <= from_seconds(idle_kick_seconds_))
        return std::nullopt;
    return Error{ErrorCode::deadline_exceeded,
                 fmt::format("the client sent no input for {:g} s; join as a spectator to watch",
                             idle_kick_seconds_)};
}

std::optional<Error> SessionTimeouts::read_timeout(Clock::time_point now) const {
    if (!blocked_since_ || now - *blocked_since_ <= from_seconds(settings_.client_timeout_seconds))
        return std::nullopt;
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("the client read nothing for {:g} s; read messages as they arrive",
                             settings_.client_timeout_seconds)};
}

}  // namespace jostle::server
