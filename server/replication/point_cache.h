// SPDX-License-Identifier: MIT
//
// The newest states of the point objects of one world, and their encodings, which clients with the
// same baselines share. Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "jostle/snapshot/point_codec.h"
#include "server/replication/snapshot_cache.h"
#include "server/world/frame.h"

namespace jostle::server {

// A state of an object as a client has it.
struct SentPoints {
    std::uint32_t number = 0;
    std::size_t levels = snapshot::point_levels;

    auto operator<=>(const SentPoints&) const = default;
};
// The newest first; each was sent with the next one as its baseline.
using SentStates = std::vector<SentPoints>;

// A state as sent.
struct EncodedPoints {
    std::uint32_t object = 0, number = 0, back = 0, tick = 0;  // of jostle.v1.PointUpdate
    snapshot::PackedPoints packed;
};

class PointCache {
public:
    using SerializeState = std::function<std::string(const EncodedPoints&)>;
    using SerializeObject = std::function<std::string(const PointObjectDescription&)>;
    // Baselines per object: at most this number of states, and this number of points in all.
    static constexpr std::size_t states_retained = 32, points_retained = 256 * 1024;

    PointCache(SerializeState serialize_state, SerializeObject serialize_object)
        : serialize_state_(std::move(serialize_state)),
          serialize_object_(std::move(serialize_object)) {}

    // The objects of a frame, or of the newest frame so far if that is newer. Never null.
    std::shared_ptr<const PointObjects> objects(const FramePtr& frame);

    struct Encoding {
        SharedBytes field;          // of jostle.v1.Snapshot; never null
        std::size_t baselines = 0;  // number of `known` states that it uses
        // Approximate size if only this many levels, plus one, were sent.
        std::array<std::size_t, snapshot::point_levels> bytes_of_levels = {};
    };
    // The encoding of a state with the first `levels` levels. If the newest of the `known` states
    // is no longer stored, the encoding has no baseline.
    Encoding encoding(const PointObjectState& state, std::size_t levels, const SentStates& known);
    // The description of an object as a field of jostle.v1.Snapshot.
    SharedBytes description(const PointObjectDescription& object);

private:
    using StatePtr = std::shared_ptr<const PointObjectState>;

    // A state as a client with some levels has it.
    struct Variant {
        snapshot::PointState points;
        std::vector<std::uint32_t> ids;  // loose points
    };
    struct History {
        explicit History(const PointObjectDescription& object);

        snapshot::PointLayout layout;
        snapshot::PointOrder order;
        std::deque<StatePtr> states;  // the oldest first
        std::map<SentPoints, std::shared_ptr<const Variant>> variants;
        // Encodings of the newest state.
        std::map<std::tuple<std::size_t, SentStates>, Encoding> encodings;
        SharedBytes description;
    };

    void add(const StatePtr& state);
    static std::shared_ptr<const Variant> variant(History& history, const PointObjectState& state,
                                                  std::size_t levels);
    Encoding encode(History& history, const PointObjectState& state, std::size_t levels,
                    const SentStates& known) const;

    const SerializeState serialize_state_;
    const SerializeObject serialize_object_;
    std::mutex mutex_;
    std::uint32_t tick_ = 0;
    std::shared_ptr<const PointObjects> objects_ = std::make_shared<const PointObjects>();
    std::map<std::uint32_t, History> histories_;  // by object
};

// The layout of an object for the codec.
snapshot::PointLayout layout_of(const PointObjectDescription& object);

}  // namespace jostle::server
