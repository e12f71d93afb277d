// SPDX-License-Identifier: MIT
#include "jostle/snapshot/entity_diff.h"

#include <algorithm>
#include <utility>

#include "jostle/snapshot/bit_stream.h"

namespace jostle::snapshot {

std::vector<Survivor> find_survivors(const Baselines& baselines,
                                     const std::vector<std::size_t>& removed) {
    if (!baselines.baseline) return {};
    const std::vector<EntityState>& baseline = baselines.baseline->entities;
    std::vector<Survivor> survivors(baseline.size() - removed.size());
    EntityFinder in_base2(baselines.baseline2),
        in_base3(baselines.baseline2 ? baselines.baseline3 : nullptr);
    std::size_t next_removed = 0, next = 0;
    for (std::size_t i = 0; i < baseline.size(); i++) {
        if (next_removed < removed.size() && removed[next_removed] == i) {
            next_removed++;
            continue;
        }
        Survivor& s = survivors[next++];
        s.baseline = &baseline[i];
        if (s.baseline->at_rest) continue;
        s.baseline2 = in_base2.find(s.baseline->id);
        if (s.baseline2) s.baseline3 = in_base3.find(s.baseline->id);
    }
    return survivors;
}

Spacing spacing_of(std::uint32_t frame, const Baselines& baselines) {
    Spacing t;
    if (baselines.baseline) t.dt1 = std::int64_t{frame} - baselines.baseline->frame;
    if (baselines.baseline2)
        t.dt2 = std::int64_t{baselines.baseline->frame} - baselines.baseline2->frame;
    if (baselines.baseline2 && baselines.baseline3)
        t.dt3 = std::int64_t{baselines.baseline2->frame} - baselines.baseline3->frame;
    return t;
}

EntityDiff entity_diff(const QuantizedFrame& frame, const Baselines& baselines) {
    EntityDiff to;
    static const std::vector<EntityState> nobody;
    const std::vector<EntityState>&baseline =
              baselines.baseline ? baselines.baseline->entities : nobody,
          &now = frame.entities;
    to.surviving.resize(std::min(baseline.size(), now.size()));
    std::size_t i = 0, k = 0, surviving = 0;
    while (i < baseline.size() && k < now.size()) {
        if (baseline[i].id == now[k].id) {
            to.surviving[surviving++] = &now[k++];
            i++;
        } else if (baseline[i].id < now[k].id) {
            to.removed.push_back(i++);
        } else {
            to.spawned.push_back(&now[k++]);
        }
    }
    while (i < baseline.size()) to.removed.push_back(i++);
    while (k < now.size()) to.spawned.push_back(&now[k++]);
    to.surviving.resize(surviving);
    to.survivors = find_survivors(baselines, to.removed);
    return to;
}

EntityDiff entity_diff(const QuantizedFrame& frame, const Baselines& baselines,
                       std::span<const UnchangedRun> unchanged) {
    EntityDiff to;
    EntityFinder in_base2(baselines.baseline2),
        in_base3(baselines.baseline2 ? baselines.baseline3 : nullptr);
    std::size_t at = 0, left_out = 0;
    const auto look_until = [&](std::size_t end) {
        for (; at < end; at++) {
            Survivor s{.baseline = &baselines.baseline->entities[at],
                       .unchanged_before = std::exchange(left_out, 0)};
            if (!s.baseline->at_rest) s.baseline2 = in_base2.find(s.baseline->id);
            if (s.baseline2) s.baseline3 = in_base3.find(s.baseline->id);
            to.surviving.push_back(&frame.entities[at]);
            to.survivors.push_back(s);
        }
    };
    for (const UnchangedRun& run : unchanged) {
        look_until(run.begin);
        left_out += run.end - run.begin;
        at = run.end;
    }
    look_until(frame.entities.size());
    to.unchanged_after = left_out;
    return to;
}

std::vector<EntityState> merge_entities(std::vector<EntityState> surviving,
                                        const std::vector<EntityState>& spawned) {
    if (spawned.empty()) return surviving;
    std::vector<EntityState> all(surviving.size() + spawned.size());
    std::merge(surviving.begin(), surviving.end(), spawned.begin(), spawned.end(), all.begin(),
               [](const EntityState& a, const EntityState& b) { return a.id < b.id; });
    return all;
}

unsigned component_bits(const QuantSpec& spec) {
    return bit_width(static_cast<std::uint64_t>(spec.rotation_component)) + 1;
}

bool is_rotation(const std::array<std::int64_t, 3>& components, const QuantSpec& spec) {
    const std::int64_t m = spec.rotation_component;
    std::int64_t sum = 0;
    for (const std::int64_t c : components) {
        if (c < -m || c > m) return false;
        sum += c * c;
    }
    return sum <= 2 * m * m;
}

}  // namespace jostle::snapshot
