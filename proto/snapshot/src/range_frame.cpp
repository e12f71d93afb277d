// SPDX-License-Identifier: MIT
#include "jostle/snapshot/range_frame.h"

#include "jostle/snapshot/range_frame_serializer.h"

namespace jostle::snapshot {

std::vector<std::byte> encode_range_frame(const EntityDiff& to, const Baselines& baselines,
                                          const Spacing& t, const QuantSpec& spec) {
    FrameModels models = start_models(t.dt1);
    RangeEncoder out;
    RangeFrameSerializer walk(out, models, spec);
    EntityChanges lists = entity_changes_of(to);
    walk.entities(lists, baselines, to.surviving.size() + to.spawned.size());
    std::vector<EntityState> none;
    walk.survivors(to.surviving, none, to.survivors, t, to.unchanged_after);
    return out.finish();
}

Result<std::vector<EntityState>> decode_range_frame(std::span<const std::byte> packed,
                                                    const Baselines& baselines, const Spacing& t,
                                                    const QuantSpec& spec,
                                                    std::size_t max_entities) {
    FrameModels models = start_models(t.dt1);
    RangeDecoder in(packed);
    RangeFrameSerializer walk(in, models, spec);
    const auto at = [&](const std::string& what) {
        return corrupt(what + " (at byte " + std::to_string(in.byte_position()) + ")");
    };
    EntityChanges lists;
    if (!walk.entities(lists, baselines, max_entities)) return at(walk.fault());
    const std::vector<Survivor> survivors = find_survivors(baselines, lists.removed);
    if (survivors.size() > max_entities) return at("the number of entities exceeds the limit");
    std::vector<EntityState> surviving;
    surviving.reserve(survivors.size());
    if (!walk.survivors({}, surviving, survivors, t)) return at(walk.fault());
    if (in.past_end()) return at("truncated data");
    if (!in.at_clean_end()) return at("unexpected bytes at the end");
    return merge_entities(std::move(surviving), lists.spawned);
}

}  // namespace jostle::snapshot
