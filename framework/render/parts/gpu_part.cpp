#include "render/parts/gpu_part.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "render/frame_data.h"
#include "render/scene_bindings.h"
#include "render/views/frustum.h"
#include "weft/render/import_catalog.h"

namespace weft::render {

Result<std::unique_ptr<GpuPart>> GpuPart::create(const PartInput& input) {
    std::unique_ptr<GpuPart> part(new GpuPart);
    const scene::Scene& scene = input.scene;
    Result<GpuGeometry> geometry =
        GpuGeometry::create(input.device, scene, input.uploader, input.moves_instances);
    if (!geometry) return geometry.take_errors();
    Result<GpuMaterials> materials =
        GpuMaterials::create(input.device, scene, input.owned, input.uploader, input.is_first);
    if (!materials) return materials.take_errors();
    part->geometry_ = std::move(*geometry);
    part->materials_ = std::move(*materials);
    if (Status made = part->make_draw_sets(input.device); !made) return made.take_errors();
    part->motion_ = scene.motion;
    part->moving_ = MovingObjects(scene, input.moves_instances);
    part->sort_draws(scene);
    part->find_moving_draws();
    part->find_still_bounds();
    if (!scene.instances.empty()) part->bounds_ = scene::world_bounds(scene);
    if (!input.moves_instances) part->fixed_bounds_ = scene::fixed_bounds(scene);
    part->still_surfaces_ = SurfaceTree(render::still_surfaces(scene, input.moves_instances));
    return part;
}

Status GpuPart::make_draw_sets(vk::Device& device) {
    const auto slots = static_cast<uint32_t>(geometry_.instances.size());
    Result<DescriptorSets> instances = DescriptorSets::create(device, layout_bindings(3), slots, "instances");
    if (!instances) return instances.take_errors();
    instances_ = std::move(*instances);
    for (uint32_t slot = 0; slot < slots; ++slot) {
        const std::array buffers{VkDescriptorBufferInfo{geometry_.instances[slot].handle(), 0, VK_WHOLE_SIZE},
                                 VkDescriptorBufferInfo{geometry_.colors.handle(), 0, VK_WHOLE_SIZE},
                                 VkDescriptorBufferInfo{geometry_.second_uvs.handle(), 0, VK_WHOLE_SIZE}};
        // One write fills bindings 0, 1 and 2: a Vulkan descriptor write continues in the next binding when a
        // binding is full.
        write_buffers(device, instances_.sets[slot], 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffers);
    }
    return Unit{};
}

void GpuPart::sort_draws(const scene::Scene& scene) {
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Material& material = scene.materials[instance.material];
        const bool mirrored = glm::determinant(glm::mat3(instance.transform)) < 0;
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        const glm::vec3 center =
            instance.transform * glm::vec4((mesh.bounds.min + mesh.bounds.max) * 0.5f, 1);
        for (const char* list : kDrawLists)
            if (is_in_draw_list(instance, material, list))
                lists_[list].draws.push_back({geometry_.meshes[instance.mesh], i, instance.material,
                                              draw_variant(material, list), material.double_sided, mirrored,
                                              center, box_in_world(mesh.bounds, instance.transform)});
    }
    // Draws are sorted by material for few state changes. The sort is stable: draws with the same material
    // keep the scene's order, so the picture is always the same.
    for (auto& [name, list] : lists_)
        std::stable_sort(list.draws.begin(), list.draws.end(),
                         [](const PartDraw& a, const PartDraw& b) { return a.material < b.material; });
}

void GpuPart::find_moving_draws() {
    std::map<uint32_t, uint32_t> objects;  // Key: index of an instance. Value: index of its moving object.
    for (uint32_t i = 0; i < moving_.all().size(); ++i) objects[moving_.all()[i].instance] = i;
    draws_of_object_.resize(moving_.all().size());
    for (const MovingObject& object : moving_.all()) is_still_.push_back(object.node == scene::kNone);
    for (auto& [name, list] : lists_) {
        // Lists of objects that do not move need no entry here: an object is removed from them when it moves.
        if (is_still_list(name)) continue;
        for (uint32_t i = 0; i < list.draws.size(); ++i) {
            const auto object = objects.find(list.draws[i].instance);
            if (object != objects.end()) draws_of_object_[object->second].push_back({&list, i});
        }
    }
}

void GpuPart::begin_frame(uint32_t slot, double time_s) {
    if (!motion_.nodes.empty()) nodes_ = scene::transforms_at(motion_, time_s);
    if (moving_.all().empty()) return;
    for (auto& [name, list] : lists_) list.changed = false;
    moving_.move(nodes_);
    for (const uint32_t index : moving_.active()) {
        const MovingObject& object = moving_.all()[index];
        write_object(slot, object);
        if (!object.changed) continue;
        if (is_still_[index]) drop_from_still_lists(index);
        for (const DrawRef& ref : draws_of_object_[index]) {
            PartDraw& draw = ref.list->draws[ref.draw];
            draw.mirrored = glm::determinant(glm::mat3(object.transform)) < 0;
            draw.center =
                object.transform * glm::vec4((object.mesh_bounds.min + object.mesh_bounds.max) * 0.5f, 1);
            draw.box = box_in_world(object.mesh_bounds, object.transform);
            ref.list->changed = true;
        }
    }
    update_bounds();
}

// Removes the draws of an object from the lists of objects that do not move.
void GpuPart::drop_from_still_lists(uint32_t object) {
    is_still_[object] = false;
    const uint32_t instance = moving_.all()[object].instance;
    for (auto& [name, list] : lists_) {
        if (!is_still_list(name)) continue;
        const size_t removed =
            std::erase_if(list.draws, [&](const PartDraw& draw) { return draw.instance == instance; });
        list.changed = list.changed || removed > 0;
    }
    find_still_bounds();
}

void GpuPart::write_object(uint32_t slot, const MovingObject& object) {
    shared::Instance instance = gpu_instance(object.transform);
    instance.prev_object_to_world = object.previous;
    // Only the matrices are written. The members after them, from color_offset on, do not change.
    std::memcpy(geometry_.instances[slot].mapped().data() + uint64_t{object.instance} * sizeof instance,
                &instance, offsetof(shared::Instance, color_offset));
}

void GpuPart::update_bounds() {
    const bool first = std::exchange(has_begun_, true) == false;
    if (!moving_.any_changed() && (!first || nodes_.empty())) return;
    if (const auto all = united(fixed_bounds_, moving_.bounds())) bounds_ = all;
}

void GpuPart::find_still_bounds() {
    still_bounds_.reset();
    for (const auto& [name, list] : lists_)
        if (is_still_list(name))
            for (const PartDraw& draw : list.draws) still_bounds_ = united(still_bounds_, draw.box);
}

const PartDrawList* GpuPart::list(std::string_view name) const {
    const auto found = lists_.find(name);
    return found == lists_.end() ? nullptr : &found->second;
}

}  // namespace weft::render
