// SPDX-License-Identifier: MIT
//
// The server's configuration: TOML or not, with settings in their ranges or not. A refusal names
// the file and leaves all as it was.
#include "server/config/config_loader.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    server::Config config;
    const std::string text(text_of(input));
    const Status loaded = server::load_config_text(config, text, "server.toml");
    if (loaded.ok()) return expect(server::check(config).ok(), "what was taken is in its range");
    expect(loaded.error().message.starts_with("server.toml"), "a refusal names the file");
    expect(config.listen == server::Config().listen, "a refusal changes nothing");
}

}  // namespace jostle::fuzz
