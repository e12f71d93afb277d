// SPDX-License-Identifier: MIT
//
// Encode once, send to many: the newest frames of one world, quantised once each, and every
// encoding of them against every set of bases that a client needed, made once and shared by
// reference count. Any thread.
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
#include "server/world/frame.h"

namespace jostle::server {

using SharedBytes = std::shared_ptr<const std::string>;

// What an encoding is made of; `serialize` turns it into the bytes that clients share.
struct EncodedSnapshot {
    std::uint32_t frame = 0;
    wire::BaselineFrames baselines;
    std::vector<std::byte> packed;
    std::uint32_t crc = 0;
    std::int64_t late_us = 0;
    std::uint32_t unchanged_ticks = 0;  // ticks after the base in which nothing changed
    wire::PackedChannels channels;      // of the kinds that were asked for, against the base
};

class SnapshotCache {
public:
    using Serialize = std::function<std::string(const EncodedSnapshot&)>;
    static constexpr std::size_t ring = 32;  // frames kept as bases

    SnapshotCache(wire::QuantSpec spec, Serialize serialize)
        : spec_(spec), serialize_(std::move(serialize)) {}

    // The frame against those bases; bases that fell off the ring are left out, and without a first
    // base it is absolute. `kinds`: a bit for each kind of channels that is wanted (host/frame.h).
    // Without a codec of poses only what else is told of a frame: for who is told of cells. Never
    // null.
    SharedBytes encoding(const FramePtr& frame, wire::BaselineFrames baselines,
                         std::uint64_t kinds = 0,
                         std::optional<wire::Codec> poses = wire::Codec::bits);
    // The frame's entities as integers.
    wire::QuantizedFrame quantized(const FramePtr& frame);
    // Whether the frame can still be a base.
    bool holds(std::uint32_t frame) const;

    const wire::QuantSpec& spec() const { return spec_; }
    // How many encodings of poses were made, for tests and figures: sharing keeps it far below the
    // number sent.
    std::uint64_t encodings_made() const;

private:
    struct EncodingKey {
        wire::BaselineFrames baselines;
        std::uint64_t kinds = 0;  // 0 also where none of the kinds that are wanted changed
        std::optional<wire::Codec> poses;

        auto operator<=>(const EncodingKey&) const = default;
    };
    struct Entry {
        FramePtr frame;
        wire::QuantizedFrame quantized;
        std::uint32_t crc = 0;
        // Of each block of the frame's poses, the last one included only where it is full.
        std::vector<std::uint32_t> block_crcs;
        std::vector<bool> block_rests;  // all of it lies at rest
        wire::Channels channels;
        std::map<std::pair<wire::BaselineFrames, wire::Codec>, std::vector<std::byte>> packed;
        std::map<EncodingKey, SharedBytes> encodings;
    };

    // Under the lock, against bases that are there. Poses are packed once, whoever asks for which
    // channels with them.
    const std::vector<std::byte>& packed(Entry& entry, const wire::BaselineFrames& baselines,
                                         wire::Codec codec);
    Entry& entry_of(const FramePtr& frame);
    void quantize(Entry& entry, const Entry* before, Entry oldest) const;
    Entry* find(std::uint32_t frame);
    static std::vector<wire::UnchangedRun> unchanged_runs(const Entry& entry,
                                                          const Entry& baseline);

    const wire::QuantSpec spec_;
    const Serialize serialize_;
    mutable std::mutex mutex_;
    std::map<std::uint32_t, Entry> entries_;  // by frame number, at most `ring`
    std::uint64_t made_ = 0;
};

}  // namespace jostle::server
