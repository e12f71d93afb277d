// SPDX-License-Identifier: MIT
//
// wire-bench: bits and time of snapshots of the catalogue's scenes. Every frame is decoded and
// compared with the original; a difference ends the run.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/command_line/command_line.h"
#include "bench/captured_scene.h"
#include "bench/measure.h"
#include "jostle/snapshot/frame_codec.h"

namespace {

using namespace jostle;

constexpr const char* footer = R"(
Columns: age (ticks from a frame to its base, and between its bases), moving (bodies per frame whose
pose differs from the base), bytes (per frame, mean), bits (per moving body), encode, decode (ns of
one core per moving body, including the cost of bodies at rest).

Examples:
  wire-bench
  wire-bench pile --seconds 20 --baseline-age 1 --baseline-age 6 --json wire.json

Exit status: 0 success, 1 a decoded frame differs or a scene failed, 2 invalid flags.)";

struct Flags {
    std::vector<std::string> scenes = {"sandbox", "pile", "pyramid", "dominoes", "billiards"};
    std::vector<int> ages = {1, 2, 6};
    std::vector<std::uint32_t> codecs = {1, 2};
    double seconds = 10;
    std::string json;
};

struct CodecCost {
    double moving = 0, bytes = 0, bits = 0, encode_ns = 0, decode_ns = 0;
};

// Uses every age-th frame, like a client with that share of the world's rate.
std::optional<CodecCost> measure(const std::vector<snapshot::QuantizedFrame>& frames,
                                 std::size_t age, snapshot::Codec codec) {
    double encoding = 0, decoding = 0;
    std::size_t bytes = 0, moving = 0, count = 0;
    for (std::size_t i = 3 * age; i < frames.size(); i += age) {
        const snapshot::Baselines baselines{&frames[i - age], &frames[i - 2 * age],
                                            &frames[i - 3 * age]};
        const auto began = bench::cpu_seconds();
        const auto packed = snapshot::encode_frame(frames[i], baselines, {}, codec);
        const auto encoded = bench::cpu_seconds();
        const auto decoded =
            snapshot::decode_frame(frames[i].frame, packed, baselines, {}, 1u << 20, codec);
        decoding += bench::cpu_seconds() - encoded;
        encoding += encoded - began;
        if (!decoded.ok() || *decoded != frames[i]) {
            std::fprintf(stderr, "wire-bench: frame %u: decoding failed: %s\n", frames[i].frame,
                         decoded.ok() ? "the frame differs from the original"
                                      : decoded.error().message.c_str());
            return std::nullopt;
        }
        bytes += packed.size();
        moving += bench::count_moving(frames[i], frames[i - age]);
        count++;
    }
    const double per_frame = static_cast<double>(std::max<std::size_t>(count, 1));
    const double per_moving = static_cast<double>(std::max<std::size_t>(moving, 1));
    return CodecCost{.moving = static_cast<double>(moving) / per_frame,
                     .bytes = static_cast<double>(bytes) / per_frame,
                     .bits = 8 * static_cast<double>(bytes) / per_moving,
                     .encode_ns = encoding * 1e9 / per_moving,
                     .decode_ns = decoding * 1e9 / per_moving};
}

int run(const Flags& flags) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    std::printf("%-10s %6s %4s %5s %8s %8s %6s %8s %8s\n", "scene", "bodies", "age", "codec",
                "moving", "bytes", "bits", "encode", "decode");
    for (const std::string& scene : flags.scenes) {
        const auto recording = bench::capture_scene(scene, flags.seconds, {});
        if (!recording.ok()) {
            std::fprintf(stderr, "wire-bench: %s\n", recording.error().message.c_str());
            return 1;
        }
        const std::size_t bodies =
            recording->frames.empty() ? 0 : recording->frames[0].entities.size();
        for (const int age : flags.ages)
            for (const std::uint32_t codec : flags.codecs) {
                const auto f = measure(recording->frames, static_cast<std::size_t>(age),
                                       static_cast<snapshot::Codec>(codec));
                if (!f) return 1;
                std::printf("%-10s %6zu %4d %5u %8.1f %8.1f %6.1f %8.0f %8.0f\n", scene.c_str(),
                            bodies, age, codec, f->moving, f->bytes, f->bits, f->encode_ns,
                            f->decode_ns);
                std::fflush(stdout);
                rows.push_back({{"scene", scene},
                                {"bodies", bodies},
                                {"age_ticks", age},
                                {"codec", codec},
                                {"moving_per_frame", f->moving},
                                {"bytes_per_frame", f->bytes},
                                {"bits_per_moving_body", f->bits},
                                {"encode_ns_per_moving_body", f->encode_ns},
                                {"decode_ns_per_moving_body", f->decode_ns},
                                {"quantize_ns_per_body", recording->quantize_ns_per_body}});
            }
    }
    if (flags.json.empty()) return 0;
    std::ofstream out(flags.json);
    out << rows.dump(2) << "\n";
    if (out) return 0;
    std::fprintf(stderr, "wire-bench: cannot write %s\n", flags.json.c_str());
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Measure bits and time per moving body of the snapshots of the catalogue's scenes"};
    Flags flags;
    app.add_option("scenes", flags.scenes,
                   "Scenes by name\n[default: sandbox pile pyramid dominoes billiards]")
        ->type_name("NAME");
    app.add_option("--seconds", flags.seconds,
                   "Simulated seconds of each scene [default: 10; 0.5 to 600]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.5, 600.0).description(""));
    app.add_option("--baseline-age", flags.ages,
                   "Ticks between a frame and its base; repeatable\n[default: 1 2 6; 1 to 60]")
        ->type_name("TICKS")
        ->check(CLI::Range(1, 60).description(""));
    app.add_option("--codec", flags.codecs, "Codec; repeatable [default: 1 2; 1 or 2]")
        ->type_name("CODEC")
        ->check(CLI::Range(1, 2).description(""));
    app.add_option("--json", flags.json, "Write the results as JSON")->type_name("FILE");
    app.footer(footer);
    if (const auto status =
            jostle::parse_command_line(app, {"wire-bench", JOSTLE_VERSION}, argc, argv))
        return *status;
    return run(flags);
}
