// SPDX-License-Identifier: MIT
#include "server/world/pose_list.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

PoseList::PoseList(const std::vector<EntityPose>& poses) : size_(poses.size()) {
    for (std::size_t from = 0; from < poses.size(); from += block_size) {
        const auto first = poses.begin() + static_cast<std::ptrdiff_t>(from);
        const std::size_t count = std::min(block_size, poses.size() - from);
        blocks_.push_back(
            std::make_shared<const Block>(first, first + static_cast<std::ptrdiff_t>(count)));
    }
}

void PoseEditor::assign(const std::vector<EntityPose>& poses) {
    list_ = PoseList(poses);
    open_.assign(list_.blocks_.size(), nullptr);
    changed_ = true;
}

void PoseEditor::set(std::size_t index, const physics::Transform& pose, bool awake) {
    ASSERT(open_.size() == list_.blocks_.size());
    const EntityPose& old = list_[index];
    if (old.awake == awake && old.pose == pose) return;
    const std::size_t block = index / PoseList::block_size;
    if (!open_[block]) {
        open_[block] = std::make_shared<PoseList::Block>(*list_.blocks_[block]);
        list_.blocks_[block] = open_[block];
    }
    EntityPose& now = (*open_[block])[index % PoseList::block_size];
    now.pose = pose;
    now.awake = awake;
    changed_ = true;
}

const PoseList& PoseEditor::take(bool& changed) {
    changed = changed_;
    changed_ = false;
    if (changed) std::fill(open_.begin(), open_.end(), nullptr);
    return list_;
}

}  // namespace jostle::server
