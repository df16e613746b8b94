#include "scene/export/glb_model.h"

#include <tiny_gltf.h>

#include <algorithm>

namespace weft::scene::glb {
namespace {

template <class Vector>
tinygltf::Value array_of(const Vector& v) {
    tinygltf::Value::Array array;
    for (const double number : numbers_of(v)) array.emplace_back(number);
    return tinygltf::Value(std::move(array));
}

}  // namespace

tinygltf::Model empty_model() {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "Weft";
    model.buffers.emplace_back();
    model.scenes.emplace_back();
    model.defaultScene = 0;
    return model;
}

int add_view(tinygltf::Model& out, std::span<const std::byte> bytes, int target) {
    std::vector<unsigned char>& data = out.buffers.front().data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = bytes.size();
    view.target = target;
    const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
    data.insert(data.end(), first, first + bytes.size());
    out.bufferViews.push_back(std::move(view));
    return static_cast<int>(out.bufferViews.size()) - 1;
}

int add_elements(tinygltf::Model& out, std::span<const std::byte> bytes, size_t count, ElementType type) {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_view(out, bytes, type.target);
    accessor.type = type.type;
    accessor.componentType = type.component_type;
    accessor.count = count;
    out.accessors.push_back(std::move(accessor));
    return static_cast<int>(out.accessors.size()) - 1;
}

void add_extension(tinygltf::Model& out, std::map<std::string, tinygltf::Value>& extensions,
                   const std::string& name, std::map<std::string, tinygltf::Value> members) {
    extensions[name] = tinygltf::Value(std::move(members));
    std::vector<std::string>& used = out.extensionsUsed;
    if (std::ranges::find(used, name) == used.end()) used.push_back(name);
}

tinygltf::Value json_array(const glm::vec2& v) {
    return array_of(v);
}

tinygltf::Value json_array(const glm::vec3& v) {
    return array_of(v);
}

tinygltf::Value json_array(const glm::vec4& v) {
    return array_of(v);
}

tinygltf::Value json_number(float value) {
    return tinygltf::Value(double{value});
}

}  // namespace weft::scene::glb
