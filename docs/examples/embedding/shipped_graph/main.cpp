// An example of embedding Weft without a scene: a graph that is shipped with Weft draws meshes of the
// program. The program provides the descriptor sets 2 and 3, which the shaders of this graph read, and the
// sun and the sky. Usage: shipped_graph [--validate]
#include <weft/registry.h>
#include <weft/vulkan/device.h>
#include <weft/vulkan/executor.h>
#include <shared/instance.glsl>
#include <shared/material.glsl>

#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "sample.h"

namespace {

namespace shared = weft::shared;

constexpr VkShaderStageFlags kDrawStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
constexpr weft::ShaderStageMask kVertex = weft::stage_bit(weft::ShaderStage::vertex);
constexpr weft::ShaderStageMask kDraws = kVertex | weft::stage_bit(weft::ShaderStage::fragment);
constexpr uint32_t kTextures = 6;
constexpr uint32_t kBuffersOfInstances = 3;

// One descriptor set and one buffer for each frame slot.
using SlotSets = std::array<VkDescriptorSet, weft::vk::kFramesInFlight>;
using SlotBuffers = std::array<OwnBuffer, weft::vk::kFramesInFlight>;

struct Vertex {
    glm::vec3 position, normal;
    glm::vec4 tangent;
    glm::vec2 uv;
};
const std::vector<weft::VertexAttribute> kAttributes{
    {"position", weft::Format::rgb32f, 0, offsetof(Vertex, position)},
    {"normal", weft::Format::rgb32f, 0, offsetof(Vertex, normal)},
    {"tangent", weft::Format::rgba32f, 0, offsetof(Vertex, tangent)},
    {"uv", weft::Format::rg32f, 0, offsetof(Vertex, uv)}};

// Returns the triangles of a cube from -1 to 1. Front faces are counter-clockwise.
std::vector<Vertex> cube() {
    std::vector<Vertex> vertices;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0), tangent(0);
            normal[axis] = side;
            tangent[(axis + 1) % 3] = 1;
            const glm::vec3 up = glm::cross(normal, tangent);
            constexpr std::array<glm::vec2, 6> kCorners{glm::vec2(-1, -1), {1, -1}, {1, 1},
                                                        {-1, -1},          {1, 1},  {-1, 1}};
            for (const glm::vec2& corner : kCorners)
                vertices.push_back({normal + corner.x * tangent + corner.y * up, normal,
                                    glm::vec4(tangent, 1), corner * 0.5f + 0.5f});
        }
    return vertices;
}

shared::Instance placed(const glm::mat4& to_world) {
    const glm::mat4 normals(glm::transpose(glm::inverse(glm::mat3(to_world))));
    return {to_world, to_world, normals, shared::kNoStream, shared::kNoStream, 0, 0};
}

shared::Material grey() {
    shared::Material material{};
    material.base_color = glm::vec4(0.5f, 0.5f, 0.5f, 1);
    material.dielectric_f0 = glm::vec3(0.04f);
    material.specular = 1;
    material.roughness = 0.6f;
    for (shared::TextureTransform* uv :
         {&material.base_color_uv, &material.metallic_roughness_uv, &material.normal_uv,
          &material.occlusion_uv, &material.emissive_uv, &material.anisotropy_uv})
        *uv = {glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0)};
    return material;
}

// The contents of a buffer of the program.
template <class T>
OwnBuffer filled(const OwnDevice& own, const std::vector<T>& values, VkBufferUsageFlags usage) {
    const OwnBuffer buffer = make_buffer(own, values.size() * sizeof(T), usage);
    std::memcpy(buffer.mapped, values.data(), values.size() * sizeof(T));
    return buffer;
}

// A descriptor set with its layout.
struct OwnSet {
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;
};

