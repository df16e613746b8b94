// An example of a pass that records Vulkan commands of its own between passes of Weft, as a user interface
// would. The graph clears the output, and the pass "overlay" then fills a rectangle of it.
// Usage: raw_pass [--validate]
#include <weft/registry.h>
#include <weft/scene/builtin_scenes.h>
#include <weft/vulkan/device.h>
#include <weft/vulkan/raw_pass.h>

#include <array>

#include "sample.h"

namespace {

constexpr const char* kGraph = R"({
  "version": 1, "name": "overlay",
  "imports": { "backbuffer": "output" },
  "passes": {
    "sky":     { "type": "clear", "clear": [0, 0, 1, 1], "out": ["backbuffer"] },
    "overlay": { "type": "overlay", "after": ["sky"], "out": { "target": "backbuffer" } }
  }
})";

// A value of the program, which the pass gets in each frame.
struct Rectangle {
    VkRect2D area_px{};
};

struct Overlay {
    static constexpr std::string_view kType = "overlay";
    // The pass draws over what the output already contains.
    static constexpr std::array<weft::PortDecl, 1> kPorts{
        weft::Out{"target", weft::Access::color_read_write}};
    static constexpr std::array<weft::ParamDecl, 0> kParams{};
    static weft::Status check(const weft::PassDecl&, const weft::ResolvedGraph&) { return weft::Unit{}; }
    static void prepare(const weft::PassContext&, const weft::HostInputs&, weft::Uploads&) {}
    static void record(const weft::PassContext&, weft::Recorder& recorder) {
        const weft::vk::RawCommands& raw = weft::vk::raw_commands(recorder);
        const auto* rectangle = raw.host->get<Rectangle>("rectangle");
        raw.begin_rendering();
        // An engine would draw here, with pipelines of its own.
        VkClearAttachment red{VK_IMAGE_ASPECT_COLOR_BIT, 0, {}};
        red.clearValue.color = {{1, 0, 0, 1}};
        const VkClearRect area{rectangle->area_px, 0, 1};
        vkCmdClearAttachments(raw.commands, 1, &red, 1, &area);
        raw.end_rendering();
    }
};

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px));
    const weft::scene::Scene scene = take(weft::scene::make_builtin("spheres"));
    weft::PassCatalog passes = weft::registered_passes();
    passes.emplace("overlay", weft::pass_type<Overlay>());
    weft::render::SessionInput input = session_input("overlay.json", passes);
    input.load.reader = [](const std::string& path) {
        return path.ends_with("overlay.json") ? std::optional<std::string>(kGraph) : read_file(path);
    };
    input.output = target.image;
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, scene, input, warnings));
    const Rectangle rectangle{{{10, 20}, {30, 40}}};
    weft::HostInputs host;
    host.set("rectangle", rectangle);
    for (int i = 0; i < 3; ++i) {
        weft::render::FrameInput frame = frame_input(scene, i);
        frame.host = &host;
        take(session->render_frame(frame));
    }
    const std::vector<uint8_t> texels = read_image(own, target.image, kSize_px.width, kSize_px.height);
    const auto red_at = [&](uint32_t x, uint32_t y) { return texels[4 * (y * kSize_px.width + x)]; };
    if (red_at(10, 20) != 255 || red_at(39, 59) != 255 || red_at(9, 20) != 0 || red_at(40, 59) != 0)
        throw std::runtime_error("the rectangle is not where it should be");
    session.reset();
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
