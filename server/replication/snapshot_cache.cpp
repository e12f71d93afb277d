// SPDX-License-Identifier: MIT
#include "replication/snapshot_cache.h"

#include <iterator>
#include <utility>

#include "wire/quantize.h"

namespace jostle::server {
namespace {

wire::QuantizedFrame quantized(const Frame& frame, const wire::QuantSpec& spec) {
    wire::QuantizedFrame out{.frame = frame.tick};
    out.entities.reserve(frame.entities.size());
    for (const EntityPose& e : frame.entities) {
        const auto& p = e.pose.position;
        const auto& q = e.pose.rotation;
        out.entities.push_back(
            wire::quantize(e.id, {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}}, !e.awake, spec));
    }
    return out;
}

wire::Channels channels_of(const Frame& frame) {
    wire::Channels channels;
    if (!frame.channels) return channels;
    channels.reserve(frame.channels->size());
    for (const Channel& c : *frame.channels) channels.push_back({c.kind, c.entity, c.values});
    return channels;
}

}  // namespace

SnapshotCache::Entry* SnapshotCache::find(std::uint32_t frame) {
    const auto at = entries_.find(frame);
    return at == entries_.end() ? nullptr : &at->second;
}

SnapshotCache::Entry& SnapshotCache::entry_of(const Frame& frame) {
    if (Entry* known = find(frame.tick)) return *known;
    Entry& entry = entries_[frame.tick];
    entry.quantized = quantized(frame, spec_);
    entry.crc = wire::frame_crc(entry.quantized);
    entry.due = frame.due;
    entry.channels = channels_of(frame);
    // The oldest other one: a thread that was held up may ask for a frame older than the ring.
    if (entries_.size() > ring) {
        const auto oldest = entries_.begin();
        entries_.erase(&oldest->second == &entry ? std::next(oldest) : oldest);
    }
    return entry;
}

SharedBytes SnapshotCache::encoding(const FramePtr& frame, BaseNumbers bases, std::uint64_t kinds,
                                    wire::Codec codec) {
    const std::lock_guard lock(mutex_);
    Entry& entry = entry_of(*frame);
    // Each base makes sense only with the one before it, in falling order.
    const Entry* base = bases.base < frame->tick ? find(bases.base) : nullptr;
    const Entry* base2 = base && bases.base2 < bases.base ? find(bases.base2) : nullptr;
    const Entry* base3 = base2 && bases.base3 < bases.base2 ? find(bases.base3) : nullptr;
    const BaseNumbers used{base ? bases.base : 0, base2 ? bases.base2 : 0, base3 ? bases.base3 : 0};
    if (const auto made = entry.encodings.find({used, kinds, codec}); made != entry.encodings.end())
        return made->second;
    wire::PackedChannels channels;
    if (kinds != 0)
        channels =
            wire::encode_channels(entry.channels, base ? base->channels : wire::Channels{}, kinds);
    // Where nothing of them changed it is what those get who asked for none.
    SharedBytes& bytes = entry.encodings[{used, channels.bytes.empty() ? 0 : kinds, codec}];
    if (!bytes)
        bytes =
            std::make_shared<const std::string>(serialize_({.frame = frame->tick,
                                                            .bases = used,
                                                            .packed = packed(entry, used, codec),
                                                            .crc = entry.crc,
                                                            .due = entry.due,
                                                            .channels = std::move(channels)}));
    return entry.encodings[{used, kinds, codec}] = bytes;
}

const std::vector<std::byte>& SnapshotCache::packed(Entry& entry, const BaseNumbers& bases,
                                                    wire::Codec codec) {
    const auto [at, fresh] = entry.packed.try_emplace({bases, codec});
    if (!fresh) return at->second;
    const auto poses = [&](std::uint32_t number) {
        const Entry* base = number != 0 ? find(number) : nullptr;
        return base ? &base->quantized : nullptr;
    };
    at->second = wire::encode_frame(
        entry.quantized, {poses(bases.base), poses(bases.base2), poses(bases.base3)}, spec_, codec);
    made_++;
    return at->second;
}

bool SnapshotCache::holds(std::uint32_t frame) const {
    const std::lock_guard lock(mutex_);
    return entries_.contains(frame);
}

std::uint64_t SnapshotCache::encodings_made() const {
    const std::lock_guard lock(mutex_);
    return made_;
}

}  // namespace jostle::server
