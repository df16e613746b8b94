// Purpose: test fixture that renders a scene and reads back the resources that the test needs. The device
// runs with validation by default. render() uses graphs/deferred.json unless a test names another graph.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "render/session_parts.h"
#include "weft/registry.h"
#include "weft/render/session.h"
#include "weft/render/texels.h"
#include "weft/scene/builtin_scenes.h"
#include "weft/vulkan/device.h"
#include "weft/vulkan/shared_pipelines.h"

namespace weft::test {

// The path of a shipped graph that many tests use.
inline constexpr const char* kDeferredGraph = WEFT_SOURCE_DIR "/graphs/deferred.json";

// A parameter of the shipped graphs: only single reflections at microfacets, as in the BRDFs of papers.
inline const render::ParameterValues kSingleReflections{{"multipleScattering", 0}};

// Returns the path of a shipped graph.
inline std::string graph_path(const std::string& name) {
    return WEFT_SOURCE_DIR "/graphs/" + name + ".json";
}

inline std::optional<std::string> read_text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

// Returns the input for the next frames of a session. SessionTest::start() sets the camera and the exposure
// in this input, and tests may change all its members.
inline render::FrameInput& frame_of(const render::Session& session) {
    static std::map<const render::Session*, render::FrameInput> frames;
    return frames[&session];
}

inline Status draw_frame(render::Session& session, double time_s = 0, double delta_time_s = 0) {
    render::FrameInput& frame = frame_of(session);
    frame.time_s = time_s;
    frame.delta_time_s = delta_time_s;
    return session.render_frame(frame);
}

struct Rendered {
    // Decoded images. The key is the reference that the test observed, such as "hdr@glass".
    std::map<std::string, std::vector<glm::vec4>> images;
    shared::ViewConstants view{};
    std::vector<shared::Light> lights;
    float pre_exposure = 1;
};

class SessionTest : public ::testing::Test {
 protected:
    void SetUp() override { make_device(true); }
    void make_device(bool validate) {
        vk::DeviceOptions options;
        options.validate = validate;
        options.queues = queues_;
        // The time-out is long, so that the test does not fail on a busy machine.
        options.timeout_ns = 1'500'000'000'000;
        Result<std::unique_ptr<vk::Device>> made = vk::Device::create(options);
        ASSERT_TRUE(made) << to_text(made.errors());
        device_ = std::move(*made);
    }
    void TearDown() override {
        last_rendered_.reset();
        pipelines_.reset();
        if (!device_) return;
        for (const vk::Message& m : device_->messages().messages()) ADD_FAILURE() << m.id << ": " << m.text;
    }

    // Starts a session that renders `scene` with `graph`. On an error, the test fails and the result is null.
    std::unique_ptr<render::Session> start(const scene::Scene& scene, const scene::Camera& camera,
                                           const std::string& graph, Extent3D size,
                                           std::vector<std::string> observed, float exposure_ev = 0,
                                           const FileReader& reader = read_text) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.request.path = graph;
        input.request.size = size;
        input.request.observed = std::move(observed);
        input.request.params = params_;
        input.load.reader = reader;
        input.load.reads_disk = true;
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.check_plan = true;
        input.queues = queues_;
        input.probes = probes_;
        input.adds_parts = false;
        input.pipelines = pipelines_.get();
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = camera, .exposure_ev = exposure_ev};
        return std::move(*session);
    }
    // Starts a session for a graph that does not depend on the scene.
    std::unique_ptr<render::Session> start(const std::string& graph, Extent3D size,
                                           std::vector<std::string> observed = {}) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        EXPECT_TRUE(scene);
        return start(*scene, scene::framing_camera(*scene, 1), graph, size, std::move(observed));
    }

    // Renders one frame and returns the observed images. On any error, the test fails and the result is
    // empty. The session stays until the next call, which takes over its pipelines: a Vulkan driver needs
    // more time to create pipelines than for all other parts of a session.
    Rendered render(const scene::Scene& scene, const scene::Camera& camera, Extent3D size, float exposure_ev,
                    std::vector<std::string> observed, const std::string& graph = kDeferredGraph,
                    const render::ParameterValues& parameters = {}) {
        if (!pipelines_) pipelines_ = std::make_unique<vk::SharedPipelines>();
        std::unique_ptr<render::Session> session =
            start(scene, camera, graph, size, std::move(observed), exposure_ev);
        if (!session) return {};
        frame_of(*session).parameters = parameters;
        Status done = draw_frame(*session);
        if (done) done = session->finish();
        if (!done) {
            ADD_FAILURE() << to_text(done.errors());
            return {};
        }
        Rendered result;
        for (const vk::ReadbackData& data : session->take_readbacks())
            result.images[data.pass.substr(std::string("observe:").size())] =
                render::decode_texels(data.format, data.bytes);
        result.view = session->parts().frames.view();
        result.lights = session->parts().scene.lights();
        result.pre_exposure = session->pre_exposure();
        last_rendered_ = std::move(session);
        return result;
    }

    uint32_t queues_ = 1;
    scene::Probes probes_;                  // The light probes of the next sessions.
    std::map<std::string, double> params_;  // Parameters of the graph in the next sessions.
    PassCatalog passes_;
    Diagnostics warnings_;
    std::unique_ptr<vk::Device> device_;

 private:
    // The pipelines that render() shares between its sessions, and the session of its last call.
    std::unique_ptr<vk::SharedPipelines> pipelines_;
    std::unique_ptr<render::Session> last_rendered_;
};

}  // namespace weft::test
