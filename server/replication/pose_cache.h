// SPDX-License-Identifier: MIT
//
// The snapshots and the cells of one world in one precision. Clients with the same precision share
// them. Any thread.
#pragma once

#include <compare>
#include <memory>

#include "jostle/snapshot/precision.h"
#include "server/replication/cell_snapshot_cache.h"
#include "server/replication/snapshot_cache.h"

namespace jostle::server {

// The precision of a stream.
struct StreamPrecision {
    snapshot::Precision near;
    double far_factor = 1;  // coarser by this factor in cells beyond half of the radius of interest

    // The precision of distant cells.
    snapshot::Precision far() const {
        return {near.position_m * far_factor, near.rotation_rad * far_factor};
    }
    auto operator<=>(const StreamPrecision&) const = default;
};

inline constexpr double far_factor_max = 1000;

// Checks the values of a setting; `prefix` precedes their names in the error, such as
// "hello.precision.". A far factor of 0 stands for 1.
Status check(const StreamPrecision& precision, const char* prefix);
// The precision that the server grants: rounded down, so that few different ones are in use.
StreamPrecision granted(const StreamPrecision& requested);

class PoseCache {
public:
    PoseCache(const StreamPrecision& precision, double interest_cell_m,
              SnapshotCache::Serialize serialize_snapshot,
              CellSnapshotCache::Serialize serialize_cell);

    const StreamPrecision& precision() const { return precision_; }
    SnapshotCache& snapshots() { return snapshots_; }
    const SnapshotCache& snapshots() const { return snapshots_; }
    CellSnapshotCache& cells() { return cells_; }
    // The cells of a frame, or of a newer one.
    CellSnapshotCache::Cells cells_of(const FramePtr& frame);

private:
    const StreamPrecision precision_;
    SnapshotCache snapshots_;
    std::unique_ptr<SnapshotCache> far_;  // null: distant cells have the same precision
    CellSnapshotCache cells_;
};

}  // namespace jostle::server
