// SPDX-License-Identifier: MIT
#include "jostle/snapshot/channel_codec.h"

#include <algorithm>
#include <string>
#include <utility>

#include "jostle/snapshot/bit_stream.h"
#include "jostle/snapshot/crc32.h"

namespace jostle::snapshot {
namespace {

enum class Change : std::uint8_t { values = 0, length = 1, ended = 2 };
constexpr unsigned change_bits = 2;
// Orders of the exponential Golomb codes (WIRE.md).
constexpr unsigned count_order = 1, entity_order = 2, length_order = 3, run_order = 0;

using Key = std::pair<std::uint32_t, std::uint32_t>;
Key key_of(const Channel& channel) {
    return {channel.kind, channel.entity};
}

// Order of the code of the next difference, from the widths of the previous ones. Large and small
// differences alternate in many channels (an angle, a gear), so a code based on the mean alone
// would not fit.
class Spread {
public:
    unsigned order() const { return four_widths_ < 8 ? 0 : (four_widths_ >> 2) - 2; }
    void add(std::uint64_t size) { four_widths_ += bit_width(size) - (four_widths_ >> 2); }

private:
    unsigned four_widths_ = 16;  // four times the mean width
};

// Differences have 32 bits and wrap around, so every value can be reached from every other.
std::int32_t difference(std::int32_t value, std::int32_t baseline) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) -
                                     static_cast<std::uint32_t>(baseline));
}
std::int32_t sum(std::int32_t baseline, std::int32_t difference) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(baseline) +
                                     static_cast<std::uint32_t>(difference));
}
std::int32_t value_at(const std::vector<std::int32_t>* baseline, std::size_t k) {
    return baseline && k < baseline->size() ? (*baseline)[k] : 0;
}

// The CRC of the changes of channels.
class Digest {
public:
    void add(const Channel& channel, bool ended) {
        put(channel.kind);
        put(channel.entity);
        put(ended ? 0xffffffffu : static_cast<std::uint32_t>(channel.values->size()));
        if (ended) return;
        for (const std::int32_t value : *channel.values) put(static_cast<std::uint32_t>(value));
    }
    std::uint32_t crc() const { return crc32(bytes_); }

private:
    void put(std::uint32_t value) {
        for (int k = 0; k < 4; k++)
            bytes_.push_back(static_cast<std::byte>(value >> (8 * k) & 0xff));
    }
    std::vector<std::byte> bytes_;
};

struct Changed {
    const Channel* now = nullptr;       // null: the channel ended
    const Channel* baseline = nullptr;  // null: the channel is new

    const Channel& either() const { return now ? *now : *baseline; }
};

// Both lists are sorted, so one traversal of both finds the differences.
std::vector<Changed> changed_channels(const Channels& now, const Channels& baseline,
                                      std::uint64_t kinds) {
    std::vector<Changed> changed;
    const auto is_selected = [&](const Changed& c) { return (kinds >> c.either().kind & 1) != 0; };
    auto b = baseline.begin();
    const auto ended_before = [&](const Key* key) {
        for (; b != baseline.end() && (!key || key_of(*b) < *key); ++b)
            if (const Changed ended{nullptr, &*b}; is_selected(ended)) changed.push_back(ended);
    };
    for (const Channel& channel : now) {
        const Key key = key_of(channel);
        ended_before(&key);
        const bool known = b != baseline.end() && key_of(*b) == key;
        const Changed change{&channel, known ? &*b : nullptr};
        const bool same = known && (b->values == channel.values || *b->values == *channel.values);
        if (!same && is_selected(change)) changed.push_back(change);
        if (known) ++b;
    }
    ended_before(nullptr);
    return changed;
}

void write_values(BitWriter& bits, const std::vector<std::int32_t>& values,
                  const std::vector<std::int32_t>* baseline) {
    Spread spread;
    std::size_t k = 0;
    while (k < values.size()) {
        const std::size_t first = k;
        while (k < values.size() && values[k] == value_at(baseline, k)) k++;
        bits.exp_golomb(k - first, run_order);
        if (k == values.size()) return;
        const std::uint64_t size = zig_zag_encode(difference(values[k], value_at(baseline, k))) - 1;
        bits.exp_golomb(size, spread.order());
        spread.add(size);
        k++;
    }
}

// Kinds and entities are sorted, so a channel is coded as the distance from the previous one.
class ChannelPosition {
public:
    void write(BitWriter& bits, const Channel& channel) {
        bits.exp_golomb(channel.kind - kind_, 0);
        bits.exp_golomb(channel.entity - (channel.kind == kind_ ? next_entity_ : 0), entity_order);
        follow(channel.kind, channel.entity);
    }
    // Returns false if the kind or the entity is out of range.
    bool read(BitReader& bits, Channel& channel) {
        const std::uint64_t kind = kind_ + bits.exp_golomb(0);
        const std::uint64_t entity =
            bits.exp_golomb(entity_order) + (kind == kind_ ? next_entity_ : 0);
        if (kind >= channel_kinds_max || entity > 0xffffffffu) return false;
        channel.kind = static_cast<std::uint32_t>(kind);
        channel.entity = static_cast<std::uint32_t>(entity);
        follow(channel.kind, channel.entity);
        return true;
    }

private:
    void follow(std::uint32_t kind, std::uint32_t entity) {
        kind_ = kind;
        next_entity_ = std::uint64_t{entity} + 1;
    }
    std::uint32_t kind_ = 0;
    std::uint64_t next_entity_ = 0;
};

