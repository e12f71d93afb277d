// SPDX-License-Identifier: MIT
//
// What bots do, from a small text file. One behaviour a line:
//
//     behaviour  weight=N  key=value ...      # a comment
//
// Each bot takes one behaviour, in proportion to the weights. Behaviours and their keys, with
// defaults:
//
//     wander   period=2 strength=4        rolls a ball of its own about: a push of `strength` m/s
//                                         every `period` s
//     push     period=1 strength=3        shoves something towards the middle, by `strength` m/s
//     throw    period=2 speed=12 max_bodies=5   throws a ball over the yard; at most `max_bodies`
//     at a time builder  period=1 max_bodies=8 size=0.3   stacks boxes of `size` m; at most
//     `max_bodies` at a time drag     period=3                   carries something about for half
//     of each period drive    period=0.2 change=20       takes something that can be driven and
//     steers it about;
//                                         every `change` s something else
//     walk     period=0.5 change=20       the same on foot: looks where it goes, jumps now and then
//     race     period=0.1 radius=45 speed=16   drives one thing round the middle of the world, to
//                                         the left, `radius` m from it at `speed` m/s
//     idle                               sends nothing
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::bots {

struct ScriptLine {
    std::string behaviour;
    double weight = 1;
    std::map<std::string, double>
        values;  // every key that the behaviour knows, with defaults filled in
};

using Script = std::vector<ScriptLine>;

// An error names file and line.
Result<Script> parse_script(const std::string& text, const std::string& name);
Result<Script> load_script(const std::string& path);

// What bots do when no script is given: a little of everything.
Script default_script();

// As load_script; an empty path gives the default.
Result<Script> script_or_default(const std::string& path);

// The line for bot number i of n: weights decide how many bots take each.
const ScriptLine& line_for(const Script& script, int i);

}  // namespace jostle::bots
