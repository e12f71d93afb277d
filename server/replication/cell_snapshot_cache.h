// SPDX-License-Identifier: MIT
//
// Snapshots of interest cells (cell_grid.h) for clients that see part of a world. The number of a
// cell state is the tick of its last change. Each state is encoded once per set of baselines, and
// shared by all clients and both transports. Any thread.
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
    bool far = false;           // in the precision of distant cells
    std::uint32_t number = 0;   // tick of the last change
    std::uint32_t members = 0;  // tick of the last entity that entered or left
    std::shared_ptr<const snapshot::QuantizedFrame> content;
    std::uint32_t crc = 0;
};

// A cell as sent.
struct EncodedCell {
    CellId id = everywhere;
    std::uint32_t number = 0;
    snapshot::BaselineFrames baselines;
    std::vector<std::byte> packed;
    std::uint32_t crc = 0;
};

class CellSnapshotCache {
public:
    using Serialize = std::function<std::string(const EncodedCell&)>;
    static constexpr std::size_t states_retained = 32;  // baselines per cell
    static constexpr std::uint32_t empty_ticks = 256;

    CellSnapshotCache(double interest_cell_m, const snapshot::QuantSpec& spec, Serialize serialize);

    // In ascending order of id. An empty cell is retained for `empty_ticks`.
    struct CellLevels {
        CellState near;
        // The same entities in the precision of distant cells; without one equal to `near`.
        CellState far;
    };
    using Cells = std::shared_ptr<const std::vector<CellLevels>>;
    using Quantize = std::function<snapshot::QuantizedFrame()>;
    // The cells of a frame, or of the newest frame requested so far if that is newer. `near` and
    // `far` return the poses of the frame in both precisions; they are called only for a new frame.
    // Without `far` all cells have the same precision; either all calls have it or none.
    Cells cells(const FramePtr& frame, const Quantize& near, const Quantize& far = {});
    struct Encoding {
        SharedBytes bytes;         // never null
        bool is_keyframe = false;  // no baseline is stored any more
    };
    // Baselines that are no longer stored are omitted.
    Encoding encoding(const CellState& state, snapshot::BaselineFrames baselines,
                      snapshot::Codec codec);

    // Distance in m from a point on the ground to a cell.
    double distance(CellId cell, double x_m, double z_m) const {
        return grid_.distance(cell, x_m, z_m);
    }
    double interest_cell_m() const { return grid_.interest_cell_m(); }

private:
    struct History {
        std::deque<CellState> states;  // oldest first
        // Encodings of the newest state.
        std::map<std::tuple<snapshot::BaselineFrames, snapshot::Codec>, Encoding> encodings;
    };
    using Histories = std::map<CellId, History>;
    Histories& histories(bool far) { return far ? far_histories_ : histories_; }
    void add(CellId cell, bool far, snapshot::QuantizedFrame content, std::uint32_t tick);
    const snapshot::QuantizedFrame* find(const History& history, std::uint32_t number) const;
    Encoding encode(const History& history, const CellState& state,
                    snapshot::BaselineFrames baselines, snapshot::Codec codec) const;

    const snapshot::QuantSpec spec_;
    const Serialize serialize_;
    std::mutex mutex_;
    CellGrid grid_;
    std::uint32_t tick_ = 0;
    Histories histories_, far_histories_;  // far_histories_: empty, or of the same cells
    Cells cells_ = std::make_shared<const std::vector<CellLevels>>();
};

}  // namespace jostle::server