OwnSet make_set(const OwnDevice& own, const std::vector<VkDescriptorSetLayoutBinding>& bindings) {
    OwnSet made;
    VkDescriptorSetLayoutCreateInfo layout{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    layout.bindingCount = static_cast<uint32_t>(bindings.size());
    layout.pBindings = bindings.data();
    vkCreateDescriptorSetLayout(own.device, &layout, nullptr, &made.layout);
    std::vector<VkDescriptorPoolSize> sizes;
    for (const VkDescriptorSetLayoutBinding& binding : bindings) sizes.push_back({binding.descriptorType, 1});
    VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool.maxSets = 1;
    pool.poolSizeCount = static_cast<uint32_t>(sizes.size());
    pool.pPoolSizes = sizes.data();
    vkCreateDescriptorPool(own.device, &pool, nullptr, &made.pool);
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorPool = made.pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &made.layout;
    vkAllocateDescriptorSets(own.device, &info, &made.set);
    return made;
}

void write_set(const OwnDevice& own, const OwnSet& to, uint32_t binding, VkDescriptorType type,
               const VkDescriptorBufferInfo* buffer, const VkDescriptorImageInfo* image) {
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = to.set;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = type;
    write.pBufferInfo = buffer;
    write.pImageInfo = image;
    vkUpdateDescriptorSets(own.device, 1, &write, 0, nullptr);
}

// The ground, and a cube that turns.
std::vector<shared::Instance> instances_at(float time_s) {
    const glm::mat4 one(1), above = glm::translate(one, {0, 1.1f, 0});
    return {placed(glm::scale(one, {4, 0.1f, 4})), placed(glm::rotate(above, time_s, {0, 1, 0}))};
}

// Draws two cubes. The buffer of instances has one element for each. It exists once for each frame slot,
// because the program writes it while the GPU may still read that of the previous frame.
class Cubes final : public weft::render::DrawList {
 public:
    Cubes(VkBuffer vertices, VkDescriptorSet material, const SlotSets& instances, const SlotBuffers& places)
        : vertices_(vertices), material_(material), instances_(instances), places_(places) {}

    void move_to(float time_s) {
        now_ = instances_at(time_s);
        ++moves_;
    }
    // Weft calls it by FrameInput::fill_slot, when the GPU has finished with the buffer of this slot.
    void fill(uint32_t slot) const {
        std::memcpy(places_[slot].mapped, now_.data(), now_.size() * sizeof(shared::Instance));
    }

    uint32_t record(const weft::vk::DrawContext& draw, const weft::render::DrawView& view) const override {
        const VkDeviceSize offset = 0;
        vkCmdBindVertexBuffers(draw.commands, 0, 1, &vertices_, &offset);
        // A pass whose shader reads no material has no set 2.
        const std::array<VkDescriptorSet, 2> sets{material_, instances_[draw.frame_slot]};
        const uint32_t first = draw.uses_materials ? 2 : 3;
        vkCmdBindDescriptorSets(draw.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw.layout, first, 4 - first,
                                &sets[first - 2], 0, nullptr);
        vkCmdSetFrontFace(draw.commands,
                          view.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
        if (draw.cull == weft::CullMode::material) vkCmdSetCullMode(draw.commands, VK_CULL_MODE_BACK_BIT);
        for (uint32_t i = 0; i < count(); ++i) vkCmdDraw(draw.commands, 36, 1, 0, i);
        return 0;
    }
    std::optional<uint64_t> version() const override { return moves_; }
    std::optional<weft::scene::Bounds> bounds() const override {
        return weft::scene::Bounds{{-4, -0.2f, -4}, {4, 3, 4}};
    }
    uint64_t count() const override { return 2; }

 private:
    VkBuffer vertices_;
    VkDescriptorSet material_;
    SlotSets instances_;
    SlotBuffers places_;
    std::vector<shared::Instance> now_;
    uint64_t moves_ = 0;  // The number of times that an instance has moved.
};

VkImageCreateInfo white_info() {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VK_FORMAT_R8G8B8A8_UNORM;
    info.extent = {1, 1, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    return info;
}

// A texture of one white texel, which all textures of the material use.
struct WhiteTexture {
    OwnImage image;
    VkImageView view = VK_NULL_HANDLE;
    VkSampler sampler = VK_NULL_HANDLE;

    explicit WhiteTexture(const OwnDevice& own) : image(make_image(own, white_info())) {
        paint_image(own, image.image, {1, 1, 1, 1});
        VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        info.image = image.image;
        info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        info.format = VK_FORMAT_R8G8B8A8_UNORM;
        info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCreateImageView(own.device, &info, nullptr, &view);
        const VkSamplerCreateInfo plain{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
        vkCreateSampler(own.device, &plain, nullptr, &sampler);
    }
    void destroy(const OwnDevice& own) const {
        vkDestroySampler(own.device, sampler, nullptr);
        vkDestroyImageView(own.device, view, nullptr);
        destroy_image(own, image);
    }
};

// Set 2: the material.
OwnSet material_set(const OwnDevice& own, const OwnBuffer& material, const WhiteTexture& white) {
    std::vector<VkDescriptorSetLayoutBinding> bindings{
        {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, kDrawStages, nullptr}};
    for (uint32_t i = 1; i <= kTextures; ++i)
        bindings.push_back({i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, kDrawStages, nullptr});
    OwnSet set = make_set(own, bindings);
    const VkDescriptorBufferInfo block{material.buffer, 0, VK_WHOLE_SIZE};
    const VkDescriptorImageInfo image{white.sampler, white.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    write_set(own, set, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, &block, nullptr);
    for (uint32_t i = 1; i <= kTextures; ++i)
        write_set(own, set, i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, nullptr, &image);
    return set;
}

// Set 3: the instances, and the buffers of vertex colours and second uvs, which these meshes do not have.
OwnSet instance_set(const OwnDevice& own, const OwnBuffer& instances) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (uint32_t i = 0; i < kBuffersOfInstances; ++i)
        bindings.push_back({i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT, nullptr});
    OwnSet set = make_set(own, bindings);
    const VkDescriptorBufferInfo all{instances.buffer, 0, VK_WHOLE_SIZE};
    for (uint32_t i = 0; i < kBuffersOfInstances; ++i)
        write_set(own, set, i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, &all, nullptr);
    return set;
}

// The descriptor sets 2 and 3 as Weft must know them.
weft::render::OwnDrawSets draw_sets(const OwnSet& material, const OwnSet& instances) {
    weft::render::OwnDrawSets sets;
    sets[2] = {material.layout,
               {{2, 0, weft::BindingKind::uniform_buffer, kDraws, sizeof(shared::Material)}}};
    for (uint32_t i = 1; i <= kTextures; ++i)
        sets[2].bindings.push_back({2, i, weft::BindingKind::sampled_image, kDraws});
    sets[3].layout = instances.layout;
    for (uint32_t i = 0; i < kBuffersOfInstances; ++i)
        sets[3].bindings.push_back({3, i, weft::BindingKind::storage_buffer, kVertex});
    return sets;
}

weft::render::FrameInput frame_at(int i) {
    weft::render::FrameInput frame;
    frame.time_s = i / 60.0;
    frame.delta_time_s = 1 / 60.0;
    frame.camera.transform = glm::inverse(glm::lookAt(glm::vec3(4, 3, 6), {0, 0.6f, 0}, {0, 1, 0}));
    frame.exposure_ev = -14;
    weft::scene::Light sun;
    sun.type = weft::scene::LightType::directional;
    sun.intensity = 60000;  // In lx.
    sun.direction = glm::normalize(glm::vec3(-0.6f, -0.75f, -0.3f));
    frame.lights = {{sun}};
    frame.sky = {{.zenith = {1500, 2400, 4200}, .horizon = {5000, 5500, 6000}}};
    return frame;
}

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px));
    const WhiteTexture white(own);
    const OwnBuffer vertices = filled(own, cube(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    const OwnBuffer material = filled(own, std::vector{grey()}, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    const OwnSet materials = material_set(own, material, white);
    SlotBuffers places;
    std::vector<OwnSet> instances;
    for (OwnBuffer& buffer : places) {
        buffer = filled(own, instances_at(0), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        instances.push_back(instance_set(own, buffer));
    }

    Cubes cubes(vertices.buffer, materials.set, {instances[0].set, instances[1].set}, places);
    const weft::PassCatalog passes = weft::registered_passes();
    weft::render::SessionInput input = session_input("", passes);
    input.request.path = std::filesystem::path(__FILE__).parent_path() / "cubes.json";
    input.output = target.image;
    input.draw_lists["opaque"] = {&cubes, {{sizeof(Vertex)}, kAttributes}};
    input.draw_sets = draw_sets(materials, instances[0]);
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, input, warnings));

    for (int i = 0; i < 3; ++i) {
        weft::render::FrameInput frame = frame_at(i);
        cubes.move_to(static_cast<float>(frame.time_s));
        frame.fill_slot = std::bind_front(&Cubes::fill, &cubes);
        take(session->render_frame(frame));
    }
    require_picture(read_image(own, target.image, kSize_px.width, kSize_px.height));
    session.reset();  // Destroy the session first, because it uses the objects of the program.
    instances.push_back(materials);
    for (const OwnSet& set : instances) {
        vkDestroyDescriptorPool(own.device, set.pool, nullptr);
        vkDestroyDescriptorSetLayout(own.device, set.layout, nullptr);
    }
    for (const OwnBuffer& buffer : {vertices, material, places[0], places[1]}) destroy_buffer(own, buffer);
    white.destroy(own);
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
