// SPDX-License-Identifier: MIT
//
// Adapter from a field list visitor to the StateVisitor of modules, and the visit of a world's
// modules.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "jostle/base/check.h"
#include "jostle/physics/module.h"
#include "physics/src/state/listener_store.h"

namespace jostle::physics {

template <class V>
class ModuleVisitor final : public StateVisitor {
public:
    explicit ModuleVisitor(V& visitor) : v_(visitor) {}
    using StateVisitor::field;

    bool loading() const override { return V::kLoading; }
    void fail(std::string_view name, std::string_view what) override {
        if constexpr (V::kLoading) v_.fail(name, what);
    }
    bool failed() const override {
        if constexpr (V::kLoading) return !v_.error.empty();
        return false;
    }
    void field(std::string_view name, bool& x) override { v_.field(name, x); }
    void field(std::string_view name, std::uint8_t& x) override { v_.field(name, x); }
    void field(std::string_view name, std::uint16_t& x) override { v_.field(name, x); }
    void field(std::string_view name, std::uint32_t& x) override { v_.field(name, x); }
    void field(std::string_view name, std::uint64_t& x) override { v_.field(name, x); }
    void field(std::string_view name, std::int32_t& x) override { v_.field(name, x); }
    void field(std::string_view name, std::int64_t& x) override { v_.field(name, x); }
    void field(std::string_view name, float& x) override { v_.field(name, x); }
    void field(std::string_view name, double& x) override { v_.field(name, x); }
    void field(std::string_view name, std::span<double> values) override {
        visit_each(name, values, [&](double& x) { v_.field("", x); });
    }
    void field(std::string_view name, std::span<std::uint32_t> values) override {
        visit_each(name, values, [&](std::uint32_t& x) { v_.field("", x); });
    }
    void field(std::string_view name, std::span<Vec3> values) override {
        visit_each(name, values, [&](Vec3& p) {
            v_.field("x", p.x);
            v_.field("y", p.y);
            v_.field("z", p.z);
        });
    }
    std::size_t count(std::string_view name, std::size_t size) override {
        return v_.count(name, size);
    }
    void enter(std::string_view name) override { v_.enter(name); }
    void enter(std::size_t index) override { v_.enter(index); }
    void leave() override { v_.leave(); }

private:
    // Path, then values: no virtual call per value.
    template <class T, class Visit>
    void visit_each(std::string_view name, std::span<T> values, Visit&& visit) {
        v_.enter(name);
        for (std::size_t k = 0; k < values.size(); k++) {
            v_.enter(k);
            visit(values[k]);
            v_.leave();
        }
        v_.leave();
    }

    V& v_;
};

template <class V>
void visit_state(V& v, Module& module) {
    ModuleVisitor<V> visitor(v);
    v.enter(module.tag());
    static_cast<StateVisitor&>(visitor).enter("state");
    module.visit(visitor);
    v.leave();
    v.leave();
}

// Visits the tags and states of the modules in order. A loader creates the modules with the
// registry.
template <class V>
void visit_modules(V& v, ListenerStore& listeners) {
    auto count = static_cast<std::uint32_t>(listeners.modules.size());
    v.optional("modules", count, 10);
    for (std::uint32_t k = 0; k < count; k++) {
        std::string tag;
        if constexpr (!V::kLoading) tag = listeners.modules[k]->tag();
        ModuleVisitor<V> visitor(v);
        v.enter("modules");
        static_cast<StateVisitor&>(visitor).field("tag", tag);
        if constexpr (V::kLoading) {
            if (!v.error.empty()) return;
            Result<std::unique_ptr<Module>> made = make_module(tag);
            if (!made.ok() || listeners.module(tag) != nullptr) {
                v.fail("", made.ok() ? "contains \"" + tag + "\" twice" : made.error().message);
                return;
            }
            listeners.add(std::move(made).value());
        }
        visit_state(v, *listeners.modules[k]);
        v.leave();
    }
}

}  // namespace jostle::physics
