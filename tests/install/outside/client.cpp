// SPDX-License-Identifier: MIT
//
// Asks a server that is not there for its worlds: links against the installed client, and shows
// that its errors say what was wrong.
#include <jostle/client/client.h>
#include <jostle/client/world_client.h>
#include <cstdio>

int main() {
    jostle::client::WorldClient worlds("127.0.0.1:9");
    const auto list = worlds.list();
    if (list.ok()) return 1;
    std::printf("%s\n", list.error().message.c_str());
    return list.error().message.empty() ? 1 : 0;
}
