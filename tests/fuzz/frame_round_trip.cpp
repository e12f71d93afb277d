// SPDX-License-Identifier: MIT
//
// Any frames that a server may have, however wild the motion: what was encoded is decoded again.
#include <algorithm>
#include <limits>

#include "jostle/snapshot/quantize.h"
#include "tests/fuzz/frames.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using snapshot::EntityState;

constexpr std::size_t entities_max = 64;

// A small step mostly, so that the short codes are used; else any place.
std::int32_t moved(std::int32_t from, std::uint8_t how, Reader& in) {
    if (how % 4 == 0) return from;
    if (how % 4 == 3) return in.number<std::int32_t>();
    const std::int64_t step = in.number<std::int8_t>();
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(from + step, std::numeric_limits<std::int32_t>::min(),
                                 std::numeric_limits<std::int32_t>::max()));
}

// As quantize() makes them, from any numbers.
void turn(EntityState& state, Reader& in, const snapshot::QuantSpec& spec) {
    snapshot::Pose pose;
    for (double& q : pose.rotation) q = in.number<std::int16_t>();
    const EntityState turned = snapshot::quantize(state.id, pose, false, spec);
    state.largest = turned.largest;
    state.rotation = turned.rotation;
}

void change(EntityState& state, std::uint8_t how, Reader& in, const snapshot::QuantSpec& spec) {
    for (std::int32_t& p : state.position) p = moved(p, how, in);
    if ((how & 4) != 0) turn(state, in, spec);
    state.at_rest = (how & 8) != 0;
}

// The frame after `before`: entities stay, move, go and come as the bytes say.
std::vector<EntityState> next(const std::vector<EntityState>& before, Reader& in,
                              const snapshot::QuantSpec& spec) {
    std::vector<EntityState> after;
    for (EntityState state : before) {
        const auto how = in.number<std::uint8_t>();
        if (how >= 0xf0) continue;
        change(state, how, in, spec);
        after.push_back(state);
    }
    for (int fresh = in.number<std::uint8_t>() % 4; fresh > 0; fresh--) {
        if (after.size() >= entities_max) break;
        EntityState state;
        state.id = 1 + in.number<std::uint16_t>() % 500;
        if (in.number<std::uint8_t>() % 8 == 0) state.id = std::max(1u, in.number<std::uint32_t>());
        const auto at = std::ranges::lower_bound(after, state.id, {}, &EntityState::id);
        // An id of the frame before names what it named there.
        if ((at != after.end() && at->id == state.id) ||
            std::ranges::binary_search(before, state.id, {}, &EntityState::id))
            continue;
        change(state, 7, in, spec);
        after.insert(at, state);
    }
    return after;
}

}  // namespace

void run(Bytes input) {
    Reader in(input);
    snapshot::QuantSpec spec = take_spec(in);
    spec.units_per_meter = std::clamp(spec.units_per_meter, 1, snapshot::max_units_per_meter);
    spec.rotation_component =
        std::clamp(spec.rotation_component, 1, snapshot::max_rotation_component);
    FrameRing ring;
    std::vector<EntityState> entities;
    for (std::uint32_t number = 1; !in.done() && number < 64; number++) {
        const auto choice = in.number<std::uint8_t>();
        entities = next(entities, in, spec);
        const snapshot::QuantizedFrame frame{.frame = number, .entities = entities};
        const snapshot::Baselines baselines = ring.baselines(choice);
        const snapshot::Codec codec = codec_of(choice);
        const auto packed = snapshot::encode_frame(frame, baselines, spec, codec);
        const auto decoded = snapshot::decode_frame(number, packed, baselines, spec,
                                                    snapshot::default_entities_max, codec);
        expect(decoded.ok(),
               decoded.ok() ? "" : "what was encoded is refused: " + decoded.error().message);
        expect(*decoded == frame, "what was encoded is decoded");
        ring.add(frame);
    }
}

}  // namespace jostle::fuzz
