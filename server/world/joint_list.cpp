// SPDX-License-Identifier: MIT
#include "server/world/joint_list.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

bool has_shape(const physics::JointKind& kind) {
    return !std::holds_alternative<physics::GrabJoint>(kind) &&
           !std::holds_alternative<physics::VelocityRow>(kind);
}

}  // namespace

const std::shared_ptr<const JointList>& JointRegistry::list(const physics::World& world,
                                                            const FindEntity& find_entity) {
    if (list_ && revision_ == world.joint_revision()) return list_;
    revision_ = world.joint_revision();
    std::map<physics::JointId, std::shared_ptr<const JointDescription>> known;
    for (const physics::JointId id : world.joints()) {
        if (const auto at = known_.find(id); at != known_.end()) {
            known.insert(*at);
            continue;
        }
        physics::JointDef def = world.joint(id)->def;
        if (!has_shape(def.kind)) continue;
        const bool of_world = is_null(def.body_a);
        const EntityId a = of_world ? 0 : find_entity(def.body_a), b = find_entity(def.body_b);
        if (b == 0 || (a == 0 && !of_world)) continue;
        known.emplace(id, std::make_shared<const JointDescription>(
                              JointDescription{next_id_++, a, b, std::move(def)}));
    }
    const bool same = list_ && known.size() == known_.size() &&
                      std::ranges::equal(known, known_, {}, &decltype(known)::value_type::second,
                                         &decltype(known)::value_type::second);
    known_ = std::move(known);
    if (same) return list_;
    auto list = std::make_shared<JointList>();
    list->reserve(known_.size());
    for (const auto& [id, joint] : known_) list->push_back(joint);
    std::ranges::sort(*list, {}, [](const auto& joint) { return joint->id; });
    ASSERT(std::ranges::all_of(*list, [](const auto& joint) { return joint->entity_b != 0; }));
    list_ = std::move(list);
    return list_;
}

}  // namespace jostle::server
