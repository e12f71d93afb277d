// SPDX-License-Identifier: MIT
//
// Channels that change like those of modules: small numbers, points, heights, entities that appear
// and disappear. The same seed generates the same channels on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "jostle/snapshot/channel_codec.h"

namespace jostle::snapshot {

class ChangingChannels {
public:
    explicit ChangingChannels(std::uint32_t seed) : random_(seed) {}

    const Channels& step() {
        Channels next;
        for (const Channel& channel : channels_)
            if (!chance(25)) next.push_back(chance(3) ? channel : moved(channel));
        channels_ = std::move(next);
        while (channels_.size() < 3 || chance(4)) appear();
        return channels_;
    }

private:
    bool chance(std::uint32_t one_in) { return random_() % one_in == 0; }
    std::int32_t any() {
        switch (random_() % 4) {
            case 0:
                return static_cast<std::int32_t>(random_());  // all 31-bit numbers
            case 1:
                return static_cast<std::int32_t>(random_() * 2654435761u);
            default:
                return static_cast<std::int32_t>(random_() % 200) - 100;
        }
    }
    Channel moved(const Channel& from) {
        std::vector<std::int32_t> values = *from.values;
        if (chance(8)) values.resize(random_() % 40, 7);
        const std::uint32_t step = 1u << random_() % 12;
        for (std::int32_t& value : values) {
            if (chance(2)) continue;
            const auto by = static_cast<std::uint32_t>(random_()) % (2 * step) - step;
            value = chance(30) ? any()
                               : static_cast<std::int32_t>(static_cast<std::uint32_t>(value) + by);
        }
        return {from.kind, from.entity,
                std::make_shared<const std::vector<std::int32_t>>(std::move(values))};
    }
    void appear() {
        Channel fresh{static_cast<std::uint32_t>(random_() % (chance(9) ? channel_kinds_max : 4)),
                      static_cast<std::uint32_t>(chance(9) ? random_() * 5 : random_() % 30),
                      nullptr};
        auto at = channels_.begin();
        while (at != channels_.end() &&
               (at->kind < fresh.kind || (at->kind == fresh.kind && at->entity < fresh.entity)))
            ++at;
        if (at != channels_.end() && at->kind == fresh.kind && at->entity == fresh.entity) return;
        std::vector<std::int32_t> values(random_() % (chance(5) ? 300 : 12));
        for (std::int32_t& value : values) value = any();
        fresh.values = std::make_shared<const std::vector<std::int32_t>>(std::move(values));
        channels_.insert(at, std::move(fresh));
    }

    std::minstd_rand random_;
    Channels channels_;
};

// Compares the channels of two frames.
inline bool same_channels(const Channels& a, const Channels& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t k = 0; k < a.size(); k++)
        if (a[k].kind != b[k].kind || a[k].entity != b[k].entity || *a[k].values != *b[k].values)
            return false;
    return true;
}

// proto/golden/channels.jchn: "JCHN", u32 version 1, u32 frames; per frame u32 baseline (index in
// the file, from 1; 0: none), crc, channels, packed bytes, then per channel u32 kind, entity,
// values, and its values as i32; then the packed bytes. All little-endian.
inline std::vector<std::byte> golden_channels() {
    std::vector<std::byte> out;
    const auto put = [&](std::uint32_t value) {
        for (int k = 0; k < 4; k++) out.push_back(static_cast<std::byte>(value >> (8 * k) & 0xff));
    };
    constexpr std::uint32_t frames = 16;
    for (const char c : {'J', 'C', 'H', 'N'}) out.push_back(static_cast<std::byte>(c));
    put(1);
    put(frames);
    ChangingChannels world(11);
    std::vector<Channels> told;
    for (std::uint32_t frame = 0; frame < frames; frame++) {
        told.push_back(world.step());
        const std::uint32_t back = 1 + frame % 3;
        const std::uint32_t base = frame % 9 == 0 || back > frame ? 0 : frame - back + 1;
        const PackedChannels packed =
            encode_channels(told.back(), base == 0 ? Channels{} : told[base - 1], ~0ull);
        put(base);
        put(packed.crc);
        put(static_cast<std::uint32_t>(told.back().size()));
        put(static_cast<std::uint32_t>(packed.bytes.size()));
        for (const Channel& channel : told.back()) {
            put(channel.kind);
            put(channel.entity);
            put(static_cast<std::uint32_t>(channel.values->size()));
            for (const std::int32_t value : *channel.values) put(static_cast<std::uint32_t>(value));
        }
        out.insert(out.end(), packed.bytes.begin(), packed.bytes.end());
    }
    return out;
}

}  // namespace jostle::snapshot
