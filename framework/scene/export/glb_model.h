// Purpose: adds the basic parts of a binary glTF file to a model of tinygltf: bytes of its only buffer,
// accessors and extensions.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
class Value;
}  // namespace tinygltf

namespace weft::scene::glb {

// Returns a model with an empty buffer and an empty scene.
[[nodiscard]] tinygltf::Model empty_model();

// Appends the bytes to the buffer, at a multiple of 4 bytes. `target`: as in glTF; 0: none. Returns the index
// of their buffer view.
int add_view(tinygltf::Model& out, std::span<const std::byte> bytes, int target);

// Describes the elements of an array. The numbers are constants of glTF, such as TINYGLTF_TYPE_VEC3.
struct ElementType {
    int type = 0;
    int component_type = 0;
    int target = 0;
};

int add_elements(tinygltf::Model& out, std::span<const std::byte> bytes, size_t count, ElementType type);

// Appends the elements of an array to the buffer. Returns the index of the accessor.
template <class Element>
int add_accessor(tinygltf::Model& out, const std::vector<Element>& elements, ElementType type) {
    return add_elements(out, std::as_bytes(std::span(elements)), elements.size(), type);
}

// Adds the members of an extension to the extensions of an object of the file, and its name to
// `extensionsUsed`.
void add_extension(tinygltf::Model& out, std::map<std::string, tinygltf::Value>& extensions,
                   const std::string& name, std::map<std::string, tinygltf::Value> members);

// Returns the numbers of a vector of glm.
template <class Vector>
[[nodiscard]] std::vector<double> numbers_of(const Vector& v) {
    std::vector<double> numbers;
    for (int i = 0; i < Vector::length(); ++i) numbers.push_back(double{v[i]});
    return numbers;
}

[[nodiscard]] tinygltf::Value json_array(const glm::vec2& v);
[[nodiscard]] tinygltf::Value json_array(const glm::vec3& v);
[[nodiscard]] tinygltf::Value json_array(const glm::vec4& v);
[[nodiscard]] tinygltf::Value json_number(float value);

}  // namespace weft::scene::glb
