// SPDX-License-Identifier: MIT
//
// The traversal of a frame by codec 2, shared by encoder and decoder. The Coder codes each bit with
// its model and returns the coded bit. Only the codec itself and the program that trains the
// initial models include this header.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "jostle/snapshot/bit_stream.h"
#include "jostle/snapshot/entity_diff.h"
#include "jostle/snapshot/frame_models.h"

namespace jostle::snapshot {

/// Removed and spawned entities: input of an encoder, output of a decoder.
struct EntityChanges {
    std::vector<std::size_t> removed;  ///< ascending positions in the baseline
    std::vector<EntityState> spawned;
};

inline EntityChanges entity_changes_of(const EntityDiff& to) {
    EntityChanges lists{.removed = to.removed, .spawned = {}};
    lists.spawned.reserve(to.spawned.size());
    for (const EntityState* state : to.spawned) lists.spawned.push_back(*state);
    return lists;
}

template <class Coder>
class RangeFrameSerializer {
public:
    RangeFrameSerializer(Coder& coder, FrameModels& models, const QuantSpec& spec)
        : coder_(coder), models_(models), spec_(spec) {}

    /// Codes the removed and the spawned entities. Returns false if a decoder found an error; see
    /// fault().
    bool entities(EntityChanges& lists, const Baselines& baselines, std::size_t max_entities) {
        const bool any =
            coder_.bit(models_.changes_entities, !lists.removed.empty() || !lists.spawned.empty());
        if (!any) return true;
        const std::size_t in_baseline =
            baselines.baseline ? baselines.baseline->entities.size() : 0;
        if (!removed(lists.removed, in_baseline)) return false;
        const std::size_t survive = in_baseline - lists.removed.size();
        if (survive > max_entities) return fail("the number of entities exceeds the limit");
        return spawned(lists.spawned, baselines, max_entities - survive);
    }

    /// Codes the state of each survivor. An encoder reads `surviving`, a decoder appends to
    /// `states`.
    bool survivors(const std::vector<const EntityState*>& surviving,
                   std::vector<EntityState>& states, const std::vector<Survivor>& survivors,
                   const Spacing& t, std::size_t unchanged_after = 0) {
        unchanged_after_ = unchanged_after;
        std::size_t resting = unchanged_after;
        for (const Survivor& s : survivors)
            resting += s.unchanged_before + (s.baseline->at_rest ? 1 : 0);
        std::uint64_t run = 0;
        if (!resting_run(run, surviving, survivors, 0, resting)) return false;
        for (std::size_t i = 0; i < survivors.size(); i++) {
            const Survivor& s = survivors[i];
            resting -= s.unchanged_before;
            run -= s.unchanged_before;
            const bool rested = s.baseline->at_rest;
            if (rested) resting--;
            if (rested && run > 0) {
                run--;
                if constexpr (!Coder::encoding) states.push_back(*s.baseline);
                continue;
            }
            EntityState state = Coder::encoding ? *surviving[i] : *s.baseline;
            if (!(rested ? pose_of_woken(state, s, t) : awake(state, s, t))) return false;
            if constexpr (!Coder::encoding) states.push_back(state);
            if (rested && !resting_run(run, surviving, survivors, i + 1, resting)) return false;
        }
        return true;
    }

    const std::string& fault() const { return fault_; }

private:
    // How an entity that is awake in the baseline moved in the previous steps.
    enum PriorMotion : std::size_t { motionless, moving, stopped };

    static PriorMotion prior_motion_of(const Survivor& s) {
        if (!s.baseline2 || s.baseline2->at_rest || !same_pose(*s.baseline, *s.baseline2))
            return moving;
        return s.baseline3 && same_pose(*s.baseline, *s.baseline3) ? motionless : stopped;
    }

    bool fail(const char* what) {
        if (fault_.empty()) fault_ = what;
        return false;
    }
    bool ended() {
        if constexpr (Coder::encoding)
            return false;
        else
            return coder_.past_end() && !fail("truncated data");
    }

    std::uint64_t count(CountModels& m, std::uint64_t value) {
        return code_count(coder_, m, value);
    }
    std::int64_t number(MagnitudeModels& m, TailModels& tail, std::int64_t value) {
        return code_number(coder_, m, tail, value);
    }

    // ---- removed and spawned entities ----

    bool removed(std::vector<std::size_t>& positions, std::size_t size) {
        const std::uint64_t total = count(models_.removed, positions.size());
        if (total > size) return fail("removed: count exceeds the baseline");
        positions.resize(static_cast<std::size_t>(total));
        std::uint64_t next = 0;
        for (std::size_t& position : positions) {
            const std::uint64_t coded = next + count(models_.removed_gap, position - next);
            if (coded >= size) return fail("removed: position past the end");
            position = static_cast<std::size_t>(coded);
            next = coded + 1;
        }
        return !ended();
    }