Error bad_channels(const std::string& what) {
    return {ErrorCode::corrupt_data, "channels: " + what};
}
std::string name_of(const Channel& channel) {
    return "kind " + std::to_string(channel.kind) + " of entity " + std::to_string(channel.entity);
}

Result<ChannelValues> read_values(BitReader& bits, std::size_t count,
                                  const std::vector<std::int32_t>* baseline) {
    auto values = std::make_shared<std::vector<std::int32_t>>(count);
    for (std::size_t k = 0; k < count; k++) (*values)[k] = value_at(baseline, k);
    Spread spread;
    std::uint64_t k = 0;
    while (k < count) {
        k += bits.exp_golomb(run_order);
        if (k > count) return bad_channels("run of equal values exceeds the channel");
        if (k == count) break;
        const std::uint64_t size = bits.exp_golomb(spread.order());
        if (size >= 0xffffffffu) return bad_channels("difference exceeds 32 bits");
        spread.add(size);
        std::int32_t& value = (*values)[k++];
        value = sum(value, static_cast<std::int32_t>(zig_zag_decode(size + 1)));
        if (bits.past_end()) return bad_channels("truncated data");
    }
    return ChannelValues(std::move(values));
}

// Reads one change into `channel`; `values` is null if the channel ended.
Status read_change(BitReader& bits, Channel& channel, const Channel* baseline) {
    const std::uint64_t change = bits.bits(change_bits);
    channel.values = nullptr;
    if (change == static_cast<std::uint64_t>(Change::ended))
        return baseline ? Status()
                        : bad_channels(name_of(channel) + " ended but is not in the baseline");
    if (change > static_cast<std::uint64_t>(Change::ended))
        return bad_channels(name_of(channel) + " has an unknown kind of change");
    const bool coded = change == static_cast<std::uint64_t>(Change::length);
    if (!coded && !baseline)
        return bad_channels(name_of(channel) + " changed but is not in the baseline");
    const std::uint64_t count = coded ? bits.exp_golomb(length_order) : baseline->values->size();
    if (count > channel_values_max)
        return bad_channels(name_of(channel) + " has more than " +
                            std::to_string(channel_values_max) + " values");
    Result<ChannelValues> values = read_values(bits, static_cast<std::size_t>(count),
                                               baseline ? baseline->values.get() : nullptr);
    if (!values.ok()) return values.error();
    channel.values = *std::move(values);
    return {};
}

Status check_sizes(const Channels& channels) {
    std::size_t values = 0;
    for (const Channel& channel : channels) values += channel.values->size();
    if (channels.size() > channels_max)
        return bad_channels("more than " + std::to_string(channels_max) + " channels");
    if (values > frame_values_max)
        return bad_channels("more than " + std::to_string(frame_values_max) + " values");
    return {};
}

}  // namespace

PackedChannels encode_channels(const Channels& now, const Channels& baseline, std::uint64_t kinds) {
    const std::vector<Changed> changed = changed_channels(now, baseline, kinds);
    if (changed.empty()) return {};
    BitWriter bits;
    Digest digest;
    ChannelPosition position;
    bits.exp_golomb(changed.size() - 1, count_order);
    for (const Changed& c : changed) {
        position.write(bits, c.either());
        digest.add(c.either(), !c.now);
        if (!c.now) {
            bits.bits(static_cast<std::uint64_t>(Change::ended), change_bits);
            continue;
        }
        const auto& values = *c.now->values;
        const bool same_length = c.baseline && c.baseline->values->size() == values.size();
        bits.bits(static_cast<std::uint64_t>(same_length ? Change::values : Change::length),
                  change_bits);
        if (!same_length) bits.exp_golomb(values.size(), length_order);
        write_values(bits, values, c.baseline ? c.baseline->values.get() : nullptr);
    }
    return {.bytes = bits.finish(), .crc = digest.crc()};
}

Result<DecodedChannels> read_channels(std::span<const std::byte> bytes, const Channels& baseline) {
    if (bytes.empty()) return DecodedChannels{baseline, 0};
    BitReader bits(bytes);
    const std::uint64_t count = bits.exp_golomb(count_order) + 1;
    Channels channels;
    Digest digest;
    ChannelPosition position;
    auto b = baseline.begin();
    for (std::uint64_t i = 0; i < count; i++) {
        Channel channel;
        if (!position.read(bits, channel)) return bad_channels("kind or entity out of range");
        for (; b != baseline.end() && key_of(*b) < key_of(channel); ++b) channels.push_back(*b);
        const bool known = b != baseline.end() && key_of(*b) == key_of(channel);
        if (Status s = read_change(bits, channel, known ? &*b : nullptr); !s.ok()) return s.error();
        if (known) ++b;
        digest.add(channel, !channel.values);
        if (channel.values) channels.push_back(std::move(channel));
        if (bits.past_end()) return bad_channels("truncated data");
        if (Status s = check_sizes(channels); i % 256 == 255 && !s.ok()) return s.error();
    }
    channels.insert(channels.end(), b, baseline.end());
    if (!bits.at_clean_end()) return bad_channels("unexpected bytes after the end");
    if (Status s = check_sizes(channels); !s.ok()) return s.error();
    return DecodedChannels{std::move(channels), digest.crc()};
}

Result<Channels> decode_channels(std::span<const std::byte> bytes, std::uint32_t crc,
                                 const Channels& baseline) {
    Result<DecodedChannels> read = read_channels(bytes, baseline);
    if (!read.ok()) return read.error();
    if (read->crc != crc) return bad_channels("CRC mismatch");
    return std::move(read->channels);
}

}  // namespace jostle::snapshot
