// SPDX-License-Identifier: MIT
#include "server/messages/joint_update_message.h"

#include <string>
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

const JointList& list_or_empty(const std::shared_ptr<const JointList>& list) {
    static const JointList nothing;
    return list ? *list : nothing;
}

}  // namespace

struct JointUpdateWriter::Update {
    v1::Snapshot snapshot;                                 // only the joints
    std::unordered_map<std::string, std::uint32_t> forms;  // by their bytes
    v1::JointUpdate& joints() { return *snapshot.mutable_joints(); }
};

JointUpdateWriter::JointUpdateWriter() : update_(std::make_unique<Update>()) {}
JointUpdateWriter::~JointUpdateWriter() = default;

void JointUpdateWriter::set_complete() {
    update_->joints().set_complete(true);
}

void JointUpdateWriter::remove(std::uint32_t id) {
    update_->joints().add_removed(id);
    bytes_ += id_bytes;
}

void JointUpdateWriter::add(const JointDescription& joint) {
    v1::Joint form;
    scenes::write_joint_form(form, joint.def);
    const auto next = static_cast<std::uint32_t>(update_->forms.size());
    const auto [known, fresh] = update_->forms.try_emplace(form.SerializeAsString(), next);
    if (fresh) {
        bytes_ += known->first.size();
        *update_->joints().add_forms() = std::move(form);
    }
    v1::JointInfo& to = *update_->joints().add_added();
    to.set_id(joint.id);
    to.set_entity_a(joint.entity_a);
    to.set_entity_b(joint.entity_b);
    to.set_form(known->second);
    bytes_ += joint_bytes;
}

bool JointUpdateWriter::is_full() const {
    return bytes_ >= field_bytes_max || update_->forms.size() == forms_max;
}

SharedBytes JointUpdateWriter::take() {
    if (!update_->snapshot.has_joints()) return nullptr;
    auto bytes = std::make_shared<const std::string>(update_->snapshot.SerializeAsString());
    update_ = std::make_unique<Update>();
    bytes_ = 0;
    return bytes;
}

JointListChange::JointListChange(std::shared_ptr<const JointList> from,
                                 std::shared_ptr<const JointList> to)
    : from_(std::move(from)), to_(std::move(to)) {
    ASSERT(to_ != nullptr);
    removed_ = next_removed();
    added_ = next_added();
    is_complete_ = from_ && !removed_ && !added_;
    if (!from_) writer_.set_complete();
}

JointListChange::Field JointListChange::field(std::size_t index) {
    const std::lock_guard lock(mutex_);
    ASSERT(index <= fields_.size());
    if (index == fields_.size() && !is_complete_) encode_field();
    if (index >= fields_.size()) return {};
    return {fields_[index], is_complete_ && index + 1 == fields_.size()};
}

void JointListChange::encode_field() {
    for (; removed_ && !writer_.is_full(); removed_ = next_removed()) writer_.remove(removed_->id);
    for (; !removed_ && added_ && !writer_.is_full(); added_ = next_added()) writer_.add(*added_);
    fields_.push_back(writer_.take());
    ASSERT(fields_.back() != nullptr);
    is_complete_ = !removed_ && !added_;
}

// Equal descriptions are the same object, so that lists of different registries share none.
const JointDescription* JointListChange::next_removed() {
    const JointList& old = list_or_empty(from_);
    auto& [i, j] = removals_;
    while (i < old.size()) {
        if (j < to_->size() && old[i] == (*to_)[j]) {
            ++i, ++j;
        } else if (j == to_->size() || old[i]->id <= (*to_)[j]->id) {
            return old[i++].get();
        } else {
            ++j;
        }
    }
    return nullptr;
}

const JointDescription* JointListChange::next_added() {
    const JointList& old = list_or_empty(from_);
    auto& [i, j] = additions_;
    while (j < to_->size()) {
        if (i < old.size() && old[i] == (*to_)[j]) {
            ++i, ++j;
        } else if (i < old.size() && old[i]->id <= (*to_)[j]->id) {
            ++i;
        } else {
            return (*to_)[j++].get();
        }
    }
    return nullptr;
}

}  // namespace jostle::server