    bool spawned(std::vector<EntityState>& states, const Baselines& baselines, std::size_t limit) {
        const std::uint64_t total = count(models_.spawned, states.size());
        if (total > limit) return fail("spawned: the number of entities exceeds the limit");
        EntityFinder in_baseline(baselines.baseline);
        EntityState before;
        for (std::uint64_t i = 0; i < total; i++) {
            if (!Coder::encoding) states.emplace_back();
            EntityState& state = states[static_cast<std::size_t>(i)];
            if (!spawned_entity(state, before) || ended()) return false;
            if (in_baseline.find(state.id)) return fail("spawned: id exists in the baseline");
            before = state;
        }
        return true;
    }

    // Coded as the difference from the previously spawned entity: neighbours in the list are often
    // created together.
    bool spawned_entity(EntityState& state, const EntityState& before) {
        const std::uint64_t id =
            std::uint64_t{before.id} + 1 + count(models_.id_gap, state.id - before.id - 1);
        if (id > 0xffffffffull) return fail("spawned: id exceeds 32 bits");
        state.id = static_cast<std::uint32_t>(id);
        for (std::size_t k = 0; k < 3; k++) {
            const std::int64_t step = std::int64_t{state.position[k]} - before.position[k];
            auto size = static_cast<std::int64_t>(count(
                models_.position_step[k], static_cast<std::uint64_t>(step < 0 ? -step : step)));
            if (size != 0 && coder_.bit(models_.position_negative, step < 0)) size = -size;
            if (!is_position(before.position[k] + size))
                return fail("spawned: position out of range");
            state.position[k] = static_cast<std::int32_t>(before.position[k] + size);
        }
        const bool same = state.largest == before.largest && state.rotation == before.rotation;
        if (coder_.bit(models_.turned, !same)) {
            if (!components(state)) return false;
        } else {
            state.largest = before.largest;
            state.rotation = before.rotation;
        }
        state.at_rest = coder_.bit(models_.spawned_at_rest, state.at_rest);
        return true;
    }

    bool components(EntityState& state) {
        state.largest = static_cast<std::uint8_t>(coder_.raw(state.largest, 2));
        const unsigned bits = component_bits(spec_);
        const std::int64_t sign = std::int64_t{1} << (bits - 1);
        std::array<std::int64_t, 3> r{};
        for (std::size_t k = 0; k < 3; k++)
            r[k] = static_cast<std::int64_t>(
                       coder_.raw(static_cast<std::uint64_t>(state.rotation[k] + sign), bits)) -
                   sign;
        return rotation(state, r);
    }

    bool rotation(EntityState& state, const std::array<std::int64_t, 3>& r) {
        if constexpr (Coder::encoding) return true;
        if (!is_rotation(r, spec_)) return fail("invalid rotation");
        for (std::size_t k = 0; k < 3; k++) state.rotation[k] = static_cast<std::int16_t>(r[k]);
        return true;
    }

    // ---- survivors ----

    // Codes the number of entities at rest, from survivor `from` on, that do not change before the
    // next one that does; `left` are left.
    bool resting_run(std::uint64_t& run, const std::vector<const EntityState*>& surviving,
                     const std::vector<Survivor>& survivors, std::size_t from, std::size_t left) {
        run = left;
        if (left == 0) return true;
        if constexpr (Coder::encoding) {
            run = unchanged_after_;
            std::uint64_t so_far = 0;
            for (std::size_t i = from; i < survivors.size(); i++) {
                so_far += survivors[i].unchanged_before;
                if (!survivors[i].baseline->at_rest) continue;
                if (!surviving[i]->at_rest || !same_pose(*surviving[i], *survivors[i].baseline)) {
                    run = 0;
                    break;
                }
                so_far++;
            }
            run += so_far;
        }
        const bool none = coder_.bit(models_.none_wake, run == left);
        run = none ? left : count(models_.resting_run, run);
        if (!none && run >= left) return fail("run of resting entities exceeds the frame");
        return !ended();
    }

    // For an entity at rest in the baseline that woke or moved.
    bool pose_of_woken(EntityState& state, const Survivor& s, const Spacing& t) {
        state.at_rest = coder_.bit(models_.stays_at_rest, state.at_rest);
        return pose(state, s, t);
    }

    bool awake(EntityState& state, const Survivor& s, const Spacing& t) {
        const PriorMotion prior_motion = prior_motion_of(s);
        const bool changed =
            coder_.bit(models_.changes[prior_motion], !same_pose(state, *s.baseline));
        state.at_rest =
            coder_.bit(models_.falls_asleep[prior_motion][changed ? 1 : 0], state.at_rest);
        return !changed || pose(state, s, t);
    }

