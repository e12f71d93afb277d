// SPDX-License-Identifier: MIT
//
// Who takes part in the step, in the order in which they are called. No part of what a restore
// point copies: it keeps what the modules' visitors give it.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/check.h"
#include "jostle/physics/module.h"

namespace jostle::physics {

struct ListenerStore {
    std::vector<StepListener*> order;              // modules among them
    std::vector<std::unique_ptr<Module>> modules;  // in their order
    StepHooks wanted;                              // by any of them; derived
    World* stepping = nullptr;                     // set within World::step()

    bool empty() const { return order.empty(); }

    Module* module(std::string_view tag) const {
        for (const std::unique_ptr<Module>& module : modules)
            if (module->tag() == tag) return module.get();
        return nullptr;
    }
    void add(StepListener& listener) {
        order.push_back(&listener);
        derive_wanted();
    }
    void remove(const StepListener& listener) {
        ASSERT(std::find(order.begin(), order.end(), &listener) != order.end());
        std::erase(order, &listener);
        derive_wanted();
    }
    void add(std::unique_ptr<Module> module) {
        add(static_cast<StepListener&>(*module));
        modules.push_back(std::move(module));
    }
    // Calls and visits modules in the order of their tags in `tags`, which names all of them; the
    // places of the listeners between them stay.
    void sort_modules(const std::vector<std::string>& tags) {
        ASSERT(tags.size() == modules.size());
        const auto rank = [&](std::string_view tag) {
            return std::find(tags.begin(), tags.end(), tag) - tags.begin();
        };
        std::vector<std::size_t> places;
        for (std::size_t k = 0; k < order.size(); k++)
            for (const std::unique_ptr<Module>& module : modules)
                if (module.get() == order[k]) places.push_back(k);
        std::sort(modules.begin(), modules.end(),
                  [&](const auto& a, const auto& b) { return rank(a->tag()) < rank(b->tag()); });
        for (std::size_t k = 0; k < places.size(); k++) order[places[k]] = modules[k].get();
    }
    void remove_module(std::string_view tag) {
        remove(*module(tag));
        std::erase_if(modules, [&](const auto& module) { return module->tag() == tag; });
    }

private:
    void derive_wanted() {
        wanted = {};
        for (const StepListener* listener : order) {
            const StepHooks hooks = listener->hooks();
            wanted.substeps |= hooks.substeps;
            wanted.pre_solve |= hooks.pre_solve;
        }
    }
};

}  // namespace jostle::physics
