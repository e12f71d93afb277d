// SPDX-License-Identifier: MIT
#include "server/replication/snapshot_cache.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/snapshot/entity_diff.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::server {
namespace {

static_assert(PoseList::block_size == snapshot::crc_block);

snapshot::Pose pose_of(const EntityPose& e) {
    const auto& p = e.pose.position;
    const auto& q = e.pose.rotation;
    return {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}};
}

// Finds the pose of an entity by its id, which is at `guess` if the entity list is the same.
const EntityPose* find_pose(const PoseList& poses, EntityId id, std::size_t guess) {
    if (guess < poses.size() && poses[guess].id == id) return &poses[guess];
    std::size_t low = 0, high = poses.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (poses[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < poses.size() && poses[low].id == id ? &poses[low] : nullptr;
}

// Baselines up to this factor older than the best ones are used to share an encoding.
constexpr std::uint32_t shared_age_factor = 2;

// Ticks in which nothing changed since the baseline, except possibly in the frame's own tick.
std::uint32_t unchanged_ticks(const Frame& frame, const Frame& baseline) {
    if (frame.changed_at <= baseline.tick) return frame.tick - baseline.tick;
    const bool held = frame.changed_at == frame.tick && frame.previous_changed_at <= baseline.tick;
    return held ? frame.tick - 1 - baseline.tick : 0;
}

snapshot::Channels channels_of(const Frame& frame) {
    snapshot::Channels channels;
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

const SnapshotCache::Entry* SnapshotCache::find(std::uint32_t frame) const {
    const auto at = entries_.find(frame);
    return at == entries_.end() ? nullptr : &at->second;
}

SnapshotCache::Entry& SnapshotCache::entry_of(const FramePtr& frame) {
    if (Entry* known = find(frame->tick)) return *known;
    const auto newest = entries_.empty() ? nullptr : &entries_.rbegin()->second;
    // Reuses the buffers of the evicted entry: they have the same size, and mostly the same
    // content. A delayed thread may request a frame older than the ring.
    Entry oldest;
    if (entries_.size() >= ring && entries_.begin()->first < frame->tick) {
        oldest = std::move(entries_.begin()->second);
        entries_.erase(entries_.begin());
    }
    Entry& entry = entries_[frame->tick];
    entry.frame = frame;
    quantize(entry, newest, std::move(oldest));
    entry.channels = channels_of(*frame);
    if (entries_.size() > ring) entries_.erase(std::next(entries_.begin()));
    ASSERT(entries_.size() <= ring && entries_.contains(frame->tick));
    return entry;
}

// Blocks that are unchanged from the previous frame reuse its results.
void SnapshotCache::quantize(Entry& entry, const Entry* previous, Entry oldest) const {
    const Frame& frame = *entry.frame;
    const auto& blocks = frame.entities.blocks();
    const auto is_of_same = [&](const Entry* other) {
        return other && other->frame && other->frame->entity_list == frame.entity_list &&
               other->frame->entities.size() == frame.entities.size();
    };
    if (!is_of_same(previous)) previous = nullptr;
    FramePtr reused;  // the frame that the reused content of `entry` belongs to
    if (previous && is_of_same(&oldest)) {
        reused = oldest.frame;
        entry.quantized = std::move(oldest.quantized);
        entry.block_crcs = std::move(oldest.block_crcs);
        entry.block_rests = std::move(oldest.block_rests);
    }
    entry.quantized.frame = frame.tick;
    entry.quantized.entities.resize(frame.entities.size());
    entry.block_crcs.resize(frame.entities.size() / PoseList::block_size);
    entry.block_rests.resize(blocks.size());
    ASSERT(entry.block_rests.size() == blocks.size());
    bool changed = !previous;
    for (std::size_t b = 0; b < blocks.size(); b++) {
        const bool known = previous && previous->frame->entities.blocks()[b] == blocks[b];
        changed |= !known;
        if (reused && reused->entities.blocks()[b] == blocks[b]) continue;
        const std::size_t first = b * PoseList::block_size, size = blocks[b]->size();
        const auto to = std::span(entry.quantized.entities).subspan(first, size);
        if (known) {
            std::ranges::copy(std::span(previous->quantized.entities).subspan(first, size),
                              to.begin());
            entry.block_rests[b] = previous->block_rests[b];
            if (b < entry.block_crcs.size()) entry.block_crcs[b] = previous->block_crcs[b];
            continue;
        }
        quantize_block(entry, b);
        entry.block_rests[b] = std::ranges::all_of(to, &snapshot::EntityState::at_rest);
        if (b < entry.block_crcs.size()) entry.block_crcs[b] = snapshot::block_crc(to);
    }
    ASSERT(changed || previous);
    entry.crc = changed ? snapshot::frame_crc(entry.quantized, entry.block_crcs) : previous->crc;
}

// With a precision, the states depend on those of the two quantized frames before this one.
void SnapshotCache::quantize_block(Entry& entry, std::size_t block) const {
    const std::size_t first = block * PoseList::block_size;
    const Entry *last = nullptr, *before_last = nullptr;
    if (precision_.is_set()) {
        auto at = entries_.find(entry.frame->tick);
        if (at != entries_.begin()) last = &(--at)->second;
        if (last && at != entries_.begin()) before_last = &(--at)->second;
    }
    snapshot::SentMotion sent;
    if (last) sent.spacing.dt1 = entry.frame->tick - last->frame->tick;
    if (before_last) sent.spacing.dt2 = last->frame->tick - before_last->frame->tick;
    // A longer gap has no meaningful prediction.
    if (sent.spacing.dt1 > snapshot::baseline_distance_max ||
        sent.spacing.dt2 > snapshot::baseline_distance_max)
        last = before_last = nullptr, sent.spacing = {};
    snapshot::EntityFinder in_last(last ? &last->quantized : nullptr),
        in_before_last(before_last ? &before_last->quantized : nullptr);
    std::size_t at = first;
    for (const EntityPose& pose : *entry.frame->entities.blocks()[block]) {
        sent.last = in_last.find(pose.id);
        sent.before_last = in_before_last.find(pose.id);
        const EntityPose* last_pose =
            sent.last ? find_pose(last->frame->entities, pose.id, at) : nullptr;
        const snapshot::Pose truth = last_pose ? pose_of(*last_pose) : snapshot::Pose{};
        sent.last_pose = last_pose ? &truth : nullptr;
        entry.quantized.entities[at++] =
            precision_.is_set() ? snapshot::quantize_within(precision_, pose.id, pose_of(pose),
                                                            !pose.awake, sent, spec_)
                                : snapshot::quantize(pose.id, pose_of(pose), !pose.awake, spec_);
    }
}

// Blocks that both frames share, and in which all entities are at rest.
std::vector<snapshot::UnchangedRun> SnapshotCache::unchanged_runs(const Entry& entry,
                                                                  const Entry& baseline) {
    std::vector<snapshot::UnchangedRun> runs;
    if (entry.frame->entity_list != baseline.frame->entity_list) return runs;
    const auto &blocks = entry.frame->entities.blocks(),
               &previous = baseline.frame->entities.blocks();
    if (blocks.size() != previous.size()) return runs;
    ASSERT(entry.block_rests.size() == blocks.size());
    for (std::size_t b = 0; b < blocks.size(); b++) {
        if (blocks[b] != previous[b] || !entry.block_rests[b]) continue;
        const std::size_t begin = b * PoseList::block_size, end = begin + blocks[b]->size();
        if (!runs.empty() && runs.back().end == begin)
            runs.back().end = end;
        else
            runs.push_back({begin, end});
    }
    return runs;
}

SharedBytes SnapshotCache::encoding(const FramePtr& frame, snapshot::BaselineFrames baselines,
                                    std::uint64_t kinds, std::optional<snapshot::Codec> poses) {
    const std::lock_guard lock(mutex_);
    return encode(entry_of(frame), baselines, kinds, poses);
}

SnapshotCache::Shared SnapshotCache::shared_encoding(const FramePtr& frame,
                                                     const BaselineTracker& known,
                                                     std::uint64_t kinds,
                                                     std::optional<snapshot::Codec> poses) {
    const std::lock_guard lock(mutex_);
    Entry& entry = entry_of(frame);
    const std::uint32_t tick = frame->tick;
    const snapshot::BaselineFrames best = held(known.baselines_for(tick), tick);
    const std::uint64_t made_before = made_;
    if (best.baseline == 0 || !poses || entry.encodings.contains({best, kinds, poses}) ||
        entry.packed.contains({best, *poses}))
        return {encode(entry, best, kinds, poses), made_ != made_before};
    // Of the encodings that the client can decode, the one with the newest baselines.
    const bool is_full = entry.encodings_with_baselines >= encodings_per_frame_max;
    const snapshot::BaselineFrames* suitable = nullptr;
    for (const auto& [key, bytes] : entry.packed) {
        const auto& [baselines, codec] = key;
        if (codec != *poses || baselines.baseline == 0 || !known.has(baselines)) continue;
        if (!is_full && tick - baselines.baseline > shared_age_factor * (tick - best.baseline))
            continue;
        if (!suitable || *suitable < baselines) suitable = &baselines;
    }
    if (suitable) return {encode(entry, *suitable, kinds, poses), false};
    if (is_full) return {};
    return {encode(entry, best, kinds, poses), true};
}

// The baselines that are stored and predictable. Each is usable only with the previous one, in
// descending order.
snapshot::BaselineFrames SnapshotCache::held(const snapshot::BaselineFrames& wanted,
                                             std::uint32_t tick) const {
    const snapshot::BaselineFrames usable = snapshot::predictable(tick, wanted, spec_);
    const bool first = usable.baseline < tick && find(usable.baseline);
    const bool second = first && usable.baseline2 < usable.baseline && find(usable.baseline2);
    const bool third = second && usable.baseline3 < usable.baseline2 && find(usable.baseline3);
    return {first ? usable.baseline : 0, second ? usable.baseline2 : 0,
            third ? usable.baseline3 : 0};
}

SharedBytes SnapshotCache::encode(Entry& entry, const snapshot::BaselineFrames& wanted,
                                  std::uint64_t kinds, std::optional<snapshot::Codec> poses) {
    const FramePtr& frame = entry.frame;
    const snapshot::BaselineFrames used = held(wanted, frame->tick);
    const Entry* const baseline = used.baseline != 0 ? find(used.baseline) : nullptr;
    if (const auto made = entry.encodings.find({used, kinds, poses}); made != entry.encodings.end())
        return made->second;
    snapshot::PackedChannels channels;
    if (kinds != 0)
        channels = snapshot::encode_channels(
            entry.channels, baseline ? baseline->channels : snapshot::Channels{}, kinds);
    // If none of the channels changed, the bytes are the same as without channels.
    SharedBytes& bytes = entry.encodings[{used, channels.bytes.empty() ? 0 : kinds, poses}];
    if (!bytes)
        bytes = std::make_shared<const std::string>(
            serialize_({.frame = frame->tick,
                        .baselines = used,
                        .packed = poses ? packed(entry, used, *poses) : std::vector<std::byte>(),
                        .crc = poses ? entry.crc : 0,
                        .late_us = frame->late_us,
                        .unchanged_ticks = baseline ? unchanged_ticks(*frame, *baseline->frame) : 0,
                        .channels = std::move(channels)}));
    return entry.encodings[{used, kinds, poses}] = bytes;
}

const std::vector<std::byte>& SnapshotCache::packed(Entry& entry,
                                                    const snapshot::BaselineFrames& baselines,
                                                    snapshot::Codec codec) {
    const auto [at, fresh] = entry.packed.try_emplace({baselines, codec});
    if (!fresh) return at->second;
    const auto poses = [&](std::uint32_t number) {
        const Entry* baseline = number != 0 ? find(number) : nullptr;
        return baseline ? &baseline->quantized : nullptr;
    };
    const Entry* const baseline = find(baselines.baseline);
    const std::vector<snapshot::UnchangedRun> unchanged =
        baseline ? unchanged_runs(entry, *baseline) : std::vector<snapshot::UnchangedRun>();
    at->second = snapshot::encode_frame(
        entry.quantized,
        {poses(baselines.baseline), poses(baselines.baseline2), poses(baselines.baseline3)}, spec_,
        codec, unchanged);
    made_++;
    if (baseline) entry.encodings_with_baselines++;
    return at->second;
}

snapshot::QuantizedFrame SnapshotCache::quantized(const FramePtr& frame) {
    const std::lock_guard lock(mutex_);
    return entry_of(frame).quantized;
}

FramePtr SnapshotCache::frame(std::uint32_t tick) const {
    const std::lock_guard lock(mutex_);
    const Entry* const entry = find(tick);
    return entry ? entry->frame : nullptr;
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
