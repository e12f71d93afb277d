// SPDX-License-Identifier: MIT
//
// Encode once, send to many: the newest frames of one world are quantized once each, and each
// encoding of a frame against a set of baselines is made once and shared by reference count. A
// client that lacks the usual baselines of its cadence class gets an existing encoding whose
// baselines it has, so that the number of encodings per frame does not grow with the number of
// clients. It is limited in any case. Any thread.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "jostle/snapshot/baseline_frames.h"
#include "jostle/snapshot/channel_codec.h"
#include "jostle/snapshot/frame_codec.h"
#include "jostle/snapshot/precision.h"
#include "server/replication/baseline_tracker.h"
#include "server/world/frame.h"

namespace jostle::server {

using SharedBytes = std::shared_ptr<const std::string>;

// The content of an encoding; `serialize` converts it to the bytes shared by clients.
struct EncodedSnapshot {
    std::uint32_t frame = 0;
    snapshot::BaselineFrames baselines;
    std::vector<std::byte> packed;
    std::uint32_t crc = 0;
    std::int64_t late_us = 0;
    std::uint32_t unchanged_ticks = 0;  // ticks after the baseline in which nothing changed
    snapshot::PackedChannels channels;  // of the requested kinds, relative to the baseline
};

class SnapshotCache {
public:
    using Serialize = std::function<std::string(const EncodedSnapshot&)>;
    static constexpr std::size_t ring = 32;  // frames retained as baselines
    // Pose encodings of a frame for clients that have baselines. Keyframes do not count: each codec
    // has one.
    static constexpr int encodings_per_frame_max = 16;

    // `precision`: guaranteed for every pose in the units of `spec`. Not set: poses are rounded to
    // the nearest units.
    SnapshotCache(snapshot::QuantSpec spec, Serialize serialize, snapshot::Precision precision = {})
        : spec_(spec), precision_(precision), serialize_(std::move(serialize)) {}

    // Encodes the frame against the baselines; baselines that left the ring are omitted, and
    // without a first baseline the encoding is a keyframe. `kinds`: one bit per requested channel
    // kind (world/frame.h). Without a pose codec only the other fields are encoded, for clients
    // that receive cells. Never null.
    SharedBytes encoding(const FramePtr& frame, snapshot::BaselineFrames baselines,
                         std::uint64_t kinds = 0,
                         std::optional<snapshot::Codec> poses = snapshot::Codec::bits);
    // The same for a client that has the frames `known`: an encoding of that frame that was made
    // before, if its baselines are known to the client and hardly older than the best ones. Null:
    // the frame has its maximum of encodings, and none of them suits the client.
    struct Shared {
        SharedBytes bytes;
        bool fresh = false;  // the poses were encoded for this call
    };
    Shared shared_encoding(const FramePtr& frame, const BaselineTracker& known,
                           std::uint64_t kinds = 0,
                           std::optional<snapshot::Codec> poses = snapshot::Codec::bits);
    // The frame of a tick; null: no encoding of it was requested, or it left the ring.
    FramePtr frame(std::uint32_t tick) const;
    // The quantized entities of the frame.
    snapshot::QuantizedFrame quantized(const FramePtr& frame);
    // Whether the frame can still be a baseline.
    bool holds(std::uint32_t frame) const;

    const snapshot::QuantSpec& spec() const { return spec_; }
    // Number of pose encodings made, for tests and measurements: sharing keeps it far below the
    // number sent.
    std::uint64_t encodings_made() const;

private:
    struct EncodingKey {
        snapshot::BaselineFrames baselines;
        std::uint64_t kinds = 0;  // also 0 if none of the requested kinds changed
        std::optional<snapshot::Codec> poses;

        auto operator<=>(const EncodingKey&) const = default;
    };
    struct Entry {
        FramePtr frame;
        snapshot::QuantizedFrame quantized;
        std::uint32_t crc = 0;
        // Of each block of poses; the last block is included only if it is full.
        std::vector<std::uint32_t> block_crcs;
        std::vector<bool> block_rests;  // all entities of the block are at rest
        snapshot::Channels channels;
        std::map<std::pair<snapshot::BaselineFrames, snapshot::Codec>, std::vector<std::byte>>
            packed;
        std::map<EncodingKey, SharedBytes> encodings;
        int encodings_with_baselines = 0;  // of poses
    };

    // Requires the lock, and baselines that are stored. Poses are encoded once for all combinations
    // of channels.
    const std::vector<std::byte>& packed(Entry& entry, const snapshot::BaselineFrames& baselines,
                                         snapshot::Codec codec);
    SharedBytes encode(Entry& entry, const snapshot::BaselineFrames& wanted, std::uint64_t kinds,
                       std::optional<snapshot::Codec> poses);
    snapshot::BaselineFrames held(const snapshot::BaselineFrames& wanted, std::uint32_t tick) const;
    Entry& entry_of(const FramePtr& frame);
    void quantize(Entry& entry, const Entry* previous, Entry oldest) const;
    void quantize_block(Entry& entry, std::size_t block) const;
    Entry* find(std::uint32_t frame);
    const Entry* find(std::uint32_t frame) const;
    static std::vector<snapshot::UnchangedRun> unchanged_runs(const Entry& entry,
                                                              const Entry& baseline);

    const snapshot::QuantSpec spec_;
    const snapshot::Precision precision_;
    const Serialize serialize_;
    mutable std::mutex mutex_;
    std::map<std::uint32_t, Entry> entries_;  // by frame number, at most `ring`
    std::uint64_t made_ = 0;
};

}  // namespace jostle::server
