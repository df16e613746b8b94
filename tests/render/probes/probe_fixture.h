// Purpose: test fixture for graphs that read the irradiance probes of a scene.
#pragma once

#include <cstring>

#include "tests/render/session_fixture.h"

namespace weft::test {

// What a graph has left. Keys: the names of observed resources and of readback passes.
struct ProbeResults {
    std::map<std::string, std::vector<glm::vec4>> images;
    std::map<std::string, std::vector<std::byte>> buffers;
};

class ProbeTest : public SessionTest {
 protected:
    std::unique_ptr<render::Session> start_with_probes(const scene::Scene& scene, scene::Probes probes,
                                                       const std::string& graph, Extent3D size,
                                                       std::vector<std::string> observed,
                                                       const std::map<std::string, double>& params = {}) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = graph;
        input.request.size = size;
        input.request.observed = std::move(observed);
        for (const auto& [name, value] : params) input.request.params[name] = value;
        input.load.reader = read_text;
        input.load.reads_disk = true;
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.check_plan = true;
        input.probes = std::move(probes);
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        return session ? std::move(*session) : nullptr;
    }

    static ProbeResults take_results(render::Session& session) {
        ProbeResults results;
        const std::string observed = "observe:";
        for (vk::ReadbackData& data : session.take_readbacks()) {
            if (data.pass.starts_with(observed))
                results.images[data.pass.substr(observed.size())] =
                    render::decode_texels(data.format, data.bytes);
            else
                results.buffers[data.pass] = std::move(data.bytes);
        }
        return results;
    }
};

}  // namespace weft::test