    static std::size_t width_of(std::int64_t v, unsigned most) {
        return std::min(bit_width(static_cast<std::uint64_t>(v < 0 ? -v : v)), most);
    }
    // Classes: -4 and below, -3 and -2, -1, 0, 1, 2 and 3, 4 and above.
    static std::size_t signed_class(std::int64_t v) {
        if (v < 0) return v <= -4 ? 0 : v <= -2 ? 1 : 2;
        return v >= 4 ? 6 : v >= 2 ? 5 : v == 1 ? 4 : 3;
    }
    static std::size_t size_class(std::int64_t v) { return v == 0 ? 0 : v <= 3 ? 1 : 2; }
    static std::int64_t size_of(std::int64_t v) { return v < 0 ? -v : v; }
    // Residuals are coded along the direction of motion, or else of the acceleration.
    static bool backwards(std::int64_t step, std::int64_t acceleration) {
        return step != 0 ? step < 0 : acceleration < 0;
    }

    bool pose(EntityState& state, const Survivor& s, const Spacing& t) {
        const Prediction p = predict(*s.baseline, s.baseline2, s.baseline3, t, spec_);
        std::int64_t off = 0;  // sum of the coded magnitudes
        for (std::size_t k = 0; k < 3; k++) {
            const std::int64_t acceleration = p.position_acceleration[k];
            const bool back = backwards(p.position_step[k], acceleration);
            const std::size_t step = width_of(p.position_step[k], 3);
            MagnitudeModels& m =
                models_.position[step][k == 1 ? 1 : 0]
                                [signed_class(back ? -acceleration : acceleration)]
                                [size_class(p.position_change - size_of(acceleration))]
                                [k == 0 ? 0 : 1 + width_of(off, 4) / 2];
            const std::int64_t error = state.position[k] - p.position[k];
            const std::int64_t coded =
                number(m, models_.position_tail[step], back ? -error : error);
            const std::int64_t v = p.position[k] + (back ? -coded : coded);
            if (!is_position(v)) return fail("position out of range");
            state.position[k] = static_cast<std::int32_t>(v);
            off += size_of(coded);
        }
        return turn(state, p, off != 0) && !ended();
    }

    bool turn(EntityState& state, const Prediction& p, bool moved_off) {
        largest(state, p);
        // Components in the order for the coded largest component.
        std::array<std::int64_t, 3> r{}, step{}, acceleration{};
        const std::int64_t sign = p.rotation[state.largest] < 0 ? -1 : 1;
        std::int64_t change = 0;
        for (std::size_t k = 0; k < 3; k++) {
            const std::size_t from = others[state.largest][k];
            r[k] = sign * p.rotation[from];
            step[k] = sign * p.rotation_step[from];
            acceleration[k] = sign * p.rotation_acceleration[from];
            change += size_of(acceleration[k]);
        }
        std::int64_t off = 0;
        for (std::size_t k = 0; k < 3; k++) {
            const bool back = backwards(step[k], acceleration[k]);
            const std::size_t width = width_of(step[k], 3);
            MagnitudeModels& m =
                models_.rotation[width][signed_class(back ? -acceleration[k] : acceleration[k])]
                                [size_class(change - size_of(acceleration[k]))]
                                [k == 0 ? moved_off : 2 + width_of(off, 2)];
            const std::int64_t error = state.rotation[k] - r[k];
            const std::int64_t coded =
                number(m, models_.rotation_tail[width], back ? -error : error);
            r[k] += back ? -coded : coded;
            off += size_of(coded);
        }
        return rotation(state, r);
    }

    // Codes the index of the omitted component. It usually is the predicted one; the likelihood
    // decreases with its lead over the others.
    void largest(EntityState& state, const Prediction& p) {
        std::int64_t second = 0;
        for (std::size_t k = 0; k < 4; k++)
            if (k != p.largest) second = std::max(second, size_of(p.rotation[k]));
        const std::size_t lead = width_of(size_of(p.rotation[p.largest]) - second, 15) / 4;
        if (coder_.bit(models_.same_largest[lead], state.largest == p.largest)) {
            state.largest = p.largest;
            return;
        }
        const unsigned offset = (state.largest - p.largest - 1u) & 3;  // 0, 1 or 2
        unsigned coded = 2;
        if (!coder_.bit(models_.other_largest[0], offset == 2))
            coded = coder_.bit(models_.other_largest[1], offset == 1) ? 1 : 0;
        state.largest = static_cast<std::uint8_t>((p.largest + 1 + coded) & 3);
    }

    Coder& coder_;
    FrameModels& models_;
    const QuantSpec spec_;
    std::string fault_;
    std::size_t unchanged_after_ = 0;  // EntityDiff::unchanged_after
};

}  // namespace jostle::snapshot
