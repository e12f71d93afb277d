// SPDX-License-Identifier: MIT
//
// Predicts the effect of this client's inputs with the server's own solver: a body that the client
// pushes moves in the rendered frame of the input instead of one round trip later. The predictor
// simulates a small local world around that body: nearby bodies and all static ones. It steps that
// world to the tick for which inputs made now are meant. A frame of the server contains the state
// of an earlier tick. If that state differs from the prediction, the predictor rolls the local
// world back to it and repeats the steps since then with their inputs. The resulting change of the
// rendered poses is smoothed (PoseError).
//
//     auto me = Client::connect(loop, {.timed_inputs = true, ...});
//     input.set_tick(me->input_tick(now));               // an impulse, for example
//     predictor.add_input(me->send(input), input);
//     // Once per rendered frame:
//     me->read([&](const WorldView& world) { predictor.on_frame(world); });
//     predictor.on_results(me->take_results());
//     draw(predictor.sample(me->input_position(now), now_us, me->interpolated(now)));
//
// The predictor covers impulses, grabbed and dragged bodies, and the car or character that the
// client controls if it is the followed entity. It does not cover joints of the scene, because the
// server does not send them. Clients that name motion_channel in ClientOptions::channels receive
// velocities and the state of the controlled entity, for a few more bytes per awake body. Otherwise
// the predictor estimates velocities from frames that differ from its prediction. One thread at a
// time.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/client/interpolation.h"
#include "jostle/client/predictor_options.h"
#include "jostle/client/world_view.h"

namespace jostle::client {

/// Channel with body velocities (proto/WIRE.md, "Channels").
inline constexpr const char* motion_channel = "jostle.motion";

/// Predictor of one client.
class Predictor {
public:
    explicit Predictor(PredictorOptions options = {});
    ~Predictor();

    /// Starts a stream and discards all state.
    void begin(const v1::Welcome& welcome);
    /// Selects the entity whose motion is predicted; 0: none.
    void follow(std::uint32_t entity);
    /// Adds an input that was queued under this sequence number. Inputs without a tick are not
    /// predicted.
    void add_input(std::uint32_t sequence, const v1::Input& input);
    /// Adds results of inputs. Steps with a rejected or late input are repeated.
    void on_results(const std::vector<v1::InputResult>& results);
    /// Compares the prediction with the newest frame of the view, if it is new.
    void on_frame(const WorldView& view);

    /// Returns the poses to render now (local clock, us). `position`: of the input clock, in ticks.
    /// Predicted bodies have their predicted poses at that position, all others their interpolated
    /// poses.
    std::vector<SmoothPose> sample(double position, std::int64_t now_us,
                                   std::vector<SmoothPose> interpolated);

    using Stats = PredictorStats;
    /// Statistics since the predictor was created.
    const Stats& stats() const;
    std::size_t bodies() const;  ///< number of predicted bodies

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
