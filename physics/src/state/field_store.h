// SPDX-License-Identifier: MIT
//
// The force fields of a world.
#pragma once

#include <vector>

#include "jostle/physics/force_fields.h"
#include "physics/src/foundation/id_pool.h"

namespace jostle::physics {

struct FieldStore {
    IdPool ids;
    std::vector<FieldDef> fields;       // by index
    std::vector<std::uint32_t> active;  // indices of existing fields, ascending; derived

    bool empty() const { return active.empty(); }

    void derive_active() {
        active.clear();
        for (std::uint32_t i = 0; i < ids.size(); i++)
            if (ids.alive(i)) active.push_back(i);
    }
};

inline FieldId field_id(const FieldStore& fields, std::uint32_t field) {
    return {field, fields.ids.generation(field)};
}

}  // namespace jostle::physics
