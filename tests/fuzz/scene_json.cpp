// SPDX-License-Identifier: MIT
//
// Scene files: text that is JSON or not, with the fields of a scene or others.
#include <google/protobuf/util/json_util.h>

#include "jostle/scenes/scene_file.h"
#include "tests/fuzz/exercise_scene.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const std::string_view text = text_of(input);
    if (text.find("repeat") != std::string_view::npos) {
        v1::Scene message;
        const google::protobuf::StringPiece piece(text.data(), text.size());
        static_cast<void>(google::protobuf::util::JsonStringToMessage(piece, &message));
        if (is_too_large(message)) return;
    }
    const auto scene = scenes::read_scene_json(text);
    if (!scene.ok()) return expect(!scene.error().message.empty(), "a refusal has a reason");
    const auto again = scenes::read_scene_json(scenes::write_scene_json(*scene));
    expect(again.ok(), again.ok() ? "" : "what was written is refused: " + again.error().message);
    exercise_scene(*scene);
}

}  // namespace jostle::fuzz
