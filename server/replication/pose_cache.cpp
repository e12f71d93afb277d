// SPDX-License-Identifier: MIT
#include "server/replication/pose_cache.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

Status check(const StreamPrecision& precision, const char* prefix) {
    if (Status s = snapshot::check(precision.near, prefix); !s.ok()) return s;
    if (precision.far_factor == 0 ||
        (precision.far_factor >= 1 && precision.far_factor <= far_factor_max))
        return {};
    return Error{ErrorCode::invalid_argument,
                 fmt::format("{}far_factor is {:g}; it must be 0 or from 1 to {:g}", prefix,
                             precision.far_factor, far_factor_max)};
}

StreamPrecision granted(const StreamPrecision& requested) {
    if (!requested.near.is_set()) return {};
    StreamPrecision precision{snapshot::rounded_down(requested.near), 1};
    // The far precision is rounded as well.
    if (requested.far_factor > 1)
        precision.far_factor =
            snapshot::rounded_down(snapshot::Precision{requested.far_factor, 0}).position_m;
    return precision;
}

PoseCache::PoseCache(const StreamPrecision& precision, double interest_cell_m,
                     SnapshotCache::Serialize serialize_snapshot,
                     CellSnapshotCache::Serialize serialize_cell)
    : precision_(precision),
      snapshots_(snapshot::quant_spec_for(precision.near), std::move(serialize_snapshot),
                 precision.near),
      cells_(interest_cell_m, snapshots_.spec(), std::move(serialize_cell)) {
    ASSERT(precision.far_factor >= 1);
    // Poses of distant cells have the units of the near ones: a stream has one QuantSpec.
    if (precision.near.is_set() && precision.far_factor > 1)
        far_ = std::make_unique<SnapshotCache>(
            snapshots_.spec(), [](const EncodedSnapshot&) { return std::string(); },
            precision.far());
}

CellSnapshotCache::Cells PoseCache::cells_of(const FramePtr& frame) {
    if (!far_) return cells_.cells(frame, [&] { return snapshots_.quantized(frame); });
    return cells_.cells(
        frame, [&] { return snapshots_.quantized(frame); }, [&] { return far_->quantized(frame); });
}

}  // namespace jostle::server
