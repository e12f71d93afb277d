// SPDX-License-Identifier: MIT
#include "jostle/snapshot/frame_codec.h"

#include "jostle/snapshot/bit_frame.h"
#include "jostle/snapshot/crc32.h"
#include "jostle/snapshot/entity_diff.h"
#include "jostle/snapshot/range_frame.h"

namespace jostle::snapshot {
namespace {

constexpr std::int64_t max_spacing = 255;  // ticks between a frame and its baseline

bool in_range(const Spacing& t) {
    const auto good = [](std::int64_t dt) { return dt >= 1 && dt <= max_spacing; };
    return good(t.dt1) && good(t.dt2) && good(t.dt3);
}

// The server chooses the quantization, so a client checks it: shifts, divisions and int16 rely on
// it.
bool usable(const QuantSpec& spec) {
    return spec.units_per_meter >= 1 && spec.units_per_meter <= max_units_per_meter &&
           spec.rotation_component >= 1 && spec.rotation_component <= max_rotation_component;
}

}  // namespace

std::vector<std::byte> encode_frame(const QuantizedFrame& frame, const Baselines& baselines,
                                    const QuantSpec& spec, Codec codec,
                                    std::span<const UnchangedRun> unchanged) {
    const EntityDiff to = unchanged.empty() ? entity_diff(frame, baselines)
                                            : entity_diff(frame, baselines, unchanged);
    const Spacing t = spacing_of(frame.frame, baselines);
    return codec == Codec::range ? encode_range_frame(to, baselines, t, spec)
                                 : encode_bit_frame(to, t, spec);
}

Result<QuantizedFrame> decode_frame(std::uint32_t frame_number, std::span<const std::byte> packed,
                                    const Baselines& baselines, const QuantSpec& spec,
                                    std::size_t max_entities, Codec codec) {
    if (!usable(spec))
        return corrupt("quantization out of range: " + std::to_string(spec.units_per_meter) +
                       " units per metre (must be 1 to " + std::to_string(max_units_per_meter) +
                       "), rotation component " + std::to_string(spec.rotation_component) +
                       " (must be 1 to " + std::to_string(max_rotation_component) + ")");
    if (codec != Codec::bits && codec != Codec::range)
        return corrupt("unknown codec " + std::to_string(static_cast<std::uint32_t>(codec)) +
                       "; must be 1 or 2");
    const Spacing t = spacing_of(frame_number, baselines);
    if (!in_range(t))
        return corrupt("frame " + std::to_string(frame_number) +
                       " must be 1 to 255 ticks after its baselines");
    Result<std::vector<EntityState>> entities =
        codec == Codec::range ? decode_range_frame(packed, baselines, t, spec, max_entities)
                              : decode_bit_frame(packed, baselines, t, spec, max_entities);
    if (!entities.ok()) return entities.error();
    return QuantizedFrame{.frame = frame_number, .entities = std::move(*entities)};
}

namespace {

std::uint32_t crc_over(std::uint32_t state, std::span<const EntityState> entities) {
    const auto half = [](auto value) { return std::uint64_t{static_cast<std::uint16_t>(value)}; };
    const auto word = [](auto value) { return std::uint64_t{static_cast<std::uint32_t>(value)}; };
    for (const EntityState& e : entities) {
        state = crc32_update(state, word(e.id) | word(e.position[0]) << 32);
        state = crc32_update(state, word(e.position[1]) | word(e.position[2]) << 32);
        state = crc32_update(state, std::uint64_t{e.largest} | half(e.rotation[0]) << 8 |
                                        half(e.rotation[1]) << 24 | half(e.rotation[2]) << 40 |
                                        std::uint64_t{e.at_rest ? 1u : 0u} << 56);
    }
    return state;
}

}  // namespace

std::uint32_t frame_crc(const QuantizedFrame& frame) {
    return ~crc_over(crc32_initial, frame.entities);
}

std::uint32_t block_crc(std::span<const EntityState> block) {
    return crc_over(0, block);
}

std::uint32_t frame_crc(const QuantizedFrame& frame, std::span<const std::uint32_t> blocks) {
    static const Crc32Zeros over_block(crc_block * 24);
    std::uint32_t state = crc32_initial;
    for (const std::uint32_t block : blocks) state = over_block(state) ^ block;
    return ~crc_over(state, std::span(frame.entities).subspan(blocks.size() * crc_block));
}

}  // namespace jostle::snapshot
