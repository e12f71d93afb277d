// SPDX-License-Identifier: MIT
//
// Writer and reader traverse the same list of survivors (entities of the baseline that are still
// present) with the same helpers; only the writer knows the new state.
#include "jostle/snapshot/bit_frame.h"

#include <algorithm>

#include "jostle/snapshot/bit_stream.h"
#include "jostle/snapshot/entity_diff.h"

namespace jostle::snapshot {
namespace {

constexpr unsigned gap_order = 4;        // between ids, positions in a list
constexpr unsigned unchanged_order = 5;  // runs of unchanged entities
constexpr unsigned position_order = 12;  // absolute positions

// Returns whether the pose is predicted to stay the same.
bool is_unchanged(const Survivor& s) {
    return s.baseline->at_rest || !s.baseline2 ||
           (same_pose(*s.baseline, *s.baseline2) &&
            (!s.baseline3 || same_pose(*s.baseline, *s.baseline3)));
}

// Rice parameters, from the recent change of the motion.
struct Widths {
    unsigned position, rotation;
    bool rotation_may_be_exact;  // a bit says whether it is
};

Widths widths_of(const Survivor& s, const Prediction& p, const Spacing& t) {
    static constexpr std::uint8_t for_position[12] = {0, 0, 0, 1, 2, 2, 3, 3, 4, 5, 6, 7};
    static constexpr std::uint8_t for_rotation[12] = {0, 0, 0, 1, 2, 3, 4, 4, 5, 6, 7, 8};
    std::int64_t position = p.position_change, rotation = p.rotation_change;
    // With little or no history the change is meaningless; assume a few units per tick.
    if (is_unchanged(s) || !s.baseline3 || same_pose(*s.baseline, *s.baseline2)) {
        position = std::max(position, 4 * t.dt1);
        rotation = std::max(rotation, 4 * t.dt1);
    }
    const auto clamp = [](std::int64_t change) {
        return std::min(bit_width(static_cast<std::uint64_t>(change)), 11u);
    };
    return {for_position[clamp(position)], for_rotation[clamp(rotation)], rotation == 0};
}

// ---- writing ----

void write_components(BitWriter& out, const EntityState& state, const QuantSpec& spec) {
    out.bits(state.largest, 2);
    for (const std::int16_t component : state.rotation)
        out.bits(static_cast<std::uint64_t>(component), component_bits(spec));
}

void write_pose(BitWriter& out, const EntityState& now, const Survivor& s, const Spacing& t,
                const QuantSpec& spec) {
    const Prediction p = predict(*s.baseline, s.baseline2, s.baseline3, t, spec);
    const Widths widths = widths_of(s, p, t);
    for (std::size_t k = 0; k < 3; k++)
        out.rice(zig_zag_encode(now.position[k] - p.position[k]), widths.position);

    std::array<std::uint64_t, 3> residual{};
    for (std::size_t k = 0; k < 3; k++)
        residual[k] = zig_zag_encode(now.rotation[k] - p.components[k]);
    const bool same_largest = now.largest == p.largest;
    if (widths.rotation_may_be_exact) {
        const bool exact = same_largest && residual == std::array<std::uint64_t, 3>{};
        out.bits(exact ? 1 : 0, 1);
        if (exact) return;
    }
    if (!same_largest || residual[0] >> widths.rotation >= rice_escape) {
        out.bits((1u << rice_escape) - 1, rice_escape);
        write_components(out, now, spec);
        return;
    }
    for (const std::uint64_t r : residual) out.rice(r, widths.rotation);
}

void write_removed(BitWriter& out, const std::vector<std::size_t>& removed) {
    out.exp_golomb(removed.size(), 0);
    std::size_t next = 0;
    for (const std::size_t position : removed) {
        out.exp_golomb(position - next, gap_order);
        next = position + 1;
    }
}

void write_spawned(BitWriter& out, const std::vector<const EntityState*>& spawned,
                   const QuantSpec& spec) {
    out.exp_golomb(spawned.size(), 0);
    std::uint32_t next_id = 1;
    for (const EntityState* state : spawned) {
        out.exp_golomb(state->id - next_id, gap_order);
        for (const std::int32_t p : state->position)
            out.exp_golomb(zig_zag_encode(p), position_order);
        write_components(out, *state, spec);
        out.bits(state->at_rest ? 1 : 0, 1);
        next_id = state->id + 1;
    }
}

void write_survivors(BitWriter& out, const EntityDiff& to, const Spacing& t,
                     const QuantSpec& spec) {
    const std::vector<Survivor>& survivors = to.survivors;
    const std::vector<const EntityState*>& now = to.surviving;
    // Number of unchanged entities from `from` on, before the first one whose pose changes.
    const auto run_of_unchanged = [&](std::size_t from) {
        std::uint64_t run = 0;
        for (std::size_t i = from; i < survivors.size(); i++) {
            run += survivors[i].unchanged_before;
            if (!is_unchanged(survivors[i])) continue;
            if (!same_pose(*now[i], *survivors[i].baseline)) return run;
            run++;
        }
        return run + to.unchanged_after;
    };
    std::vector<std::size_t> toggles;
    std::uint64_t run = run_of_unchanged(0);
    out.exp_golomb(run, unchanged_order);
    std::size_t position = 0;
    for (std::size_t i = 0; i < survivors.size(); i++, position++) {
        const Survivor& s = survivors[i];
        position += s.unchanged_before;
        run -= s.unchanged_before;
        const bool unchanged = is_unchanged(s);
        bool changed;
        if (unchanged) {
            changed = run == 0;
            if (!changed) run--;
        } else {
            changed = !same_pose(*now[i], *s.baseline);
            out.bits(changed ? 1 : 0, 1);
        }
        if (now[i]->at_rest != (changed ? false : s.baseline->at_rest)) toggles.push_back(position);
        if (!changed) continue;
        write_pose(out, *now[i], s, t, spec);
        if (unchanged) {
            run = run_of_unchanged(i + 1);
            out.exp_golomb(run, unchanged_order);
        }
    }
    write_removed(out, toggles);  // also a list of positions
}

// ---- reading ----

class BitFrameReader {
public:
    BitFrameReader(std::span<const std::byte> packed, const QuantSpec& spec)
        : in_(packed), spec_(spec) {}

