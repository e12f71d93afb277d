// SPDX-License-Identifier: MIT
//
// The table of hulls, meshes, height fields and compounds in a saved world: each is there once,
// however many shapes use it. What is derived from them is computed anew by their builders, with
// the same bits.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"
#include "physics/src/foundation/byte_stream.h"
#include "physics/src/state/shape_store.h"

namespace jostle::physics {

class SharedGeometry {
public:
    // Gathers what a world's shapes use, in order of shapes; a compound's hulls come before it.
    void collect(const ShapeStore& store);
    void write(ByteWriter& out) const;
    // Foreign bytes: a message names what is wrong.
    std::optional<std::string> read(ByteReader& in);

    template <class Data>
    std::uint32_t index_of(const std::shared_ptr<const Data>& data) const {
        return indices_.at(data.get());
    }
    // Null when there is none of that kind at the index.
    template <class Data>
    std::shared_ptr<const Data> at(std::uint32_t index) const {
        if (index >= entries_.size()) return nullptr;
        const auto* found = std::get_if<std::shared_ptr<const Data>>(&entries_[index]);
        return found != nullptr ? *found : nullptr;
    }

private:
    using Entry =
        std::variant<std::shared_ptr<const ConvexHull>, std::shared_ptr<const TriangleMesh>,
                     std::shared_ptr<const HeightGrid>, std::shared_ptr<const CompoundShape>>;
    void add(const Geometry& geometry);
    void put(const void* data, Entry entry);

    std::vector<Entry> entries_;
    std::map<const void*, std::uint32_t> indices_;  // checked up, never walked
};

}  // namespace jostle::physics
