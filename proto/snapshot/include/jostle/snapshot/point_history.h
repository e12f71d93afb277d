// SPDX-License-Identifier: MIT
//
// The received states of one point object (WIRE.md, "Points"): baselines of later states, and
// points to render. The update stream is ordered, so each state has the one before it as its
// baseline. One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>

#include "jostle/base/result.h"
#include "jostle/snapshot/point_codec.h"

namespace jostle::snapshot {

class PointHistory {
public:
    /// Stored states. The last three are baselines; the others are for rendering.
    static constexpr std::size_t states_max = 8;
    /// Baselines of a state.
    static constexpr std::size_t baselines_max = 3;

    /// Returns corrupt_data if the layout is invalid.
    static Result<PointHistory> create(PointLayout layout);

    struct Entry {
        DecodedPoints points;
        std::uint32_t tick = 0;  ///< in which the object had this state
    };
    /// Adds a state. `back`: the number of the state minus that of its baseline, plus 1; 0: it has
    /// no baseline; 1: it is the newest stored state with more levels, which it replaces.
    ///
    /// Returns failed_precondition if the newest stored state is not the baseline, and corrupt_data
    /// if the bytes are malformed or do not match the CRC. Nothing changes then.
    Status add(std::uint32_t number, std::uint32_t tick, std::uint32_t back,
               std::span<const std::byte> bytes, std::uint32_t crc);

    /// Decodes a state as add() does, without the CRC, and adds nothing.
    Result<DecodedPoints> read(std::uint32_t number, std::uint32_t back,
                               std::span<const std::byte> bytes) const;

    const PointLayout& layout() const { return layout_; }
    /// The oldest state first. PointState::previous of each refers to the one before it.
    const std::deque<Entry>& states() const { return states_; }

private:
    explicit PointHistory(PointLayout layout);
    PointBaselines baselines(bool refines) const;
    void refine(Entry entry);

    PointLayout layout_;
    PointOrder order_;
    std::deque<Entry> states_;
    std::size_t usable_ = 0;  ///< newest states that can be baselines
};

}  // namespace jostle::snapshot
