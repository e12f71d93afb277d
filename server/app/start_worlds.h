// SPDX-License-Identifier: MIT
//
// Fills the world directory when the server starts: persisted worlds first, then the configured
// scenes. Called once, on the main thread, before the listeners exist.
#pragma once

#include "jostle/base/result.h"
#include "server/config/config.h"
#include "server/recovery/world_archive.h"
#include "server/session/play_context.h"
#include "server/world/world_directory.h"

namespace jostle::server {

// Resumes every persisted world; its clients may reconnect within resume_timeout_seconds.
void resume_persisted_worlds(WorldArchive& archive, PlayContext& context);

// Creates a world for each entry of Config::scenes ("pyramid", "my.json" or "arena=pyramid") unless
// a world of its name exists, or `archive` has one that it could not resume. Errors name the entry.
// Null archive: worlds are not persisted.
Status create_configured_worlds(const Config& config, WorldDirectory& worlds,
                                const WorldArchive* archive);

}  // namespace jostle::server
