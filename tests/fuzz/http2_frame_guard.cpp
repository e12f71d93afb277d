// SPDX-License-Identifier: MIT
//
// What clients of the gRPC port send, frame by frame: however the bytes are cut, the guard says the
// same, and it never lets a connection owe more than a few seconds of work.
#include "server/grpc_proxy/http2_frame_guard.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

// What became of some bytes.
struct Verdict {
    bool accepted = true;
    std::string why;
    std::uint64_t streams = 0;

    bool operator==(const Verdict&) const = default;
};

// In pieces of so many bytes; time passes only between the halves of the input, so that it does not
// depend on the pieces.
Verdict run_guard(Bytes input, std::size_t piece) {
    const server::Clock::time_point began{};
    server::Http2FrameGuard guard(began);
    Verdict verdict;
    for (std::size_t at = 0; at < input.size() && verdict.accepted;) {
        const bool second_half = at >= input.size() / 2;
        const std::size_t end = second_half ? input.size() : input.size() / 2;
        const Bytes bytes = input.subspan(at, std::min(piece, end - at));
        const auto now = began + std::chrono::seconds(second_half ? 10 : 0);
        const Status allowed = guard.take(bytes, now);
        verdict.accepted = allowed.ok();
        if (!allowed.ok()) verdict.why = allowed.error().message;
        at += bytes.size();
        expect(guard.throttle_delay(now) < std::chrono::seconds(30),
               "a short input is paid for soon");
    }
    // What was cut stays as it was when its piece was given.
    if (verdict.accepted) verdict.streams = guard.streams_opened();
    return verdict;
}

}  // namespace

void run(Bytes input) {
    const Verdict whole = run_guard(input, input.size() + 1);
    for (const std::size_t piece : {1, 7, 24})
        expect(run_guard(input, piece) == whole, "how bytes are cut makes no difference");
    expect(whole.streams <= input.size() / 9, "a stream takes a frame");
}

}  // namespace jostle::fuzz
