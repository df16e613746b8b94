#include "weft/scene/encode_glb.h"

#include <tiny_gltf.h>

#include <sstream>

#include "scene/export/glb_lights.h"
#include "scene/export/glb_materials.h"
#include "scene/export/glb_nodes.h"

namespace weft::scene {
namespace {

// A .glb file stores its length in 32 bits. The JSON gets the rest of the file.
constexpr size_t kMostBufferBytes = 0xF0000000;

Diagnostic too_large(size_t bytes) {
    Diagnostic d;
    d.code = "S140";
    d.message = "the meshes and textures of the scene have " + std::to_string(bytes) +
                " bytes; a .glb file can have " + std::to_string(kMostBufferBytes);
    d.help = {"split the scene, or make its textures smaller"};
    return d;
}

}  // namespace

Result<std::string> encode_glb(const Scene& scene) {
    tinygltf::Model out = glb::empty_model();
    out.scenes.front().name = scene.name;
    if (Status images = glb::add_images(scene.textures, out); !images) return images.take_errors();
    glb::TextureTable textures(out);
    glb::add_materials(scene.materials, textures, out);
    glb::add_instances(scene, out);
    glb::add_lights(scene, textures, out);
    glb::add_cameras(scene.cameras, out);
    const size_t buffer_bytes = out.buffers.front().data.size();
    if (buffer_bytes > kMostBufferBytes) return too_large(buffer_bytes);
    if (buffer_bytes == 0) out.buffers.clear();  // glTF allows no empty buffer.
    std::ostringstream file;
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&out, file, false, true);
    return std::move(file).str();
}

}  // namespace weft::scene
