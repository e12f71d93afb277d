// SPDX-License-Identifier: MIT
//
// Visitor over the state of a module. One visit function serves saving, loading, hashing, comparing
// and restore points, so all of them cover the same fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

/// Visits every field that the next step of a module depends on.
///
///     void visit(StateVisitor& v) override {
///         v.field("body", body_);
///         v.field("phase", phase_);
///         v.all("wheels", wheels_, [&](Wheel& wheel) { v.field("travel", wheel.travel); });
///     }
///
/// The sequence of fields may depend on earlier fields only. Field names appear in messages, such
/// as "modules.hovercraft.wheels[2].travel"; they are not saved.
class StateVisitor {
public:
    virtual ~StateVisitor() = default;

    /// Returns true if the visitor writes to the fields. A loaded value can be any value of its
    /// type; floating-point values are finite.
    virtual bool loading() const = 0;
    /// Reports that a loaded value is invalid. The load ends with an error that names the field:
    /// fail("wheels", "are more than 8"). Ignored unless loading.
    virtual void fail(std::string_view name, std::string_view what) = 0;
    /// Returns true after fail() or a read error. Values loaded since then are undefined.
    virtual bool failed() const = 0;

    /// Visit a scalar field.
    virtual void field(std::string_view name, bool& value) = 0;
    virtual void field(std::string_view name, std::uint8_t& value) = 0;
    virtual void field(std::string_view name, std::uint16_t& value) = 0;
    virtual void field(std::string_view name, std::uint32_t& value) = 0;
    virtual void field(std::string_view name, std::uint64_t& value) = 0;
    virtual void field(std::string_view name, std::int32_t& value) = 0;
    virtual void field(std::string_view name, std::int64_t& value) = 0;
    virtual void field(std::string_view name, float& value) = 0;
    virtual void field(std::string_view name, double& value) = 0;

    /// Visit a composite field, component by component.
    void field(std::string_view name, Vec3& value);
    void field(std::string_view name, Quat& value);
    void field(std::string_view name, Transform& value);
    /// Visit consecutive numbers as one field, with one call instead of one per number. The size of
    /// the span is not visited: visit it first with count() and resize the array.
    virtual void field(std::string_view name, std::span<double> values);
    virtual void field(std::string_view name, std::span<std::uint32_t> values);
    virtual void field(std::string_view name, std::span<Vec3> values);
    /// Visit an id. A visitor between two worlds translates ids into what they refer to.
    virtual void field(std::string_view name, BodyId& value);
    virtual void field(std::string_view name, ShapeId& value);
    virtual void field(std::string_view name, JointId& value);
    /// Visits a string of at most 65536 bytes.
    void field(std::string_view name, std::string& value);
    /// Visits an enumeration with the values 0 to `last`. Loading fails for other values.
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

    /// Visits the length of an array and returns it; a loading visitor returns the loaded length.
    /// Bounded by the number of remaining bytes, so untrusted data cannot cause an allocation
    /// larger than itself.
    virtual std::size_t count(std::string_view name, std::size_t size) = 0;
    /// Visits an array: its length, then each(item) with the item's index as the path.
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

    /// Enter a level of the field path, until the matching leave().
    virtual void enter(std::string_view name) = 0;
    virtual void enter(std::size_t index) = 0;
    virtual void leave() = 0;
};

}  // namespace jostle::physics
