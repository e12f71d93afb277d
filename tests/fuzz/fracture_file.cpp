// SPDX-License-Identifier: MIT
//
// Files of jostle-mesh fracture, whatever follows their head: refused with a reason, or a shape
// that a world takes, breaks and steps with, and that is written as it was read.
#include "jostle/modules/fracture_file.h"

#include <cstring>
#include <memory>

#include "jostle/modules/destruction.h"
#include "tests/fuzz/mutate_numbers.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using namespace modules;

// With a head that is right: version and checksum would let nothing through.
std::vector<std::byte> with_head(Bytes input) {
    const auto rest = bytes_of(input);
    std::vector<std::byte> bytes(fracture_header_bytes);
    const std::uint64_t sum = fracture_checksum(rest);
    std::memcpy(bytes.data(), "JFRACT\r\n", 8);
    std::memcpy(bytes.data() + 8, &fracture_version, 4);
    std::memcpy(bytes.data() + 12, &sum, 8);
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
}

void break_in_world(const FracturedShape& shape) {
    physics::World world;
    auto module = std::make_unique<Destruction>();
    Destruction& destruction = *module;
    expect(world.add_module(std::move(module)).ok(), "a world takes the module");
    const auto id = destruction.add(world, shape, {});
    if (!id.ok()) return expect(!id.error().message.empty(), "a refusal has a reason");
    static_cast<void>(world.step(1.0 / 60).ok());
    static_cast<void>(destruction.break_near(world, *id, {}, 1e6).ok());
    static_cast<void>(world.step(1.0 / 60).ok());
}

}  // namespace

void run(Bytes input) {
    static_cast<void>(read_fracture(bytes_of(input)).ok());
    const auto shape = read_fracture(with_head(input));
    if (!shape.ok()) return expect(!shape.error().message.empty(), "a refusal has a reason");
    const auto again = write_fracture(*shape);
    expect(again.ok(), again.ok() ? "" : "what was read is not written: " + again.error().message);
    expect(read_fracture(*again).ok(), "what was written is read");
    break_in_world(*shape);
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    return jostle::fuzz::mutate_numbers(data, size, size_max, seed);
}
