// SPDX-License-Identifier: MIT
#include "jostle/client/joint_list.h"

#include <string>
#include <utility>
#include <vector>

namespace jostle::client {

namespace {

Error corrupt(const v1::JointInfo& joint, const std::string& reason) {
    return {ErrorCode::corrupt_data, "joint " + std::to_string(joint.id()) + ": " + reason};
}

Status check(const v1::JointInfo& joint, int forms) {
    if (joint.id() == 0) return corrupt(joint, "the id must not be 0");
    if (joint.entity_b() == 0) return corrupt(joint, "entity_b must not be 0");
    if (joint.entity_a() == joint.entity_b())
        return corrupt(joint, "entity_a and entity_b are both " + std::to_string(joint.entity_b()));
    if (joint.form() >= static_cast<std::uint32_t>(forms))
        return corrupt(joint, "form " + std::to_string(joint.form()) +
                                  " does not exist; there are " + std::to_string(forms));
    return {};
}

}  // namespace

Status JointList::apply(const v1::JointUpdate& update) {
    for (const v1::JointInfo& joint : update.added())
        if (Status s = check(joint, update.forms_size()); !s.ok()) return s;
    const std::size_t before = update.complete() ? 0 : joints_.size();
    const auto added = static_cast<std::size_t>(update.added_size());
    if (before + added > joints_max)
        return Error{ErrorCode::corrupt_data, std::to_string(before + added) + " joints; at most " +
                                                  std::to_string(joints_max) + " are allowed"};
    if (update.complete()) joints_.clear();
    for (const std::uint32_t id : update.removed()) joints_.erase(id);
    std::vector<std::shared_ptr<const v1::Joint>> forms;
    for (const v1::Joint& form : update.forms())
        forms.push_back(std::make_shared<const v1::Joint>(form));
    for (const v1::JointInfo& joint : update.added())
        joints_[joint.id()] = {joint.entity_a(), joint.entity_b(), forms[joint.form()]};
    return {};
}

}  // namespace jostle::client
