// SPDX-License-Identifier: MIT
#include "replication/snapshot_cache.h"

#include <algorithm>

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

const ModuleChunk* find_chunk(const std::vector<ModuleChunk>& chunks, const std::string& tag) {
    const auto at = std::ranges::find(chunks, tag, &ModuleChunk::tag);
    return at == chunks.end() ? nullptr : &*at;
}

// Those that are new or say something else, then those that ended. One that changed and changed
// back has other bytes of the same content.
std::vector<ModuleChunk> changed_chunks(const std::vector<ModuleChunk>& now,
                                        const std::vector<ModuleChunk>& before) {
    std::vector<ModuleChunk> changed;
    for (const ModuleChunk& chunk : now) {
        const ModuleChunk* old = find_chunk(before, chunk.tag);
        if (!old || (old->bytes != chunk.bytes && *old->bytes != *chunk.bytes))
            changed.push_back(chunk);
    }
    for (const ModuleChunk& old : before)
        if (!find_chunk(now, old.tag)) changed.push_back({old.tag, nullptr});
    return changed;
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
    entry.chunks = frame.chunks;
    // The oldest other one: a thread that was held up may ask for a frame older than the ring.
    if (entries_.size() > ring) {
        const auto oldest = entries_.begin();
        entries_.erase(&oldest->second == &entry ? std::next(oldest) : oldest);
    }
    return entry;
}

SharedBytes SnapshotCache::encoding(const FramePtr& frame, BaseNumbers bases) {
    const std::lock_guard lock(mutex_);
    Entry& entry = entry_of(*frame);
    // Each base makes sense only with the one before it, in falling order.
    const Entry* base = bases.base < frame->tick ? find(bases.base) : nullptr;
    const Entry* base2 = base && bases.base2 < bases.base ? find(bases.base2) : nullptr;
    const Entry* base3 = base2 && bases.base3 < bases.base2 ? find(bases.base3) : nullptr;
    const BaseNumbers used{base ? bases.base : 0, base2 ? bases.base2 : 0, base3 ? bases.base3 : 0};
    SharedBytes& bytes = entry.encodings[used];
    if (!bytes) {
        EncodedSnapshot snapshot{
            .frame = frame->tick,
            .bases = used,
            .packed = {},
            .crc = entry.crc,
            .due = entry.due,
            .chunks = base ? changed_chunks(entry.chunks, base->chunks) : entry.chunks};
        snapshot.packed = wire::encode_frame(
            entry.quantized,
            {base ? &base->quantized : nullptr, base2 ? &base2->quantized : nullptr,
             base3 ? &base3->quantized : nullptr},
            spec_);
        bytes = std::make_shared<const std::string>(serialize_(snapshot));
        made_++;
    }
    return bytes;
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
