// An example of a program that runs a graph which was compiled beforehand. It links neither glslang nor
// SPIRV-Tools, and reads no graph file.
// Usage: cooked disc.cooked [--validate]
#include <weft/compile.h>
#include <weft/cooked_graph.h>
#include <weft/vulkan/device.h>
#include <weft/vulkan/executor.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "own_device.h"

namespace {

template <class T>
T take(weft::Result<T> result) {
    if (!result) throw std::runtime_error(weft::to_text(result.errors()));
    return std::move(*result);
}

std::vector<std::byte> read_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::byte> bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    return bytes;
}

void draw(const OwnDevice& own, const std::string& path) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    weft::CookedGraph cooked = take(weft::read_cooked(read_bytes(path), path));
    weft::ResourceDecl& output = cooked.graph.resources[cooked.graph.output];
    output.import->family = own.family;  // The family that owns the image between frames.
    const OwnImage target = make_image(own, weft::vk::image_create_info(output));
    weft::vk::Image image = take(weft::vk::Image::adopt(*device, target.image, output));

    weft::vk::ExecutorInput input;
    input.plan = weft::compile(cooked.graph, weft::vk::query_memory_needs(*device, cooked.graph),
                               weft::compile_options(device->profile(), 1));
    input.shaders = &cooked.shaders;
    input.bindings.images.emplace("backbuffer", &image);
    std::unique_ptr<weft::vk::Executor> executor =
        take(weft::vk::Executor::create(*device, std::move(input)));
    for (uint64_t frame = 0; frame < 3; ++frame) {
        take(executor->begin_frame());
        weft::vk::FrameInput values;
        values.frame_index = frame;
        take(executor->run(values));
    }
    const uint32_t width = output.extent.width, height = output.extent.height;
    const std::vector<uint8_t> texels = read_image(own, target.image, width, height);
    if (texels[0] != 0 || texels[4 * (width * (height / 2) + width / 2)] != 255)
        throw std::runtime_error("the disc is not where it should be");
    executor.reset();
    image = {};  // Destroys the view of the image.
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fputs("cooked FILE [--validate]\n", stderr), 2;
    try {
        OwnDevice own(argc > 2 && std::strcmp(argv[2], "--validate") == 0);
        draw(own, argv[1]);
        own.destroy();
        return own.messages == 0 ? 0 : 5;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cooked: %s\n", error.what());
        return 1;
    }
}
