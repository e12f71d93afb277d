// SPDX-License-Identifier: MIT
//
// Codec 2: the prediction of codec 1, with the residuals in an adaptive range coder. Only
// frame_codec.h calls it, after checking the quantization and the spacing.
#pragma once

#include "jostle/snapshot/entity_diff.h"

namespace jostle::snapshot {

std::vector<std::byte> encode_range_frame(const EntityDiff& to, const Baselines& baselines,
                                          const Spacing& t, const QuantSpec& spec);

Result<std::vector<EntityState>> decode_range_frame(std::span<const std::byte> packed,
                                                    const Baselines& baselines, const Spacing& t,
                                                    const QuantSpec& spec,
                                                    std::size_t max_entities);

}  // namespace jostle::snapshot
