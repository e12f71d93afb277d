// SPDX-License-Identifier: MIT
#include "server/services/find_world.h"

#include <spdlog/fmt/fmt.h>

namespace jostle::server {

Result<std::shared_ptr<WorldHost>> find_world(const PlayContext& context, const std::string& name) {
    if (name.empty()) return invalid_argument("name the world; ListWorlds lists them");
    std::shared_ptr<WorldHost> world = context.worlds.find(name);
    if (!world)
        return Error{ErrorCode::not_found,
                     fmt::format("there is no world \"{}\"; ListWorlds lists them", name)};
    return world;
}

}  // namespace jostle::server