    Result<std::vector<EntityState>> decode(const Baselines& baselines, const Spacing& t,
                                            std::size_t max_entities) {
        std::vector<std::size_t> removed;
        const std::size_t in_baseline =
            baselines.baseline ? baselines.baseline->entities.size() : 0;
        if (!read_positions(removed, in_baseline, "removed")) return corrupt(error_);
        const std::vector<Survivor> survivors = find_survivors(baselines, removed);
        std::vector<EntityState> spawned;
        if (survivors.size() > max_entities ||
            !read_spawned(spawned, baselines, max_entities - survivors.size()))
            return corrupt(error_.empty() ? "the number of entities exceeds the limit" : error_);
        std::vector<EntityState> surviving;
        if (!read_survivors(surviving, survivors, t)) return corrupt(error_);
        if (!in_.at_clean_end()) return corrupt(at("unexpected or missing bits at the end"));
        return merge_entities(surviving, spawned);
    }

private:
    std::string at(const std::string& what) const {
        return what + " (at bit " + std::to_string(in_.bit_position()) + ")";
    }
    bool fail(const std::string& what) {
        if (error_.empty()) error_ = at(what);
        return false;
    }
    bool ended() { return in_.past_end() && !fail("truncated data"); }

    // Reads ascending positions in a list of `size`.
    bool read_positions(std::vector<std::size_t>& positions, std::size_t size, const char* what) {
        const std::uint64_t count = in_.exp_golomb(0);
        if (ended()) return false;
        if (count > size) return fail(std::string(what) + ": count exceeds the list");
        std::uint64_t next = 0;
        for (std::uint64_t i = 0; i < count; i++) {
            const std::uint64_t position = next + in_.exp_golomb(gap_order);
            if (ended()) return false;
            if (position >= size) return fail(std::string(what) + ": position past the end");
            positions.push_back(static_cast<std::size_t>(position));
            next = position + 1;
        }
        return true;
    }

    bool read_components(EntityState& state) {
        const unsigned bits = component_bits(spec_);
        state.largest = static_cast<std::uint8_t>(in_.bits(2));
        for (std::int16_t& component : state.rotation) {
            const std::uint64_t raw = in_.bits(bits);
            const std::int64_t sign = std::int64_t{1} << (bits - 1);
            component = static_cast<std::int16_t>((static_cast<std::int64_t>(raw) ^ sign) - sign);
        }
        return is_rotation({state.rotation[0], state.rotation[1], state.rotation[2]}, spec_) ||
               fail("invalid rotation");
    }

