// SPDX-License-Identifier: MIT
#include "server/messages/joint_update_message.h"

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/scenes/joint_form.h"
#include "jostle/v1/play.pb.h"

namespace jostle::server {

namespace {

constexpr std::size_t field_bytes_max = 64u << 10;
constexpr std::size_t id_bytes = 5;
constexpr std::size_t joint_bytes = 24;  // at most, without its form
constexpr std::size_t forms_max = 65536;

class JointUpdateWriter {
public:
    void set_complete() { update().set_complete(true); }
    void remove(std::uint32_t id) {
        update().add_removed(id);
        count(id_bytes);
    }
    void add(const JointDescription& joint) {
        v1::Joint form;
        scenes::write_joint_form(form, joint.def);
        std::size_t added = joint_bytes;
        const auto next = static_cast<std::uint32_t>(forms_.size());
        const auto [known, fresh] = forms_.try_emplace(form.SerializeAsString(), next);
        if (fresh) {
            added += known->first.size();
            *update().add_forms() = std::move(form);
        }
        v1::JointInfo& to = *update().add_added();
        to.set_id(joint.id);
        to.set_entity_a(joint.entity_a);
        to.set_entity_b(joint.entity_b);
        to.set_form(known->second);
        count(added);
    }
    std::vector<SharedBytes> take() {
        flush();
        return std::move(fields_);
    }

private:
    v1::JointUpdate& update() { return *snapshot_.mutable_joints(); }
    void count(std::size_t bytes) {
        bytes_ += bytes;
        if (bytes_ >= field_bytes_max || forms_.size() == forms_max) flush();
    }
    void flush() {
        if (!snapshot_.has_joints()) return;
        fields_.push_back(std::make_shared<const std::string>(snapshot_.SerializeAsString()));
        snapshot_.Clear();
        forms_.clear();
        bytes_ = 0;
    }

    v1::Snapshot snapshot_;                                 // only the joints
    std::unordered_map<std::string, std::uint32_t> forms_;  // by their bytes
    std::size_t bytes_ = 0;
    std::vector<SharedBytes> fields_;
};

}  // namespace

std::vector<SharedBytes> joint_update_fields(const JointList* from, const JointList& to) {
    JointUpdateWriter writer;
    static const JointList nothing;
    if (!from) writer.set_complete();
    const JointList& old = from ? *from : nothing;
    // Equal descriptions are the same object, so that lists of different registries share none.
    JointList added;
    std::size_t i = 0, j = 0;
    while (i < old.size() || j < to.size()) {
        if (i < old.size() && j < to.size() && old[i] == to[j]) {
            ++i, ++j;
        } else if (j == to.size() || (i < old.size() && old[i]->id <= to[j]->id)) {
            writer.remove(old[i++]->id);
        } else {
            added.push_back(to[j++]);
        }
    }
    for (const auto& joint : added) writer.add(*joint);
    return writer.take();
}

}  // namespace jostle::server
