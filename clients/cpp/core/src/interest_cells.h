// SPDX-License-Identifier: MIT
//
// The state of the area of interest: the last states of each cell, merged into one frame
// (proto/WIRE.md, "Cells"). One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>

#include "jostle/base/result.h"
#include "jostle/snapshot/frame_codec.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

class InterestCells {
public:
    static constexpr std::size_t history_max = 32;  // states per cell, as baselines of later ones

    // Applies the cells of a snapshot. An error leaves the state unchanged.
    Status apply(const v1::Snapshot& snapshot, const snapshot::QuantSpec& spec,
                 snapshot::Codec codec);
    // All entities of the area of interest, sorted by id. An entity in two cells, while it moves
    // from one to the other, has the newer state.
    snapshot::QuantizedFrame frame(std::uint32_t number) const;
    // Like frame(), for rendering: entities of a cell with a lower update rate are interpolated
    // between its updates and delayed accordingly. `tick_us`: tick interval.
    snapshot::QuantizedFrame rendered_frame(std::uint32_t number, const snapshot::QuantSpec& spec,
                                            double tick_us) const;
    void clear() { cells_.clear(); }

private:
    using States = std::deque<snapshot::QuantizedFrame>;  // ascending; at most history_max
    Result<snapshot::QuantizedFrame> decode(const v1::CellUpdate& part,
                                            const snapshot::QuantSpec& spec,
                                            snapshot::Codec codec) const;

    // The fraction of the interval from the previous state to the newest one that is rendered.
    double progress(const States& states, std::uint32_t number) const;

    std::map<std::uint32_t, States> cells_;
    // the last snapshot, and the number of ticks since the previous one
    std::uint32_t newest_ = 0, step_ = 1;
};

}  // namespace jostle::client
