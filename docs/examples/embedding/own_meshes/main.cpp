// An example of embedding Weft without a scene: the program draws its own vertex buffer in a raster pass of a
// graph, which also samples an image of the program.
// Usage: own_meshes [--validate]
#include <weft/registry.h>
#include <weft/vulkan/device.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>

#include "sample.h"

namespace {

constexpr weft::Extent3D kPaint_px{2, 1, 1};
// The state of the image `paint` between frames: a fragment shader may have sampled it.
constexpr weft::AccessState kSampledBetweenFrames{weft::stage::kFragmentShader, weft::access::kSampledRead,
                                                  weft::Layout::shader_read_only};

struct Vertex {
    std::array<float, 4> corner, tint;
};
const std::vector<weft::VertexAttribute> kAttributes{
    {"corner", weft::Format::rgba32f, 0, offsetof(Vertex, corner)},
    {"tint", weft::Format::rgba32f, 0, offsetof(Vertex, tint)}};
constexpr std::array<Vertex, 3> kTriangle{
    Vertex{{-1, -1, 0, 1}, {1, 0, 0, 1}}, {{1, -1, 0, 1}, {0, 1, 0, 1}}, {{0, 1, 0, 1}, {0, 0, 1, 1}}};

class Meshes final : public weft::render::DrawList {
 public:
    explicit Meshes(VkBuffer vertices) : vertices_(vertices) {}

    uint32_t record(const weft::vk::DrawContext& draw, const weft::render::DrawView& view) const override {
        const VkDeviceSize offset = 0;
        vkCmdBindVertexBuffers(draw.commands, 0, 1, &vertices_, &offset);
        // A mirrored view, such as a face of a cube map, shows the other side of each triangle.
        vkCmdSetFrontFace(draw.commands,
                          view.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
        vkCmdDraw(draw.commands, kTriangle.size(), 1, 0, 0);
        return 0;
    }
    std::optional<uint64_t> version() const override { return 0; }  // The draws never change.

 private:
    VkBuffer vertices_;
};

VkImageCreateInfo paint_info() {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VK_FORMAT_R8G8B8A8_UNORM;
    info.extent = {kPaint_px.width, kPaint_px.height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    return info;
}

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px));
    const OwnImage paint = make_image(own, paint_info());
    paint_image(own, paint.image, {1, 0.75f, 0.5f, 1});
    const OwnBuffer vertices = make_buffer(own, sizeof kTriangle, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    std::memcpy(vertices.mapped, kTriangle.data(), sizeof kTriangle);

    const Meshes meshes(vertices.buffer);
    const weft::PassCatalog passes = weft::registered_passes();
    weft::render::SessionInput input = session_input("", passes);
    // The graph and its shaders are beside this file.
    input.request.path = std::filesystem::path(__FILE__).parent_path() / "meshes.json";
    input.output = target.image;
    input.draw_lists["triangles"] = {&meshes, {{sizeof(Vertex)}, kAttributes}};
    input.imports["paint"] = weft::render::own_image(paint.image, weft::Format::rgba8, kPaint_px,
                                                     weft::usage::kSampled, kSampledBetweenFrames);
    input.imports["paint"].decl.read_only = true;
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, input, warnings));

    weft::render::FrameInput frame;
    frame.camera.transform[3].z = 3;
    for (int i = 0; i < 3; ++i) take(session->render_frame(frame));
    const std::vector<uint8_t> texels = read_image(own, target.image, kSize_px.width, kSize_px.height);
    // The triangle covers the middle of the picture, but not its corner.
    const size_t middle = 4 * (size_t{kSize_px.height} / 2 * kSize_px.width + kSize_px.width / 2);
    if (texels[middle] == 0 || texels[0] != 0) throw std::runtime_error("the triangle is missing");
    session.reset();  // Destroy the session first, because it uses the objects of the program.
    destroy_buffer(own, vertices);
    destroy_image(own, paint);
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
