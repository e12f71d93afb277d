// SPDX-License-Identifier: MIT
//
// The behaviour of bots, from a small text file. One behaviour per line:
//
//    behaviour  weight=N  key=value ...      # a comment
//
// Each bot has one behaviour, in proportion to the weights. Behaviours and their keys with
// defaults:
//
//    wander   period=2 strength=4        rolls its own ball: an impulse of `strength` m/s every
//                                        `period` s
//    push     period=1 strength=3        pushes a random body towards the centre with `strength`
//    m/s throw    period=2 speed=12 max_bodies=5   throws balls across the yard; at most
//    `max_bodies`
//                                        exist at a time
//    builder  period=1 max_bodies=8 size=0.3   stacks boxes of `size` m; at most `max_bodies` exist
//                                        at a time
//    drag     period=3                   grabs and carries a random body for half of each period
//    drive    period=0.2 change=20       takes control of a random controllable entity and drives
//    it;
//                                        switches to another one every `change` s
//    walk     period=0.5 change=20       likewise on foot: walks in its view direction and jumps
//    race     period=0.1 radius=45 speed=16   drives one entity around the centre, to the left, at
//    a
//                                        distance of `radius` m and `speed` m/s
//    idle                                sends no inputs
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::bot {

struct ScriptLine {
    std::string behaviour;
    double weight = 1;
    std::map<std::string, double> values;  // all keys of the behaviour, with defaults
};

using Script = std::vector<ScriptLine>;

// Errors contain file and line.
Result<Script> parse_script(const std::string& text, const std::string& name);
Result<Script> load_script(const std::string& path);

// The script of bots without a script file: a mixture of behaviours.
Script default_script();

// Like load_script; an empty path selects the default script.
Result<Script> script_or_default(const std::string& path);

// Selects the line of bot i, so that the number of bots per line is proportional to the weights.
const ScriptLine& line_for(const Script& script, int i);

}  // namespace jostle::bot
