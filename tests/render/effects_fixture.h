// Purpose: test fixture that runs only some passes of a shipped effect, on a picture that a test draws.
#pragma once

#include <nlohmann/json.hpp>

#include "tests/render/session_fixture.h"

namespace weft::test {

using Json = nlohmann::ordered_json;
using Image = std::vector<glm::vec4>;

inline Json shipped(const std::string& name) {
    return Json::parse(read_text(graph_path(name)).value_or("{}"), nullptr, true, true);
}

// Returns a graph that begins with the pass `picture`, which writes `hdr`. The passes `passes` of the module
// `name` follow. `resources` are the resources of the module that these passes need. The first
// pass gets the name "glass", because the effect reads the picture as "hdr@glass": in the shipped graphs,
// "glass" is the last pass before the effect. A last pass, "show", writes `hdr` to the output.
inline Json behind_picture(const std::string& name, const Json& picture,
                           std::initializer_list<const char*> passes,
                           std::initializer_list<const char*> resources) {
    const Json whole = shipped("modules/" + name);
    Json graph{{"version", 1}, {"name", name}, {"imports", {{"backbuffer", "output"}}}};
    graph["params"] = whole.at("params");
    graph["params"]["exposure"] = {{"default", 0}};
    if (whole.contains("sizes")) graph["sizes"] = whole.at("sizes");
    graph["resources"] = {{"hdr", {{"format", "rgba16f"}}}, {"depth", "d32f"}};
    for (const char* resource : resources) graph["resources"][resource] = whole.at("resources").at(resource);
    graph["passes"]["glass"] = picture;
    for (const char* pass : passes) graph["passes"][pass] = whole.at("passes").at(pass);
    graph["passes"]["show"] = {
        {"type", "fullscreen"}, {"shader", "tonemap/tonemap.frag"}, {"in", {"hdr"}}, {"out", {"backbuffer"}}};
    return graph;
}

class ShippedEffects : public SessionTest {
 protected:
    // Renders `count` frames of `graph`, which the session reads as if it were the file `path`. Returns the
    // decoded content of the observed resources for each frame. The key is the observed reference, such as
    // "hdr@glass".
    std::vector<std::map<std::string, Image>> frames(const Json& graph, const std::string& path,
                                                     Extent3D size, uint32_t count,
                                                     std::vector<std::string> observed) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        const FileReader reader = [&](const std::string& file) {
            return file == path ? std::optional(graph.dump(2)) : read_text(file);
        };
        const std::unique_ptr<render::Session> session =
            start(*scene, scene->cameras.at(0), path, size, std::move(observed), scene->exposure_ev, reader);
        if (!session) return {};
        for (uint32_t i = 0; i < count; ++i) EXPECT_TRUE(draw_frame(*session));
        EXPECT_TRUE(session->finish());
        view_ = session->parts().frames.view();
        std::vector<std::map<std::string, Image>> seen(count);
        for (const vk::ReadbackData& data : session->take_readbacks())
            seen.at(data.frame_index)[data.pass.substr(std::string("observe:").size())] =
                render::decode_texels(data.format, data.bytes);
        return seen;
    }
    std::map<std::string, Image> picture(const Json& graph, Extent3D size,
                                         std::vector<std::string> observed) {
        auto seen =
            frames(graph, WEFT_SOURCE_DIR "/tests/render/pictures/graph.json", size, 1, std::move(observed));
        return seen.empty() ? std::map<std::string, Image>{} : std::move(seen[0]);
    }

    // View constants of the last frame that frames() rendered.
    shared::ViewConstants view_{};
};

}  // namespace weft::test
