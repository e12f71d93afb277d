// SPDX-License-Identifier: MIT
//
// A fractured shape as a file: jostle-fracture writes it, whoever loads a scene reads it.
//
// Little endian. "JFRACT" 0d 0a, u32 version (1), u64 checksum of all that follows (FNV-1a), u32
// chunks, u32 bonds; then the chunks, then the bonds.
//
// A chunk: u8 kind (0: box, 1: hull), u8 anchored (0, 1), f64 position x y z, f64 rotation x y z w,
// f64 volume, f64 centre of mass x y z, f64 inertia about it at density 1: xx yy zz xy xz yz; of a
// box f64 half extents x y z; of a hull u16 vertices (4 to 252), of each f64 x y z.
// A bond: u32 a, u32 b (a < b), f64 centre x y z, normal x y z, axis x y z, area, moment_u,
// moment_v, reach_u, reach_v: FractureBond.
//
// Thread rule: any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/modules/fractured_shape.h"

namespace jostle::modules {

inline constexpr std::uint32_t fracture_version = 1;
inline constexpr std::size_t fracture_header_bytes = 20;      // up to the counts
inline constexpr std::size_t fracture_bytes_max = 256 << 20;  // that are read

// Of a shape that Destruction::add() would take, of boxes and hulls; an error names the chunk.
physics::Result<std::vector<std::byte>> write_fracture(const FracturedShape& shape);

// Foreign bytes are checked: an error says what is wrong and where ("chunks[3]: ..."). What it
// gives can be added. Memory is in proportion to the bytes.
physics::Result<FracturedShape> read_fracture(std::span<const std::byte> bytes);

// FNV-1a of what follows the head (Fowler, Noll, Vo).
std::uint64_t fracture_checksum(std::span<const std::byte> bytes);

}  // namespace jostle::modules
