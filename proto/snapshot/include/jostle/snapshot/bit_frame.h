// SPDX-License-Identifier: MIT
//
// Codec 1: fixed Rice and exponential Golomb codes. Fast to encode and to decode. Only
// frame_codec.h calls it, after checking the quantization and the spacing.
#pragma once

#include "jostle/snapshot/entity_diff.h"

namespace jostle::snapshot {

std::vector<std::byte> encode_bit_frame(const EntityDiff& to, const Spacing& t,
                                        const QuantSpec& spec);

Result<std::vector<EntityState>> decode_bit_frame(std::span<const std::byte> packed,
                                                  const Baselines& baselines, const Spacing& t,
                                                  const QuantSpec& spec, std::size_t max_entities);

}  // namespace jostle::snapshot
