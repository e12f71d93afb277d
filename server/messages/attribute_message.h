// SPDX-License-Identifier: MIT
//
// Attributes as messages of play.proto. Pure functions; any thread.
#pragma once

#include <string>

#include "jostle/base/result.h"
#include "jostle/v1/play.pb.h"
#include "server/world/attributes.h"
#include "server/world/command.h"

namespace jostle::server {

// Decodes an untrusted set. `where`: prefix of field names in errors. The caller checks the changes
// with check_attribute_change().
Result<SetAttributesCommand> to_attribute_changes(const v1::AttributeSet& set,
                                                  const std::string& where);
void write_target(v1::AttributeSet& to, const AttributeTarget& target);
void write_attribute(v1::Attribute& to, const std::string& key, const Attribute& attribute);

// --- fields of jostle.v1.Snapshot; empty: the receivers may read none of it ---

// For all clients with this role, without attributes that only owners read.
std::string encode_attribute_changes(const AttributeChanges& changes, PlayerRole role);
// The rest for one client; follows the above.
std::string encode_own_attribute_changes(const AttributeChanges& changes, ClientId client,
                                         PlayerRole role);
// A complete table; never empty.
std::string encode_attribute_table(const AttributeTable& table, std::uint32_t tick,
                                   PlayerRole role);
std::string encode_own_attributes(const AttributeTable& table, std::uint32_t tick, ClientId client,
                                  PlayerRole role);

}  // namespace jostle::server
