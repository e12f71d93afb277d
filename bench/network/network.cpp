// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <deque>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/captured_scene.h"
#include "bench/measure.h"
#include "bench/network/giesen_model.h"
#include "bench/network/precise_frames.h"
#include "bench/result_file.h"
#include "jostle/snapshot/frame_codec.h"

namespace jostle::bench {
namespace {

constexpr const char* network_footer = R"(
Every tick of the scene katamari (901 cubes; a large one rolls by itself and attracts the small
ones) is encoded relative to the frame that is --baseline-age ticks older, and to the two frames
before that one at the same distance. Frames of codec 1 and 2 are decoded and compared; a difference
ends the run. Rotations have 10 bits as in the server (M = 511) and 9 bits as in Giesen's model
(M = 255); compare rows with equal M. The models of giesen continue from frame to frame along each
chain of bases; those of codec 2 are reset for every frame.

Then every second tick of the scene asteroids (250 asteroids at 30 updates/s, the rules of
KinematicSoup's UnityNetworkTransformBenchmark) is encoded with codec 2 in the precision of
--precision, after 30 s. Its rows have the precision instead of base and M. The first row has poses
within 0.01 m and 0.001 rad of the true ones; the row "default" has poses that are rounded to the
nearest units of the server's default. A decoded pose that exceeds the precision ends the run.
Reactor sends the original scene with 10 kB/s of goodput, PurrNet with 95, FishNet with 98, Photon
Fusion 2 with 107, Mirror with 117, Unity NGO with 185 (the benchmark's own figures).

Columns: base (ticks to the base), M, codec, bytes (per frame: mean and 99th percentile), kbit/s (at
60 Hz), moving (cubes per frame whose pose differs from the base), encode and decode (us of CPU time
per frame).

Examples:
  jostle-bench network
  jostle-bench network --seconds 20 --baseline-age 1 --json network.json
  jostle-bench network --scene asteroids_1000 --precision 0.005,0.001

Exit status: 0 success, 1 a decoded frame differs, or the file could not be written, 2 invalid
flags.)";

struct NetworkFlags {
    double seconds = 45;
    std::vector<int> baselines = {1, 6};
    std::string scene = "asteroids";                // of the rows with a precision
    std::vector<double> precision = {0.01, 0.001};  // m and rad
    std::string json;
};

struct Row {
    std::string codec;
    int baseline = 0, m = 0;
    double moving = 0, hz = 60;
    std::vector<double> bytes;
    double encode_us = 0, decode_us = 0;  // per frame; decode 0: no decoder
};

using Frames = std::vector<snapshot::QuantizedFrame>;

// Returns false if a decoded frame differs from the original.
bool run_codec(Row& row, const Frames& frames, std::size_t age, const snapshot::QuantSpec& spec,
               snapshot::Codec codec) {
    for (std::size_t i = 3 * age; i < frames.size(); i++) {
        const snapshot::Baselines baselines{&frames[i - age], &frames[i - 2 * age],
                                            &frames[i - 3 * age]};
        const double began = cpu_seconds();
        const auto packed = snapshot::encode_frame(frames[i], baselines, spec, codec);
        const double encoded = cpu_seconds();
        const auto decoded = snapshot::decode_frame(frames[i].frame, packed, baselines, spec,
                                                    snapshot::default_entities_max, codec);
        row.decode_us += 1e6 * (cpu_seconds() - encoded);
        row.encode_us += 1e6 * (encoded - began);
        row.bytes.push_back(static_cast<double>(packed.size()));
        if (!decoded.ok() || *decoded != frames[i]) return false;
    }
    return true;
}

void run_giesen(Row& row, const Frames& frames, std::size_t age, const snapshot::QuantSpec& spec) {
    // The player is the last body. The ground never moves, so it costs next to nothing.
    const GiesenCoder coder(frames[0].entities.size() - 1, spec.rotation_component);
    std::deque<GiesenCoder::StatePtr> states(age);  // of the last frames
    for (std::size_t i = age; i < frames.size(); i++) {
        const double began = cpu_seconds();
        GiesenCoder::Coded coded = coder.encode(frames[i], frames[i - age], states.front());
        const double spent = cpu_seconds() - began;
        states.pop_front();
        states.push_back(std::move(coded.state));
        if (i < 3 * age) continue;
        row.encode_us += 1e6 * spent;
        row.bytes.push_back(static_cast<double>(coded.bytes.size()));
    }
}

nlohmann::ordered_json to_json(const Row& row) {
    nlohmann::ordered_json json = {
        {"codec", row.codec},
        {"base_ticks", row.baseline},
        {"rotation_component", row.m},
        {"moving_per_frame", rounded(row.moving)},
        {"bytes_per_frame", rounded(mean(row.bytes))},
        {"bytes_99", rounded(percentile_99(row.bytes))},
        {"kbit_per_second", rounded(mean(row.bytes) * 8 * row.hz / 1000)},
        {"encode_us", rounded(row.encode_us)}};
    if (row.decode_us > 0) json["decode_us"] = rounded(row.decode_us);
    return json;
}

void print_row(const Row& row) {
    std::printf("%4d %5d  %-8s %7.1f %6.0f %7.1f %7.1f %8.1f", row.baseline, row.m,
                row.codec.c_str(), mean(row.bytes), percentile_99(row.bytes),
                mean(row.bytes) * 8 * row.hz / 1000, row.moving, row.encode_us);
    if (row.decode_us > 0) std::printf(" %8.1f", row.decode_us);
    std::printf("\n");
    std::fflush(stdout);
}

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

double mean_moving(const Frames& frames, std::size_t age) {
    std::size_t moving = 0;
    for (std::size_t i = 3 * age; i < frames.size(); i++)
        moving += count_moving(frames[i], frames[i - age]);
    return static_cast<double>(moving) / static_cast<double>(frames.size() - 3 * age);
}

// Measures the rows of one quantization; returns false after reporting an error.
bool measure(nlohmann::ordered_json& rows, const NetworkFlags& flags,
             const snapshot::QuantSpec& spec) {
    show_progress("katamari");
    const auto recorded = capture_scene("katamari", flags.seconds, spec);
    show_progress("");
    if (!recorded.ok()) {
        std::fprintf(stderr, "jostle-bench: %s\n", recorded.error().message.c_str());
        return false;
    }
    for (const int baseline : flags.baselines)
        for (const char* codec : {"1", "2", "giesen"}) {
            const auto age = static_cast<std::size_t>(baseline);
            Row row{.codec = codec, .baseline = baseline, .m = spec.rotation_component};
            row.hz = recorded->hz;
            row.moving = mean_moving(recorded->frames, age);
            if (row.codec == "giesen")
                run_giesen(row, recorded->frames, age, spec);
            else if (!run_codec(
                         row, recorded->frames, age, spec,
                         row.codec == "1" ? snapshot::Codec::bits : snapshot::Codec::range)) {
                std::fprintf(stderr,
                             "jostle-bench: codec %s: a decoded frame differs from the original\n",
                             codec);
                return false;
            }
            row.encode_us /= static_cast<double>(row.bytes.size());
            row.decode_us /= static_cast<double>(row.bytes.size());
            print_row(row);
            rows.push_back(to_json(row));
        }
    return true;
}

// Measures the rows with a precision; returns false after reporting an error.
bool measure_precision(nlohmann::ordered_json& rows, const NetworkFlags& flags) {
    std::printf("\n%-16s %10s %8s %7s %6s %7s %7s %8s %8s\n", "scene", "m", "rad", "bytes", "99 %",
                "kB/s", "moving", "encode", "decode");
    for (const snapshot::Precision& precision :
         {snapshot::Precision{flags.precision[0], flags.precision[1]}, snapshot::Precision{}}) {
        const PreciseFrames settings{.scene = flags.scene,
                                     .settle_seconds = 30,
                                     .seconds = flags.seconds,
                                     .precision = precision};
        show_progress(flags.scene);
        const auto result = measure_precise_frames(settings);
        show_progress("");
        if (!result.ok()) {
            std::fprintf(stderr, "jostle-bench: %s\n", result.error().message.c_str());
            return false;
        }
        const double bytes = mean(result->bytes);
        const double kilobytes = bytes * settings.updates_hz / 1000;
        const auto text = [&](double value) {
            return precision.is_set() ? number_text(value) : std::string("default");
        };
        std::printf("%-16s %10s %8s %7.1f %6.0f %7.2f %7.1f %8.1f %8.1f\n", flags.scene.c_str(),
                    text(precision.position_m).c_str(), text(precision.rotation_rad).c_str(), bytes,
                    percentile_99(result->bytes), kilobytes, result->moving, result->encode_us,
                    result->decode_us);
        std::fflush(stdout);
        rows.push_back({{"scene", flags.scene},
                        {"codec", "2"},
                        {"position_precision_m", precision.position_m},
                        {"rotation_precision_rad", precision.rotation_rad},
                        {"position_error_m", result->position_error_m},
                        {"rotation_error_rad", result->rotation_error_rad},
                        {"updates_hz", settings.updates_hz},
                        {"moving_per_frame", rounded(result->moving)},
                        {"bytes_per_frame", rounded(bytes)},
                        {"bytes_99", rounded(percentile_99(result->bytes))},
                        {"kilobytes_per_second", rounded(kilobytes)},
                        {"encode_us", rounded(result->encode_us)},
                        {"decode_us", rounded(result->decode_us)}});
    }
    return true;
}

int run_network(const NetworkFlags& flags) {
    const snapshot::Precision precision{flags.precision[0], flags.precision[1]};
    if (const Status s = snapshot::check(precision, "--precision: "); !s.ok()) {
        std::fprintf(stderr, "jostle-bench: %s\n", s.error().message.c_str());
        return 2;
    }
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    std::printf("%4s %5s  %-8s %7s %6s %7s %7s %8s %8s\n", "base", "M", "codec", "bytes", "99 %",
                "kbit/s", "moving", "encode", "decode");
    for (const std::int32_t m : {511, 255})
        if (!measure(rows, flags, {.units_per_meter = 512, .rotation_component = m})) return 1;
    if (!measure_precision(rows, flags)) return 1;
    if (flags.json.empty()) return 0;
    const nlohmann::ordered_json head = {{"benchmark", "network"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"scene", "katamari"},
                                         {"seconds", flags.seconds}};
    return write_result(flags.json, head, rows) ? 0 : 1;
}

}  // namespace

void add_network(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("network", "Measure bytes and time of snapshots by codec");
    const auto flags = std::make_shared<NetworkFlags>();
    command
        ->add_option("--seconds", flags->seconds,
                     "Simulated seconds of the scene [default: 45; 1 to 600]")
        ->type_name("SECONDS")
        ->check(CLI::Range(1.0, 600.0).description(""));
    command
        ->add_option("--baseline-age", flags->baselines,
                     "Ticks between a frame and its base [default: 1,6; 1 to 15]")
        ->type_name("TICKS")
        ->delimiter(',')
        ->check(CLI::Range(1, 15).description(""));
    command
        ->add_option("--scene", flags->scene,
                     "Scene of the rows with a precision [default: asteroids]")
        ->type_name("SCENE");
    command
        ->add_option("--precision", flags->precision,
                     "Precision of these rows [default: 0.01,0.001; 0.0001 to 1 m, 0.0002 to 0.5 "
                     "rad]")
        ->type_name("METRES,RADIANS")
        ->delimiter(',')
        ->expected(2);
    command->add_option("--json", flags->json, "Write the results as JSON")->type_name("FILE");
    command->footer(network_footer);
    command->callback([flags, &status] { status = run_network(*flags); });
}

}  // namespace jostle::bench
