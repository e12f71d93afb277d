// SPDX-License-Identifier: MIT
//
// The portable form of a checkpoint: the world as a scene, with the entity ids and the clients. A
// version that cannot read the exact form resumes from it. Accumulated impulses, sleep and grabs
// are not part of it.
//
// Later versions only append fields, so a reader ignores what follows those it knows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "server/recovery/world_definition.h"
#include "server/world/hosted_world.h"

namespace jostle::server {

struct PortableForm {
    std::string bytes;
    std::vector<std::string> omitted;  // parts that it cannot represent, one sentence each
};
// `definition.scene` is the scene that the world was built from. The world does not step meanwhile.
PortableForm encode_portable(HostedWorld& world, std::uint32_t tick,
                             const WorldDefinition& definition);

struct PortableWorld {
    HostedWorld world;
    WorldDefinition definition;  // its scene is the world in the portable form
    std::vector<std::string> omitted;
};
// corrupt_data: the bytes are not a portable form. failed_precondition: they have a version that
// this server does not read. Errors of its scene name the field.
Result<PortableWorld> decode_portable(std::string_view bytes, std::uint32_t tick,
                                      const HostLimits& limits, int threads);

}  // namespace jostle::server
