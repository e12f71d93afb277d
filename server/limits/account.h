// SPDX-License-Identifier: MIT
//
// Accounts: the players that share limits. The clients of one subject have one account; without
// authentication, the clients of one network have. Any thread.
#pragma once

#include <string>
#include <string_view>

#include "server/world/command.h"

namespace jostle::server {

// `subject`: from the token; empty or anonymous_subject: there is none. Ids are hashes with a key
// of this process, so nobody can choose a subject that shares the account of another.
AccountId account_of(std::string_view subject, std::string_view address);

}  // namespace jostle::server
