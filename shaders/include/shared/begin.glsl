// First lines of a header that both C++ and GLSL compile. In C++, they map the type names of GLSL to those of
// glm; in GLSL they do nothing. Rule for structs: a scalar follows every vec3, and the size is a multiple of
// 16 bytes (unless stated otherwise), so that std140, std430 and C++ have the same layout. This file has no
// include guard, because every shared header needs these lines again, even when one file includes several
// headers.
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace weft::shared {
using glm::ivec3;
using glm::mat4;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;
#endif
