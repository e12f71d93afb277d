// SPDX-License-Identifier: MIT
//
// Codec 2: the prediction of codec 1, and what is left of it in an adaptive range coder. Called by
// frame_codec.h alone, which has checked the quantisation and the spacing.
#pragma once

#include "jostle/snapshot/entity_diff.h"

namespace jostle::wire {

std::vector<std::byte> encode_range_frame(const EntityDiff& to, const Baselines& baselines,
                                          const Spacing& t, const QuantSpec& spec);

Result<std::vector<EntityState>> decode_range_frame(std::span<const std::byte> packed,
                                                    const Baselines& baselines, const Spacing& t,
                                                    const QuantSpec& spec,
                                                    std::size_t max_entities);

}  // namespace jostle::wire
