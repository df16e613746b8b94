// An example of embedding Weft: renders a built-in scene with a graph of Weft. The program creates the Vulkan
// device and the target image, and Weft renders with this device to this image.
// Usage: embedding OUTPUT.ppm [--validate]
#include <weft/registry.h>
#include <weft/render/session.h>
#include <weft/scene/builtin_scenes.h>
#include <weft/vulkan/device.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "own_device.h"

namespace {

constexpr weft::Extent3D kSize_px{320, 180, 1};
constexpr int kFrames = 3;
constexpr double kFrameTime_s = 1.0 / 60.0;

// Returns the value of a result, or throws if the result contains errors. Weft returns errors as values.
template <class T>
T take(weft::Result<T> result) {
    if (!result) throw std::runtime_error(weft::to_text(result.errors()));
    return std::move(*result);
}

std::vector<uint8_t> render(const OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px));

    const weft::scene::Scene scene = take(weft::scene::make_builtin("spheres"));
    const weft::PassCatalog passes = weft::registered_passes();
    const std::filesystem::path data = WEFT_DATA_DIR;
    weft::render::SessionInput input;
    input.request.path = data / "graphs" / "deferred.json";
    input.request.size = kSize_px;
    input.load.graph_root = data / "graphs";
    input.load.shader_root = data / "shaders";
    input.load.shader_worker = weft::find_shader_worker(data.parent_path().parent_path());
    input.passes = &passes;
    input.output = target.image;
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, scene, input, warnings));
    std::fputs(weft::to_text(warnings).c_str(), stderr);

    std::vector<uint8_t> texels;
    weft::render::FrameInput frame{scene.cameras.front(), scene.exposure_ev};
    frame.delta_time_s = kFrameTime_s;
    for (int i = 0; i < kFrames; ++i) {
        frame.time_s = i * kFrameTime_s;
        take(session->render_frame(frame));
        // read_image() submits its copy to the same queue after the frame, so it copies the finished image.
        texels = read_image(own, target.image, kSize_px.width, kSize_px.height);
    }
    session.reset();  // Destroy the session first, because it uses the image.
    destroy_image(own, target);
    return texels;
}

bool write_ppm(const char* path, const std::vector<uint8_t>& rgba) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << kSize_px.width << " " << kSize_px.height << "\n255\n";
    for (size_t i = 0; i < rgba.size(); i += 4) file.write(reinterpret_cast<const char*>(&rgba[i]), 3);
    file.close();
    return !file.fail();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fputs("embedding OUTPUT.ppm [--validate]\n", stderr), 2;
    try {
        OwnDevice own(argc > 2 && std::strcmp(argv[2], "--validate") == 0);
        const std::vector<uint8_t> texels = render(own);
        own.destroy();
        if (own.messages != 0) return 5;
        return write_ppm(argv[1], texels) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embedding: %s\n", error.what());
        return 1;
    }
}
