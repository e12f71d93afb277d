// SPDX-License-Identifier: MIT
#include "replication/snapshot_cache.h"

#include <iterator>
#include <utility>

#include "wire/quantize.h"

namespace jostle::server {
namespace {

wire::EntityState quantized_pose(const EntityPose& e, const wire::QuantSpec& spec) {
    const auto& p = e.pose.position;
    const auto& q = e.pose.rotation;
    return wire::quantize(e.id, {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}}, !e.awake, spec);
}

// For so long all was as in the base, and changed at most in the frame's own tick.
std::uint32_t still_ticks(const Frame& frame, const Frame& base) {
    if (frame.changed_at <= base.tick) return frame.tick - base.tick;
    const bool held = frame.changed_at == frame.tick && frame.before_changed_at <= base.tick;
    return held ? frame.tick - 1 - base.tick : 0;
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

SnapshotCache::Entry& SnapshotCache::entry_of(const FramePtr& frame) {
    if (Entry* known = find(frame->tick)) return *known;
    const auto newest = entries_.empty() ? nullptr : &entries_.rbegin()->second;
    Entry& entry = entries_[frame->tick];
    entry.frame = frame;
    quantize(entry, newest);
    entry.channels = channels_of(*frame);
    // The oldest other one: a thread that was held up may ask for a frame older than the ring.
    if (entries_.size() > ring) {
        const auto oldest = entries_.begin();
        entries_.erase(&oldest->second == &entry ? std::next(oldest) : oldest);
    }
    return entry;
}

// What stayed in its block stays as it was made of the frame before.
void SnapshotCache::quantize(Entry& entry, const Entry* before) const {
    const Frame& frame = *entry.frame;
    const auto& blocks = frame.entities.blocks();
    const bool same_list = before && before->frame->entity_list == frame.entity_list &&
                           before->frame->entities.size() == frame.entities.size();
    if (same_list) {
        entry.quantized = before->quantized;
        entry.crc = before->crc;
    }
    entry.quantized.frame = frame.tick;
    entry.quantized.entities.resize(frame.entities.size());
    bool changed = !same_list;
    for (std::size_t b = 0; b < blocks.size(); b++) {
        if (same_list && before->frame->entities.blocks()[b] == blocks[b]) continue;
        changed = true;
        auto to = entry.quantized.entities.begin() +
                  static_cast<std::ptrdiff_t>(b * PoseList::block_size);
        for (const EntityPose& pose : *blocks[b]) *to++ = quantized_pose(pose, spec_);
    }
    if (changed) entry.crc = wire::frame_crc(entry.quantized);
}

SharedBytes SnapshotCache::encoding(const FramePtr& frame, wire::BaseFrames bases,
                                    std::uint64_t kinds, std::optional<wire::Codec> poses) {
    const std::lock_guard lock(mutex_);
    Entry& entry = entry_of(frame);
    // Each base makes sense only with the one before it, in falling order.
    const Entry* base = bases.base < frame->tick ? find(bases.base) : nullptr;
    const Entry* base2 = base && bases.base2 < bases.base ? find(bases.base2) : nullptr;
    const Entry* base3 = base2 && bases.base3 < bases.base2 ? find(bases.base3) : nullptr;
    const wire::BaseFrames used{base ? bases.base : 0, base2 ? bases.base2 : 0,
                                base3 ? bases.base3 : 0};
    if (const auto made = entry.encodings.find({used, kinds, poses}); made != entry.encodings.end())
        return made->second;
    wire::PackedChannels channels;
    if (kinds != 0)
        channels =
            wire::encode_channels(entry.channels, base ? base->channels : wire::Channels{}, kinds);
    // Where nothing of them changed it is what those get who asked for none.
    SharedBytes& bytes = entry.encodings[{used, channels.bytes.empty() ? 0 : kinds, poses}];
    if (!bytes)
        bytes = std::make_shared<const std::string>(
            serialize_({.frame = frame->tick,
                        .bases = used,
                        .packed = poses ? packed(entry, used, *poses) : std::vector<std::byte>(),
                        .crc = poses ? entry.crc : 0,
                        .late_us = frame->late_us,
                        .still = base ? still_ticks(*frame, *base->frame) : 0,
                        .channels = std::move(channels)}));
    return entry.encodings[{used, kinds, poses}] = bytes;
}

const std::vector<std::byte>& SnapshotCache::packed(Entry& entry, const wire::BaseFrames& bases,
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

wire::QuantizedFrame SnapshotCache::quantized(const FramePtr& frame) {
    const std::lock_guard lock(mutex_);
    return entry_of(frame).quantized;
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
