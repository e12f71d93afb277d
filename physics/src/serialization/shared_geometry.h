// SPDX-License-Identifier: MIT
//
// Table of the hulls, meshes, height fields and compounds of a saved world. Each is stored once,
// regardless of the number of shapes that use it. Derived data is recomputed by their builders with
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
    // Collects the shared geometry of a world's shapes, in order of the shapes. The hulls of a
    // compound precede it.
    void collect(const ShapeStore& store);
    void write(ByteWriter& out) const;
    // Reads the table from untrusted bytes. Returns an error message if it is invalid.
    std::optional<std::string> read(ByteReader& in);

    template <class Data>
    std::uint32_t index_of(const std::shared_ptr<const Data>& data) const {
        return indices_.at(data.get());
    }
    // Returns the entry at the index; null if there is no entry of that type.
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
    std::map<const void*, std::uint32_t> indices_;  // looked up only, never iterated
};

}  // namespace jostle::physics
