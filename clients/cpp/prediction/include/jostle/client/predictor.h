// SPDX-License-Identifier: MIT
//
// Foresees what the inputs of this client do, with the server's own solver: the body that it pushes
// moves in the picture of the input instead of a round trip later. Around that body it keeps a
// small world: what is near, and all that stands still. It steps that world to the tick that inputs
// of now are meant for. A frame of the server tells what became of an earlier tick: where that is
// not what was foreseen, the world goes back to it and takes the steps since then again, with the
// inputs since then; what that changes in the picture is walked off (PoseError).
//
//     auto me = Client::connect(loop, {.timed_inputs = true, ...});
//     input.set_tick(me->input_tick(now));               // an impulse, say
//     predictor.add_input(me->send(input), input);
//     // Once a picture:
//     me->read([&](const WorldView& world) { predictor.on_frame(world); });
//     predictor.on_results(me->take_results());
//     draw(predictor.sample(me->input_position(now), now_us, me->interpolated(now)));
//
// What it foresees: impulses, what hands hold and drag, and the car or character that the client
// drives, if that is who is followed; not joints of the scene, for clients are not told of them.
// Velocities, and what is driven, are told to who names motion_channel in ClientOptions::channels,
// for a few bytes more of each body that is awake; else velocities are estimated from frames where
// the server disagrees. One thread at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/client/interpolation.h"
#include "jostle/client/predictor_options.h"
#include "jostle/client/world_view.h"

namespace jostle::client {

inline constexpr const char* motion_channel = "jostle.motion";

class Predictor {
public:
    explicit Predictor(PredictorOptions options = {});
    ~Predictor();

    // A stream begins: everything is forgotten.
    void begin(const v1::Welcome& welcome);
    // Whose motion is foreseen; 0: nobody's.
    void follow(std::uint32_t entity);
    // An input was queued under that number. One that names no tick is not foreseen.
    void add_input(std::uint32_t sequence, const v1::Input& input);
    // What became of them: of a refused one, and of one that came late, the steps are taken again.
    void on_results(const std::vector<v1::InputResult>& results);
    // The newest frame of the view, if it is a new one.
    void on_frame(const WorldView& view);

    // The picture of now (our clock, microseconds): what is foreseen at that place of the input
    // clock, in ticks, and all others where they are interpolated.
    std::vector<SmoothPose> sample(double position, std::int64_t now_us,
                                   std::vector<SmoothPose> interpolated);

    using Stats = PredictorStats;
    const Stats& stats() const;
    std::size_t bodies() const;  // that are foreseen

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
