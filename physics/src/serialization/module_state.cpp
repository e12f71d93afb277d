// SPDX-License-Identifier: MIT
//
// Saving and loading of one module's state, and the composite fields of StateVisitor.
#include "physics/src/serialization/byte_visitors.h"
#include "physics/src/serialization/module_visitor.h"

namespace jostle::physics {
namespace {

constexpr std::size_t longest_text = 65536;

}  // namespace

void StateVisitor::field(std::string_view name, Vec3& value) {
    enter(name);
    field("x", value.x);
    field("y", value.y);
    field("z", value.z);
    leave();
}

void StateVisitor::field(std::string_view name, Quat& value) {
    enter(name);
    field("x", value.x);
    field("y", value.y);
    field("z", value.z);
    field("w", value.w);
    leave();
}

void StateVisitor::field(std::string_view name, Transform& value) {
    enter(name);
    field("position", value.position);
    field("rotation", value.rotation);
    leave();
}

namespace {

template <class T>
void visit_each(StateVisitor& v, std::string_view name, std::span<T> values) {
    v.enter(name);
    for (std::size_t k = 0; k < values.size(); k++) {
        v.enter(k);
        v.field("", values[k]);
        v.leave();
    }
    v.leave();
}

}  // namespace

void StateVisitor::field(std::string_view name, std::span<double> values) {
    visit_each(*this, name, values);
}
void StateVisitor::field(std::string_view name, std::span<std::uint32_t> values) {
    visit_each(*this, name, values);
}
void StateVisitor::field(std::string_view name, std::span<Vec3> values) {
    visit_each(*this, name, values);
}

namespace {

template <class Id>
void visit_id(StateVisitor& v, std::string_view name, Id& id) {
    v.enter(name);
    v.field("index", id.index);
    v.field("generation", id.generation);
    v.leave();
}

}  // namespace

void StateVisitor::field(std::string_view name, BodyId& value) {
    visit_id(*this, name, value);
}
void StateVisitor::field(std::string_view name, ShapeId& value) {
    visit_id(*this, name, value);
}
void StateVisitor::field(std::string_view name, JointId& value) {
    visit_id(*this, name, value);
}

void StateVisitor::field(std::string_view name, std::string& value) {
    enter(name);
    std::size_t size = count("size", value.size());
    if (size > longest_text) {
        fail("size", "is more than 65536");
        size = 0;
    }
    if (loading()) value.resize(size);
    for (char& c : value) {
        auto byte = static_cast<std::uint8_t>(c);
        field("", byte);
        c = static_cast<char>(byte);
    }
    leave();
}

std::vector<std::byte> save_module(Module& module) {
    Saver saver;
    visit_state(saver, module);
    return saver.out.take();
}

Status load_module(Module& module, std::span<const std::byte> bytes) {
    Loader loader{.in = ByteReader(bytes), .version = saved_world_version};
    visit_state(loader, module);
    std::string fault = loader.error;
    if (fault.empty() && loader.in.left() != 0)
        fault = std::to_string(loader.in.left()) + " bytes remain after its last field";
    if (fault.empty()) return {};
    return Error{ErrorCode::corrupt_data,
                 "state of module \"" + std::string(module.tag()) + "\": " + fault};
}

}  // namespace jostle::physics
