// SPDX-License-Identifier: MIT
//
// Listeners and modules of a world, in call order. Not part of a restore point, which stores the
// state of modules through their visitors.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/module.h"

namespace jostle::physics {

struct ListenerStore {
    struct Entry {
        StepListener* listener;
        StepHooks hooks;
    };
    std::vector<Entry> order;                      // includes modules
    std::vector<std::unique_ptr<Module>> modules;  // in order
    // Hooks of any listener; `concurrent` only if all listeners of sub-steps set it. Derived.
    StepHooks active_hooks;
    World* stepping = nullptr;  // set within World::step()
    std::int64_t work = 0;      // counted in before_step() for the next step_world()

    bool empty() const { return order.empty(); }

    bool contains(const StepListener& listener) const {
        return std::any_of(order.begin(), order.end(),
                           [&](const Entry& entry) { return entry.listener == &listener; });
    }
    Module* module(std::string_view tag) const {
        for (const std::unique_ptr<Module>& module : modules)
            if (module->tag() == tag) return module.get();
        return nullptr;
    }
    void add(StepListener& listener) {
        ASSERT(!contains(listener));
        order.push_back({&listener, listener.hooks()});
        derive_active_hooks();
    }
    // Reads the hooks of all listeners for the next step.
    void refresh_hooks() {
        for (Entry& entry : order) entry.hooks = entry.listener->hooks();
        derive_active_hooks();
    }
    void remove(const StepListener& listener) {
        ASSERT(contains(listener));
        std::erase_if(order, [&](const Entry& entry) { return entry.listener == &listener; });
        derive_active_hooks();
    }
    void add(std::unique_ptr<Module> module) {
        ASSERT(module != nullptr);
        add(static_cast<StepListener&>(*module));
        modules.push_back(std::move(module));
    }
    // Sorts the modules by the order of their tags in `tags`, which contains all of them. The
    // positions of other listeners do not change.
    void sort_modules(const std::vector<std::string>& tags) {
        ASSERT(tags.size() == modules.size());
        const auto rank = [&](std::string_view tag) {
            return std::find(tags.begin(), tags.end(), tag) - tags.begin();
        };
        std::vector<std::size_t> positions;
        for (std::size_t k = 0; k < order.size(); k++)
            for (const std::unique_ptr<Module>& module : modules)
                if (module.get() == order[k].listener) positions.push_back(k);
        std::sort(modules.begin(), modules.end(),
                  [&](const auto& a, const auto& b) { return rank(a->tag()) < rank(b->tag()); });
        for (std::size_t k = 0; k < positions.size(); k++)
            order[positions[k]] = {modules[k].get(), modules[k]->hooks()};
    }
    void remove_module(std::string_view tag) {
        ASSERT(module(tag) != nullptr);
        remove(*module(tag));
        std::erase_if(modules, [&](const auto& module) { return module->tag() == tag; });
    }

private:
    void derive_active_hooks() {
        active_hooks = {};
        for (const Entry& entry : order) {
            if (entry.hooks.substeps)
                active_hooks.concurrent =
                    entry.hooks.concurrent && (active_hooks.concurrent || !active_hooks.substeps);
            active_hooks.substeps |= entry.hooks.substeps;
            active_hooks.pre_solve |= entry.hooks.pre_solve;
        }
    }
};

}  // namespace jostle::physics
