// SPDX-License-Identifier: MIT
//
// File format of a fractured shape. jostle-mesh fracture writes such files; scenes load them.
//
// Little endian. "JFRACT" 0d 0a, u32 version (1), u64 checksum of all that follows (FNV-1a), u32
// number of chunks, u32 number of bonds; then the chunks, then the bonds.
//
// A chunk: u8 kind (0: box, 1: hull), u8 anchored (0, 1), f64 position x y z, f64 rotation x y z w,
// f64 volume, f64 centre of mass x y z, f64 inertia about it at density 1: xx yy zz xy xz yz; for a
// box f64 half extents x y z; for a hull u16 number of vertices (4 to 252), for each f64 x y z.
//
// A bond: u32 a, u32 b (a < b), f64 centre x y z, normal x y z, axis x y z, area, moment_u,
// moment_v, reach_u, reach_v, as in FractureBond.
//
// Thread rule: any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/modules/fractured_shape.h"

namespace jostle::modules {

/// Version of the format.
inline constexpr std::uint32_t fracture_version = 1;
/// Bytes before the counts.
inline constexpr std::size_t fracture_header_bytes = 20;
/// Maximum size of a file that is read.
inline constexpr std::size_t fracture_bytes_max = 256 << 20;

/// Encodes a shape of boxes and hulls that Destruction::add() would accept. invalid_argument names
/// the chunk or bond that is invalid.
physics::Result<std::vector<std::byte>> write_fracture(const FracturedShape& shape);

/// Decodes a shape. The bytes may come from an untrusted source: an error names the problem and its
/// location ("chunks[3]: ..."). Destruction::add() accepts the result. Memory use is proportional
/// to the number of bytes.
physics::Result<FracturedShape> read_fracture(std::span<const std::byte> bytes);

/// FNV-1a checksum of the bytes after the header (G. Fowler, L. C. Noll, K.-P. Vo).
std::uint64_t fracture_checksum(std::span<const std::byte> bytes);

}  // namespace jostle::modules
