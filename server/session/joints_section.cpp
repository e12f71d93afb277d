// SPDX-License-Identifier: MIT
#include "server/session/joints_section.h"

#include <algorithm>
#include <utility>

namespace jostle::server {

void JointsSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    if (!change_ && frame->joint_list && frame->joint_list != list_) {
        change_ = broadcast_.joint_list_change(list_, frame->joint_list);
        next_field_ = 0;
        list_ = frame->joint_list;
    }
    if (!change_) return;
    auto [bytes, is_last] = change_->field(next_field_++);
    if (bytes) parts.shared_fields.push_back(std::move(bytes));
    if (is_last) change_ = nullptr;
}

void KnownJointsSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    JointUpdateWriter writer;
    if (frame->joint_list && frame->joint_list != list_) {
        if (list_)
            remove_missing(*frame->joint_list, writer);
        else
            writer.set_complete();
        list_ = frame->joint_list;
        scanned_ = 0;
    }
    if (known_revision_ != cells_.known_revision()) {
        known_revision_ = cells_.known_revision();
        scanned_ = 0;
    }
    if (scanning()) add_known(writer);
    cells_.view().spend(writer.bytes(), false);
    if (const SharedBytes field = writer.take()) parts.fields += *field;
}

void KnownJointsSection::remove_missing(const JointList& list, JointUpdateWriter& writer) {
    const auto id_of = [](const auto& joint) { return joint->id; };
    std::erase_if(sent_, [&](std::uint32_t id) {
        if (std::ranges::binary_search(list, id, {}, id_of)) return false;
        writer.remove(id);
        return true;
    });
}

void KnownJointsSection::add_known(JointUpdateWriter& writer) {
    const std::size_t end = std::min(list_->size(), scanned_ + examined_per_snapshot_max);
    for (; scanned_ < end; scanned_++) {
        const JointDescription& joint = *(*list_)[scanned_];
        if (!cells_.is_known(joint.entity_b) ||
            (joint.entity_a != 0 && !cells_.is_known(joint.entity_a)) || sent_.contains(joint.id))
            continue;
        if (writer.is_full() || !cells_.view().affords(writer.bytes(), false)) return;
        writer.add(joint);
        sent_.insert(joint.id);
    }
}

}  // namespace jostle::server
