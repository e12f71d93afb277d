// SPDX-License-Identifier: MIT
#include "server/limits/account.h"

#include <cstdint>
#include <functional>
#include <random>

#include "server/auth/identity.h"
#include "server/util/address.h"

namespace jostle::server {

AccountId account_of(std::string_view subject, std::string_view address) {
    static const std::string key = [] {
        std::random_device random;
        return std::to_string(random()) + ' ' + std::to_string(random()) + ' ';
    }();
    const bool anonymous = subject.empty() || subject == anonymous_subject;
    const std::string name =
        anonymous ? "network " + network_of(address) : "subject " + std::string(subject);
    const AccountId id = std::hash<std::string>{}(key + name);
    return id == 0 ? 1 : id;  // 0: nobody
}

}  // namespace jostle::server