    bool read_spawned(std::vector<EntityState>& spawned, const Baselines& baselines,
                      std::size_t limit) {
        const std::uint64_t count = in_.exp_golomb(0);
        if (ended()) return false;
        if (count > limit) return fail("spawned: the number of entities exceeds the limit");
        std::uint64_t next_id = 1;
        EntityFinder in_baseline(baselines.baseline);
        for (std::uint64_t i = 0; i < count; i++) {
            const std::uint64_t id = next_id + in_.exp_golomb(gap_order);
            if (id > 0xffffffffull) return fail("spawned: id exceeds 32 bits");
            EntityState state{.id = static_cast<std::uint32_t>(id)};
            for (std::int32_t& p : state.position) {
                const std::int64_t v = zig_zag_decode(in_.exp_golomb(position_order));
                if (!is_position(v)) return fail("spawned: position out of range");
                p = static_cast<std::int32_t>(v);
            }
            if (!read_components(state)) return false;
            state.at_rest = in_.bits(1) != 0;
            if (ended()) return false;
            if (in_baseline.find(state.id)) return fail("spawned: id exists in the baseline");
            spawned.push_back(state);
            next_id = id + 1;
        }
        return true;
    }

    bool read_pose(EntityState& state, const Survivor& s, const Spacing& t) {
        const Prediction p = predict(*s.baseline, s.baseline2, s.baseline3, t, spec_);
        const Widths widths = widths_of(s, p, t);
        for (std::size_t k = 0; k < 3; k++) {
            const std::int64_t v = p.position[k] + zig_zag_decode(in_.rice(widths.position));
            if (!is_position(v)) return fail("position out of range");
            state.position[k] = static_cast<std::int32_t>(v);
        }
        std::array<std::int64_t, 3> r = p.components;
        if (!(widths.rotation_may_be_exact && in_.bits(1) != 0)) {
            if (in_.take_escape()) return read_components(state) && !ended();
            for (std::int64_t& c : r) c += zig_zag_decode(in_.rice(widths.rotation));
        }
        if (ended()) return false;
        if (!is_rotation(r, spec_)) return fail("invalid rotation");
        state.largest = p.largest;
        for (std::size_t k = 0; k < 3; k++) state.rotation[k] = static_cast<std::int16_t>(r[k]);
        return true;
    }

    bool read_survivors(std::vector<EntityState>& surviving, const std::vector<Survivor>& survivors,
                        const Spacing& t) {
        surviving.reserve(survivors.size());
        std::uint64_t run = in_.exp_golomb(unchanged_order);
        for (const Survivor& s : survivors) {
            EntityState state = *s.baseline;
            const bool unchanged = is_unchanged(s);
            bool changed;
            if (unchanged) {
                changed = run == 0;
                if (!changed) run--;
            } else {
                changed = in_.bits(1) != 0;
            }
            if (changed) {
                if (!read_pose(state, s, t)) return false;
                state.at_rest = false;
                if (unchanged) run = in_.exp_golomb(unchanged_order);
            }
            if (ended()) return false;
            surviving.push_back(state);
        }
        if (run != 0) return fail("run of unchanged entities exceeds the frame");
        std::vector<std::size_t> toggles;
        if (!read_positions(toggles, surviving.size(), "rest toggles")) return false;
        for (const std::size_t i : toggles) surviving[i].at_rest = !surviving[i].at_rest;
        return true;
    }

    BitReader in_;
    const QuantSpec& spec_;
    std::string error_;
};

}  // namespace

std::vector<std::byte> encode_bit_frame(const EntityDiff& to, const Spacing& t,
                                        const QuantSpec& spec) {
    BitWriter out;
    write_removed(out, to.removed);
    write_spawned(out, to.spawned, spec);
    write_survivors(out, to, t, spec);
    return out.finish();
}

Result<std::vector<EntityState>> decode_bit_frame(std::span<const std::byte> packed,
                                                  const Baselines& baselines, const Spacing& t,
                                                  const QuantSpec& spec, std::size_t max_entities) {
    return BitFrameReader(packed, spec).decode(baselines, t, max_entities);
}

}  // namespace jostle::snapshot
