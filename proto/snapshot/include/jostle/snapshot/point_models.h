// SPDX-License-Identifier: MIT
//
// The models of point objects, against which their bits are coded. Every state starts from
// start_point_models(), so states do not depend on each other. The order of the fields below is the
// order of WIRE.md, "Points".
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "jostle/snapshot/range_numbers.h"

namespace jostle::snapshot {

struct PointModels {
    /// Classes of the expected magnitude of a residual, two per octave.
    static constexpr std::size_t classes = 24;

    BitModel gone[2];  ///< a loose point disappeared; the index: so did the one before it
    CountModels born, born_gap;
    BitModel born_last;  ///< all new points follow the others
    MagnitudeModels size[classes];
    TailModels tail[classes];
};

inline constexpr std::size_t point_model_count = sizeof(PointModels) / sizeof(BitModel);

inline std::span<BitModel> all_of(PointModels& models) {
    return {reinterpret_cast<BitModel*>(&models), point_model_count};
}

const PointModels& start_point_models();

/// One letter per model, as in start_models.h. Written by bench/points_bench.cpp.
extern const std::string_view start_point_model_letters;

}  // namespace jostle::snapshot
