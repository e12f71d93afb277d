// SPDX-License-Identifier: MIT
#include "jostle/client/link_conditioner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace jostle::client {
namespace {

constexpr double longest_ms = 60'000;

std::int64_t us_of(double ms) {
    return std::llround(1000 * ms);
}

Error bad_link(std::string_view part, const std::string& why) {
    return {ErrorCode::invalid_argument, "link setting '" + std::string(part) + "': " + why};
}

Status read_number(LinkSettings& settings, std::string_view part) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) return bad_link(part, "write it as name=number");
    const std::string_view name = part.substr(0, equals), text = part.substr(equals + 1);
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size() || !(value >= 0))
        return bad_link(part, "after = comes a number from 0");
    if (name == "seed") {
        if (value > 0xffffffffu) return bad_link(part, "at most 4294967295");
        settings.seed = static_cast<std::uint32_t>(value);
        return {};
    }
    struct Field {
        std::string_view name;
        double LinkSettings::*at;
        double most;
    };
    static constexpr Field fields[] = {
        {"delay", &LinkSettings::delay_ms, longest_ms},
        {"jitter", &LinkSettings::jitter_ms, longest_ms},
        {"tail", &LinkSettings::tail_ms, longest_ms},
        {"stalls", &LinkSettings::stalls_ms, longest_ms},
        {"stall_every", &LinkSettings::stall_every_ms, 1e9},
        {"loss", &LinkSettings::loss, 1},
        {"retransmit", &LinkSettings::retransmit_ms, longest_ms},
    };
    for (const Field& field : fields) {
        if (field.name != name) continue;
        if (value > field.most)
            return bad_link(part, "at most " + std::to_string(std::llround(field.most)));
        settings.*field.at = value;
        return {};
    }
    return bad_link(part,
                    "there are delay, jitter, tail, stalls, stall_every, loss, retransmit, seed");
}

}  // namespace

Result<LinkSettings> read_link_settings(std::string_view text) {
    LinkSettings settings;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        if (const Status read = read_number(settings, text.substr(0, comma)); !read.ok())
            return read.error();
        text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    }
    return settings;
}

LinkConditioner::LinkConditioner(const LinkSettings& settings)
    : settings_(settings), random_(settings.seed) {}

// Mulberry32 by Tommy Ettinger: 32-bit words only, so that a browser draws the same numbers.
double LinkConditioner::chance() {
    random_ += 0x6d2b79f5u;
    std::uint32_t t = (random_ ^ (random_ >> 15)) * (random_ | 1u);
    t ^= t + (t ^ (t >> 7)) * (t | 61u);
    return (t ^ (t >> 14)) / 4294967296.0;
}

std::int64_t LinkConditioner::after_stalls(std::int64_t arrival_us) {
    const std::int64_t length = us_of(settings_.stalls_ms);
    while (arrival_us >= stall_us_ + length) {
        // A stall begins after the one before has ended.
        const double gap_ms = settings_.stall_every_ms * (0.5 + chance());
        stall_us_ += std::max(us_of(gap_ms), length + 1000);
    }
    return arrival_us >= stall_us_ ? stall_us_ + length : arrival_us;
}

std::int64_t LinkConditioner::arrival_us(std::int64_t sent_us) {
    if (!begun_) {
        begun_ = true;
        stall_us_ = sent_us + us_of(settings_.stall_every_ms * (0.5 + chance()));
    }
    double way_ms = settings_.delay_ms;
    if (settings_.jitter_ms > 0) way_ms += settings_.jitter_ms * chance();
    if (settings_.tail_ms > 0) way_ms -= settings_.tail_ms * std::log(1 - chance());
    if (settings_.loss > 0 && chance() < settings_.loss) way_ms += settings_.retransmit_ms;
    std::int64_t arrival = std::max(sent_us + us_of(way_ms), last_arrival_us_);
    if (settings_.stalls_ms > 0) arrival = after_stalls(arrival);
    return last_arrival_us_ = arrival;
}

}  // namespace jostle::client
