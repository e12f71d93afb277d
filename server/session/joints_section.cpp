// SPDX-License-Identifier: MIT
#include "server/session/joints_section.h"

namespace jostle::server {

void JointsSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    if (pending_.empty() && frame->joint_list && frame->joint_list != list_) {
        const auto fields = broadcast_.joint_list_change(list_, frame->joint_list);
        pending_.assign(fields->begin(), fields->end());
        list_ = frame->joint_list;
    }
    if (pending_.empty()) return;
    parts.shared_fields.push_back(pending_.front());
    pending_.pop_front();
}

}  // namespace jostle::server
