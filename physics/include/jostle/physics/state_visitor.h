// SPDX-License-Identifier: MIT
//
// One walk over all that a module's next step depends on. Saving, loading, hashing, comparing and
// restore points are five visitors of the same walk, so none of them can forget a field that
// another has.
//
//     void visit(StateVisitor& v) override {
//         v.field("body", body_);
//         v.field("phase", phase_);
//         v.all("wheels", wheels_, [&](Wheel& wheel) { v.field("travel", wheel.travel); });
//     }
//
// The walk is the same each time: which fields follow may depend on fields before, on nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

class StateVisitor {
public:
    virtual ~StateVisitor() = default;

    // Whether fields are written to. What was read may be any value of its type; numbers are
    // finite.
    virtual bool loading() const = 0;
    // While loading: what was read makes no sense. The load ends with an error that names the
    // field: fail("wheels", "are more than 8").
    virtual void fail(std::string_view name, std::string_view what) = 0;
    // Whether it did, or a field could not be read. What was read since is of no use.
    virtual bool failed() const = 0;

    // Names are for messages: "modules.hovercraft.wheels[2].travel". They are not saved.
    virtual void field(std::string_view name, bool& value) = 0;
    virtual void field(std::string_view name, std::uint8_t& value) = 0;
    virtual void field(std::string_view name, std::uint16_t& value) = 0;
    virtual void field(std::string_view name, std::uint32_t& value) = 0;
    virtual void field(std::string_view name, std::uint64_t& value) = 0;
    virtual void field(std::string_view name, std::int32_t& value) = 0;
    virtual void field(std::string_view name, std::int64_t& value) = 0;
    virtual void field(std::string_view name, float& value) = 0;
    virtual void field(std::string_view name, double& value) = 0;

    void field(std::string_view name, Vec3& value);
    void field(std::string_view name, Quat& value);
    void field(std::string_view name, Transform& value);
    // Ids of the world. A visitor between two worlds names what they stand for.
    virtual void field(std::string_view name, BodyId& value);
    virtual void field(std::string_view name, ShapeId& value);
    virtual void field(std::string_view name, JointId& value);
    void field(std::string_view name, std::string& value);  // at most 65536 bytes
    // An enumeration that counts from 0 to `last`.
    template <class E>
    requires std::is_enum_v<E>
    void field(std::string_view name, E& value, E last) {
        auto number = static_cast<std::uint32_t>(value);
        field(name, number);
        if (loading() && number > static_cast<std::uint32_t>(last))
            fail(name, "is not one of its values");
        else
            value = static_cast<E>(number);
    }

    // The length of an array: returns what it is, which a loader reads. Bounded by the bytes that
    // follow, so a file cannot make us allocate more than itself.
    virtual std::size_t count(std::string_view name, std::size_t size) = 0;
    // An array: its length, then each(item) under its index.
    template <class T, class Each>
    void all(std::string_view name, std::vector<T>& items, Each&& each) {
        enter(name);
        const std::size_t size = count("size", items.size());
        if (loading()) items.resize(size);
        for (std::size_t k = 0; k < items.size(); k++) {
            enter(k);
            each(items[k]);
            leave();
        }
        leave();
    }

    // The path of the fields that follow, until leave().
    virtual void enter(std::string_view name) = 0;
    virtual void enter(std::size_t index) = 0;
    virtual void leave() = 0;
};

}  // namespace jostle::physics
