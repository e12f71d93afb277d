// SPDX-License-Identifier: MIT
#include "server/world/joint_list.h"

#include <algorithm>
#include <iterator>
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

bool JointRegistry::forget(Slot& slot) {
    const bool listed = slot.description != nullptr;
    slot = {};
    return listed;
}

bool JointRegistry::assign(Slot& slot, physics::JointId joint) {
    if (slot.id != 0 && slot.generation == joint.generation) return false;
    const bool removed = forget(slot);
    slot.generation = joint.generation;
    return removed;
}

std::uint32_t JointRegistry::id_of(physics::JointId joint) {
    ASSERT(!is_null(joint));
    if (slots_.size() <= joint.index) slots_.resize(joint.index + 1);
    Slot& slot = slots_[joint.index];
    // An earlier joint of the slot stays in list_ until the next call of list().
    if (assign(slot, joint)) has_removed_ = true;
    if (slot.id == 0) slot.id = next_id_++;
    return slot.id;
}

physics::JointId JointRegistry::find(std::uint32_t id) const {
    if (id == 0) return {};
    const auto at = std::ranges::find(slots_, id, &Slot::id);
    if (at == slots_.end()) return {};
    return {static_cast<std::uint32_t>(at - slots_.begin()), at->generation};
}

const std::shared_ptr<const JointList>& JointRegistry::list(const physics::World& world,
                                                            const FindEntity& find_entity) {
    if (list_ && !incomplete_ && revision_ == world.joint_revision()) return list_;
    revision_ = world.joint_revision();
    incomplete_ = false;
    bool removed = std::exchange(has_removed_, false);
    std::size_t described = 0, next_slot = 0;
    JointList added;
    for (const physics::JointId id : world.joints()) {  // in ascending order of index
        if (slots_.size() <= id.index) slots_.resize(id.index + 1);
        for (; next_slot < id.index; next_slot++) removed |= forget(slots_[next_slot]);
        Slot& slot = slots_[next_slot++];
        removed |= assign(slot, id);
        if (slot.known) continue;
        if (described == described_per_call_max) {
            incomplete_ = true;
            continue;
        }
        described++;
        const std::uint32_t number = id_of(id);
        slot.known = true;
        physics::JointDef def = world.joint(id)->def;
        if (!has_shape(def.kind)) continue;
        const bool of_world = is_null(def.body_a);
        const EntityId a = of_world ? 0 : find_entity(def.body_a), b = find_entity(def.body_b);
        if (b == 0 || (a == 0 && !of_world)) continue;
        added.push_back(std::make_shared<const JointDescription>(
            JointDescription{number, a, b, std::move(def), id}));
        slot.description = added.back().get();
    }
    for (; next_slot < slots_.size(); next_slot++) removed |= forget(slots_[next_slot]);
    if (list_ && !removed && added.empty()) return list_;
    auto list = std::make_shared<JointList>();
    list->reserve((list_ ? list_->size() : 0) + added.size());
    if (list_) {
        std::ranges::copy_if(*list_, std::back_inserter(*list), [this](const auto& known) {
            return slots_[known->joint.index].description == known.get();
        });
    }
    // Ids that id_of() assigned may be lower than those in the list.
    const auto id_of_joint = [](const auto& joint) { return joint->id; };
    std::ranges::sort(added, {}, id_of_joint);
    const auto middle = static_cast<std::ptrdiff_t>(list->size());
    list->insert(list->end(), added.begin(), added.end());
    std::ranges::inplace_merge(*list, list->begin() + middle, {}, id_of_joint);
    list_ = std::move(list);
    return list_;
}

}  // namespace jostle::server
