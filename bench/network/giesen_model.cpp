// SPDX-License-Identifier: MIT
#include "bench/network/giesen_model.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>

namespace jostle::bench {
namespace {

constexpr std::uint32_t certain = 1u << 15;  // probabilities have 15 bits

// A 32-bit interval that narrows with each bit; bytes are emitted when both ends agree on them.
class IntervalEncoder {
public:
    void bit(bool value, std::uint32_t one) {
        const std::uint32_t middle =
            low_ + static_cast<std::uint32_t>(std::uint64_t{high_ - low_} * one >> 15);
        if (value)
            high_ = middle;
        else
            low_ = middle + 1;
        while ((low_ ^ high_) < 1u << 24) {
            put();
            high_ = high_ << 8 | 0xff;
        }
    }
    // Emits the shortest number in the interval; trailing zeros are omitted.
    std::vector<std::byte> finish() {
        for (std::uint32_t low_bits = 0xffffff; low_bits != 0; low_bits >>= 8) {
            const std::uint64_t rounded =
                (std::uint64_t{low_} + low_bits) & ~std::uint64_t{low_bits};
            if (rounded > high_) continue;
            low_ = static_cast<std::uint32_t>(rounded);
            break;
        }
        while (low_ != 0) put();
        return std::move(bytes_);
    }

private:
    void put() {
        bytes_.push_back(static_cast<std::byte>(low_ >> 24));
        low_ <<= 8;
    }

    std::vector<std::byte> bytes_;
    std::uint32_t low_ = 0, high_ = 0xffffffffu;
};

// The mean of two probabilities that adapt by 1/8 and by 1/128 of the difference.
struct TwoSpeeds {
    std::uint16_t quick = certain / 4, slow = certain / 4;

    void code(IntervalEncoder& out, bool bit) {
        out.bit(bit, std::uint32_t{quick} + slow);
        const auto learn = [bit](std::uint16_t& p, int shift) {
            const std::uint32_t step = bit ? (certain / 2 - p) >> shift : std::uint32_t{p} >> shift;
            p = static_cast<std::uint16_t>(bit ? p + step : p - step);
        };
        learn(quick, 3);
        learn(slow, 7);
    }
};

// A number of `bits` bits; the model of each bit depends on the bits before it.
template <unsigned bits>
struct Tree {
    std::array<TwoSpeeds, (1u << bits)> models;

    void code(IntervalEncoder& out, std::uint32_t value) {
        std::uint32_t context = 1;
        for (unsigned k = bits; k-- > 0;) {
            const bool bit = (value >> k & 1) != 0;
            models[context].code(out, bit);
            context = context * 2 + (bit ? 1 : 0);
        }
    }
};

// Codes the width of magnitude + 1, the bit below its leading one, the remaining bits raw, then the
// sign.
struct Difference {
    Tree<5> width;
    std::array<TwoSpeeds, 8> second;
    std::array<TwoSpeeds, 2> sign;

    void code(IntervalEncoder& out, std::int64_t value, bool expect_negative) {
        const auto x = static_cast<std::uint32_t>(std::abs(value) + 1);
        const auto wide = static_cast<unsigned>(std::bit_width(x)) - 1;
        width.code(out, wide);
        for (unsigned k = wide; k-- > 0;) {
            const bool bit = (x >> k & 1) != 0;
            if (k + 1 == wide)
                second[std::min(wide, 7u)].code(out, bit);
            else
                out.bit(bit, certain / 2);
        }
        if (value != 0) sign[expect_negative ? 1 : 0].code(out, value < 0);
    }
};

constexpr std::size_t magnitudes = 10;

std::size_t magnitude_class(std::int64_t step) {
    const auto size = static_cast<std::uint64_t>(std::abs(step)) | 1;
    return std::min(static_cast<std::size_t>(std::bit_width(size)) - 1, magnitudes - 1);
}

struct Models {
    std::array<TwoSpeeds, 4> turned;
    std::array<Tree<2>, 16> largest;
    std::array<Difference, magnitudes + 1> turn;
    std::array<TwoSpeeds, 2> flipped;
    std::array<TwoSpeeds, 8> moved;
    std::array<Difference, magnitudes> step;
    std::array<TwoSpeeds, 4> awake;
};

// Change of a cube from the base to the frame.
struct Motion {
    bool changing = false;
    std::array<std::int64_t, 3> turn{}, step{};
};

}  // namespace

struct GiesenCoder::State {
    Models models;
    std::vector<Motion> motions;
};

namespace {

// The omitted component, and whether the largest remaining component is close to its size.
std::size_t largest_context(const snapshot::EntityState& baseline, std::int32_t m) {
    std::size_t second = 0;
    for (std::size_t k = 1; k < 3; k++)
        if (std::abs(baseline.rotation[k]) > std::abs(baseline.rotation[second])) second = k;
    const bool near = std::abs(baseline.rotation[second]) >= (m + 1) / 2;
    return baseline.largest + (near ? 4 * (second + 1) : 0);
}

bool are_near(const snapshot::EntityState& a, const snapshot::EntityState& b) {
    for (std::size_t k = 0; k < 3; k++)
        if (std::abs(std::int64_t{a.position[k]} - b.position[k]) >= 2048) return false;
    return true;
}

class CubeCoder {
public:
    CubeCoder(IntervalEncoder& out, Models& models, std::int32_t m)
        : out_(out), models_(models), m_(m) {}

