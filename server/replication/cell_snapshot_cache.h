// SPDX-License-Identifier: MIT
//
// What clients of one world are sent who see a part of it: its cells (cell_grid.h). A cell's state
// has the tick in which it last changed as its number. Each state is encoded once against each set
// of earlier ones, and shared by all clients and both transports. Any thread.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "server/replication/cell_grid.h"
#include "server/replication/snapshot_cache.h"

namespace jostle::server {

struct CellState {
    CellId id = everywhere;
    std::uint32_t number = 0;   // the tick in which it became so
    std::uint32_t members = 0;  // the tick in which somebody came or went last
    std::shared_ptr<const wire::QuantizedFrame> content;
    std::uint32_t crc = 0;
};

// A cell as it is put on the wire.
struct EncodedCell {
    CellId id = everywhere;
    std::uint32_t number = 0;
    wire::BaselineFrames baselines;
    std::vector<std::byte> packed;
    std::uint32_t crc = 0;
};

class CellSnapshotCache {
public:
    using Serialize = std::function<std::string(const EncodedCell&)>;
    static constexpr std::size_t states_retained = 32;  // of a cell, as bases
    static constexpr std::uint32_t empty_ticks = 256;

    CellSnapshotCache(double interest_cell_m, const wire::QuantSpec& spec, Serialize serialize);

    // In rising order of id. One that became empty stays for `empty_ticks`.
    using Cells = std::shared_ptr<const std::vector<CellState>>;
    // The cells of a frame; of the newest one that was asked for, when it is newer.
    // `quantized` is asked only for a new frame.
    Cells cells(const FramePtr& frame, const std::function<wire::QuantizedFrame()>& quantized);
    // Bases that are gone are left out. Never null.
    SharedBytes encoding(const CellState& state, wire::BaselineFrames baselines, wire::Codec codec);

    // m from a point of the ground to a cell.
    double distance(CellId cell, double x_m, double z_m) const {
        return grid_.distance(cell, x_m, z_m);
    }
    double interest_cell_m() const { return grid_.interest_cell_m(); }

private:
    struct History {
        std::deque<CellState> states;  // oldest first
        // Of the newest state.
        std::map<std::tuple<wire::BaselineFrames, wire::Codec>, SharedBytes> encodings;
    };
    void add(CellId cell, wire::QuantizedFrame content, std::uint32_t tick);
    const wire::QuantizedFrame* find(const History& history, std::uint32_t number) const;
    SharedBytes encode(const History& history, const CellState& state,
                       wire::BaselineFrames baselines, wire::Codec codec) const;

    const wire::QuantSpec spec_;
    const Serialize serialize_;
    std::mutex mutex_;
    CellGrid grid_;
    std::uint32_t tick_ = 0;
    std::map<CellId, History> histories_;
    Cells cells_ = std::make_shared<const std::vector<CellState>>();
};

}  // namespace jostle::server
