// SPDX-License-Identifier: MIT
//
// The point objects of a client's world: ropes, cloth, particles and heights (proto/WIRE.md,
// "Points"). It is independent of the network: the caller passes the messages.
//
//     for (auto& [id, object] : view.points().objects())
//         draw(object.description(), object.sample(rendered_tick, tick_hz));
//
// One thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/point_history.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

/// m; in the frame of PointObject.entity, or in the world.
using PointPosition = std::array<double, 3>;

/// The points of one object at a rendered time.
struct SmoothPoints {
    std::uint32_t object = 0;  ///< PointObject.id
    std::vector<PointPosition> positions;
};

/// One point object and its newest states.
class PointObjectView {
public:
    /// Returns corrupt_data if the description is invalid. `divisor`: of its channel kind.
    static Result<PointObjectView> create(const v1::PointObject& description,
                                          std::uint32_t divisor);

    const v1::PointObject& description() const { return description_; }
    const snapshot::PointHistory& history() const { return history_; }
    /// Whether a state was received.
    bool has_points() const { return !history_.states().empty(); }
    /// Number of points; 0 before the first state of loose points.
    std::size_t points() const;
    /// Positions of the newest state.
    std::vector<PointPosition> newest() const;

    /// Positions at a time in ticks (rendered_time.h), which increases from call to call. They are
    /// interpolated between two states; an object that is sent every few ticks is shown as many
    /// ticks later. Without a newer state, motion is extrapolated for at most 50 ms and then held.
    /// A new loose point appears at its first state. Empty before the first state.
    std::vector<PointPosition> sample(double tick, double tick_hz);

private:
    friend class PointObjects;
    PointObjectView(const v1::PointObject& description, snapshot::PointHistory history,
                    std::uint32_t divisor)
        : description_(description), history_(std::move(history)), divisor_(divisor) {}

    PointPosition position(const snapshot::PointState& state, std::size_t point) const;
    double lag_ticks() const;

    v1::PointObject description_;
    snapshot::PointHistory history_;
    std::uint32_t divisor_ = 1;
    double lag_ = -1, last_tick_ = 0;  // of sample(); -1: not called yet
};

/// All point objects.
class PointObjects {
public:
    /// Starts a new stream. `kinds`: Welcome.channels.
    void begin(std::vector<v1::ChannelKind> kinds);
    /// Applies the point objects of a snapshot. Returns the first error; the other objects are
    /// applied. The client should then request a keyframe until needs_keyframe() is false.
    Status apply(const v1::Snapshot& snapshot);
    /// Whether an object waits for a state without a baseline.
    bool needs_keyframe() const { return !broken_.empty(); }

    /// Samples all objects that have points; see PointObjectView::sample().
    std::vector<SmoothPoints> sample(double tick, double tick_hz);

    /// By id.
    std::map<std::uint32_t, PointObjectView>& objects() { return objects_; }
    const std::map<std::uint32_t, PointObjectView>& objects() const { return objects_; }

private:
    Status add(const v1::PointObject& description);
    Status update(const v1::PointUpdate& update);
    std::size_t stored_points() const;

    std::vector<v1::ChannelKind> kinds_;
    std::map<std::uint32_t, PointObjectView> objects_;
    std::set<std::uint32_t> broken_;
};

}  // namespace jostle::client
