// SPDX-License-Identifier: MIT
//
// What a client that sees a part of its world knows of it: the last states of each cell, put
// together to one frame (proto/WIRE.md, "Cells"). One thread at a time.
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
    static constexpr std::size_t history_max = 32;  // states of a cell, as bases of later ones

    // The cells of a snapshot. An error leaves everything as it was.
    Status apply(const v1::Snapshot& snapshot, const wire::QuantSpec& spec, wire::Codec codec);
    // All entities that are in sight, in rising order of id: of one that is in two cells, on its
    // way from one to the other, the newer.
    wire::QuantizedFrame frame(std::uint32_t number) const;
    // The same for a picture: a cell that is told with some snapshots only moves on evenly from one
    // telling to the next, and is shown so much later. `tick_us`: of a tick of the world.
    wire::QuantizedFrame rendered_frame(std::uint32_t number, const wire::QuantSpec& spec,
                                        double tick_us) const;
    void clear() { cells_.clear(); }

private:
    using States = std::deque<wire::QuantizedFrame>;  // rising, at most `kept`
    Result<wire::QuantizedFrame> decode(const v1::CellUpdate& part, const wire::QuantSpec& spec,
                                        wire::Codec codec) const;

    // How far on the way from the state before to the newest one a picture is.
    double progress(const States& states, std::uint32_t number) const;

    std::map<std::uint32_t, States> cells_;
    std::uint32_t newest_ = 0, step_ = 1;  // snapshots: the last one, and ticks from the one before
};

}  // namespace jostle::client