    Motion code(const snapshot::EntityState& now, const snapshot::EntityState& baseline,
                const Motion& before, bool near_player) {
        Motion motion;
        bool turned = now.largest != baseline.largest, moved = false;
        for (std::size_t k = 0; k < 3; k++) {
            motion.turn[k] = now.rotation[k] - baseline.rotation[k];
            motion.step[k] = std::int64_t{now.position[k]} - baseline.position[k];
            turned = turned || motion.turn[k] != 0;
            moved = moved || motion.step[k] != 0;
        }
        motion.changing = turned || moved;
        const std::size_t context = (before.changing ? 1 : 0) + (near_player ? 2 : 0);
        models_.turned[context].code(out_, turned);
        if (turned) rotation(now, baseline, motion, before);
        models_.moved[(turned ? 1 : 0) + 2 * context].code(out_, moved);
        if (moved)
            for (std::size_t k = 0; k < 3; k++)
                models_.step[magnitude_class(before.step[k])].code(
                    out_, motion.step[k] - before.step[k], before.step[k] < 0);
        models_.awake[(baseline.at_rest ? 0 : 1) + (motion.changing ? 2 : 0)].code(out_,
                                                                                   !now.at_rest);
        return motion;
    }

private:
    void rotation(const snapshot::EntityState& now, const snapshot::EntityState& baseline,
                  const Motion& motion, const Motion& before) {
        models_.largest[largest_context(baseline, m_)].code(out_, now.largest);
        if (now.largest != baseline.largest) return other_largest(now, baseline, before);
        for (std::size_t k = 0; k < 3; k++)
            models_.turn[magnitude_class(before.turn[k])].code(out_, motion.turn[k],
                                                               before.turn[k] < 0);
    }

    // Codes the rotation relative to the base's quaternion, converted to the new largest component;
    // the base's largest component is estimated and the sign flipped if necessary.
    void other_largest(const snapshot::EntityState& now, const snapshot::EntityState& baseline,
                       const Motion& before) {
        std::array<std::int64_t, 4> old{}, turn{};
        for (std::size_t axis = 0, k = 0; axis < 4; axis++) {
            if (axis == baseline.largest) continue;
            turn[axis] = before.turn[k];
            old[axis] = baseline.rotation[k++];
        }
        old[baseline.largest] = (m_ + 1) * 97 / 128;
        const std::size_t of_old = baseline.largest - (baseline.largest > now.largest ? 1 : 0);
        const bool flipped = now.rotation[of_old] < 0;
        models_.flipped[old[now.largest] < 0 ? 1 : 0].code(out_, flipped);
        for (std::size_t axis = 0, k = 0; axis < 4; axis++) {
            if (axis == now.largest) continue;
            const bool known = axis != baseline.largest;
            models_.turn[known ? magnitude_class(turn[axis]) : magnitudes].code(
                out_, now.rotation[k++] - (flipped ? -old[axis] : old[axis]),
                (known && turn[axis] < 0) != flipped);
        }
    }

    IntervalEncoder& out_;
    Models& models_;
    std::int32_t m_;
};

}  // namespace

GiesenCoder::Coded GiesenCoder::encode(const snapshot::QuantizedFrame& now,
                                       const snapshot::QuantizedFrame& baseline,
                                       const StatePtr& baseline_state) const {
    auto state =
        baseline_state ? std::make_shared<State>(*baseline_state) : std::make_shared<State>();
    state->motions.resize(now.entities.size());
    IntervalEncoder out;
    CubeCoder cubes(out, state->models, m_);
    for (std::size_t i = 0; i < now.entities.size(); i++)
        state->motions[i] = cubes.code(now.entities[i], baseline.entities[i], state->motions[i],
                                       are_near(baseline.entities[i], baseline.entities[player_]));
    return {.bytes = out.finish(), .state = std::move(state)};
}

}  // namespace jostle::bench
