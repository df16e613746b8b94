// Tests the result of shader reflection for each kind of declaration.
#include <gtest/gtest.h>

#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

class Interface : public ShaderFolder {};

constexpr const char* kEveryBinding = R"(#version 460
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
layout(constant_id = 3) const bool HAS_shadow = false;
layout(constant_id = 1) const int TAPS = 5;
layout(constant_id = 2) const float BIAS = 0.5;
layout(set = 0, binding = 2) uniform Frame { mat4 viewProjection; vec3 eye; float time; } frame;
uniform sampler2D albedo;
uniform sampler2DArrayShadow shadow;
uniform usampler2D ids;
uniform isampler3D volume;
uniform samplerCube probe;
uniform sampler2DMS samples;
uniform sampler2D layers[3];
uniform sampler2D unusedImage;
layout(rgba16f) uniform writeonly image2D target;
layout(r32ui) uniform uimage2D counters;
layout(rgba8) uniform readonly image2DArray history;
struct Light { vec3 position; float range; uint kind; mat3 basis; };
layout(std430) readonly buffer Lights { uint count; Light sun; Light lights[]; } lights;
layout(std430) writeonly buffer Result { vec4 sums[4]; };
layout(std430) buffer Grid { uvec2 cells[2][3]; } grid;
layout(push_constant) uniform Params { vec2 targetSize; float exposure; uint frameIndex; mat4 m; } params;
void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    vec4 c = texture(albedo, vec2(0)) + texture(probe, vec3(1)) + texelFetch(samples, p, 0) + texture(layers[1], vec2(0));
    if (HAS_shadow) c *= texture(shadow, vec4(0.5));
    c += float(texelFetch(ids, p, 0).x) + float(texelFetch(volume, ivec3(0), 0).x) + float(TAPS) + BIAS;
    c += imageLoad(history, ivec3(0)) + frame.time + lights.lights[lights.count].range + float(grid.cells[1][2].x);
    imageAtomicAdd(counters, p, 1u);
    sums[0] = c * params.exposure;
    imageStore(target, p, c);
}
)";

const ShaderBinding& binding(const ShaderProgram& program, const std::string& name) {
    static const ShaderBinding none;
    const ShaderBinding* found = program.interface.find(name);
    if (found == nullptr) ADD_FAILURE() << "no binding " << name;
    return found == nullptr ? none : *found;
}

TEST_F(Interface, images) {
    write("graph/every.comp", kEveryBinding);
    const ShaderProgram every = program("every.comp", ProgramKind::compute);

    const ShaderBinding& albedo = binding(every, "albedo");
    EXPECT_EQ(albedo.kind, BindingKind::sampled_image);
    EXPECT_EQ(albedo.set, 1u);
    EXPECT_EQ(albedo.dim, ImageDim::d2);
    EXPECT_EQ(albedo.count, 1u);
    EXPECT_EQ(albedo.numeric, NumericClass::float_like);
    EXPECT_TRUE(albedo.reads);
    EXPECT_FALSE(albedo.writes);
    EXPECT_FALSE(albedo.shadow);
    EXPECT_EQ(albedo.stages, stage_bit(ShaderStage::compute));

    const ShaderBinding& shadow = binding(every, "shadow");
    EXPECT_TRUE(shadow.shadow);
    EXPECT_TRUE(shadow.arrayed);
    EXPECT_EQ(shadow.numeric, NumericClass::depth);
    EXPECT_EQ(binding(every, "ids").numeric, NumericClass::uint);
    EXPECT_EQ(binding(every, "volume").numeric, NumericClass::sint);
    EXPECT_EQ(binding(every, "volume").dim, ImageDim::d3);
    EXPECT_EQ(binding(every, "probe").dim, ImageDim::cube);
    EXPECT_TRUE(binding(every, "samples").multisampled);
    EXPECT_EQ(binding(every, "layers").count, 3u);
    EXPECT_EQ(every.interface.find("unusedImage"), nullptr);
}

TEST_F(Interface, storage_images) {
    write("graph/every.comp", kEveryBinding);
    const ShaderProgram every = program("every.comp", ProgramKind::compute);
    const ShaderBinding& target = binding(every, "target");
    EXPECT_EQ(target.kind, BindingKind::storage_image);
    EXPECT_EQ(target.storage_format, Format::rgba16f);
    EXPECT_FALSE(target.reads);
    EXPECT_TRUE(target.writes);
    const ShaderBinding& counters = binding(every, "counters");
    EXPECT_EQ(counters.storage_format, Format::r32u);
    EXPECT_EQ(counters.numeric, NumericClass::uint);
    EXPECT_TRUE(counters.reads && counters.writes);
    const ShaderBinding& history = binding(every, "history");
    EXPECT_TRUE(history.reads && !history.writes && history.arrayed);
    EXPECT_EQ(history.storage_format, Format::rgba8);
}

TEST_F(Interface, buffers_and_their_members) {
    write("graph/every.comp", kEveryBinding);
    const ShaderProgram every = program("every.comp", ProgramKind::compute);

    const ShaderBinding& lights = binding(every, "lights");
    EXPECT_EQ(lights.kind, BindingKind::storage_buffer);
    EXPECT_TRUE(lights.reads && !lights.writes);
    ASSERT_EQ(lights.members.size(), 3u);
    // The layout is std430. The block begins with a uint; the structs after it are aligned to 16 bytes. A
    // struct has 80 bytes: 16 for vec3 and float, 16 for uint and padding, 48 for a mat3 (16 per column).
    constexpr uint32_t kLightBytes = 80;
    EXPECT_EQ(lights.members[1].offset_bytes, 16u);
    EXPECT_EQ(lights.members[1].size_bytes, kLightBytes);
    EXPECT_EQ(lights.members[1].struct_name, "Light");
    const BlockMember& array = lights.members[2];
    EXPECT_TRUE(array.is_runtime_array);
    EXPECT_EQ(array.offset_bytes, 16u + kLightBytes);
    EXPECT_EQ(array.array_stride_bytes, kLightBytes);
    EXPECT_EQ(array.size_bytes, 0u);
    EXPECT_EQ(lights.block_bytes, 16u + kLightBytes);
    ASSERT_EQ(array.members.size(), 4u);
    EXPECT_EQ(array.members[1].name, "range");
    EXPECT_EQ(array.members[1].offset_bytes, 12u);
    EXPECT_EQ(array.members[2].scalar, ScalarType::u32);
    EXPECT_EQ(array.members[3].columns, 3u);
    EXPECT_EQ(array.members[3].rows, 3u);
    EXPECT_EQ(array.members[3].offset_bytes, 32u);

    // This block is declared without an instance name, so the name of the block names the binding.
    const ShaderBinding& result = binding(every, "Result");
    EXPECT_TRUE(!result.reads && result.writes);
    EXPECT_EQ(result.members.at(0).array_count, 4u);
    EXPECT_EQ(result.members.at(0).array_stride_bytes, 16u);
    const ShaderBinding& grid = binding(every, "grid");
    EXPECT_TRUE(grid.reads && grid.writes);
    EXPECT_EQ(grid.members.at(0).array_count, 6u);
    EXPECT_EQ(grid.members.at(0).array_stride_bytes, 8u);
    EXPECT_EQ(grid.members.at(0).rows, 2u);
}

TEST_F(Interface, explicit_sets_are_kept_and_found_only_as_bindings) {
    write("graph/every.comp", kEveryBinding);
    const ShaderInterface interface = program("every.comp", ProgramKind::compute).interface;
    const ShaderBinding& frame = interface.bindings.at(0);
    EXPECT_EQ(frame.name, "frame");
    EXPECT_EQ(frame.set, 0u);
    EXPECT_EQ(frame.binding, 2u);
    EXPECT_EQ(frame.kind, BindingKind::uniform_buffer);
    EXPECT_EQ(frame.block_bytes, 80u);
    EXPECT_EQ(interface.find("frame"), nullptr);
}

TEST_F(Interface, ports_are_numbered_by_name) {
    write("graph/every.comp", kEveryBinding);
    const ShaderInterface interface = program("every.comp", ProgramKind::compute).interface;
    std::string previous;
    uint32_t expected = 0;
    for (const ShaderBinding& port : interface.bindings) {
        if (port.set != 1) continue;
        EXPECT_LT(previous, port.name);
        EXPECT_EQ(port.binding, expected++);
        previous = port.name;
    }
    EXPECT_EQ(expected, 13u);
}

TEST_F(Interface, push_constant_params) {
    write("graph/every.comp", kEveryBinding);
    const ShaderInterface interface = program("every.comp", ProgramKind::compute).interface;
    ASSERT_TRUE(interface.has_params);
    EXPECT_TRUE(interface.params.push_constants);
    EXPECT_EQ(interface.params.size_bytes, 80u);
    ASSERT_EQ(interface.params.members.size(), 4u);
    EXPECT_EQ(interface.params.members[0].name, "targetSize");
    EXPECT_EQ(interface.params.members[2].offset_bytes, 12u);
    EXPECT_EQ(interface.params.members[3].size_bytes, 64u);
    EXPECT_EQ(interface.find("params"), nullptr);
}

TEST_F(Interface, uniform_params_take_part_in_the_numbering) {
    write("graph/x.comp", R"(#version 460
layout(local_size_x = 64) in;
uniform Params { vec4 tint; int n; };
uniform sampler2D a;
layout(rgba8) uniform writeonly image2D z;
void main() { imageStore(z, ivec2(n), tint + texture(a, vec2(0))); }
)");
    const ShaderInterface interface = program("x.comp", ProgramKind::compute).interface;
    ASSERT_TRUE(interface.has_params);
    EXPECT_FALSE(interface.params.push_constants);
    // Bindings are numbered in the order of names, which is "Params", "a", "z".
    EXPECT_EQ(interface.params.binding, 0u);
    EXPECT_EQ(interface.params.size_bytes, 20u);
    EXPECT_EQ(interface.find("a")->binding, 1u);
    EXPECT_EQ(interface.find("z")->binding, 2u);
    EXPECT_EQ(interface.bindings.size(), 2u);
}

TEST_F(Interface, specialisation_constants) {
    write("graph/every.comp", kEveryBinding);
    const auto constants = program("every.comp", ProgramKind::compute).interface.spec_constants;
    ASSERT_EQ(constants.size(), 3u);
    EXPECT_EQ(constants[0].name, "BIAS");
    EXPECT_EQ(constants[0].type, ScalarType::f32);
    EXPECT_EQ(constants[0].default_bits, 0x3f000000u);
    EXPECT_EQ(constants[1].name, "HAS_shadow");
    EXPECT_EQ(constants[1].id, 3u);
    EXPECT_EQ(constants[1].type, ScalarType::boolean);
    EXPECT_EQ(constants[1].default_bits, 0u);
    EXPECT_EQ(constants[2].type, ScalarType::i32);
    EXPECT_EQ(constants[2].default_bits, 5u);
}

TEST_F(Interface, local_size_fixed_and_specialised) {
    write("graph/every.comp", kEveryBinding);
    const std::array<uint32_t, 3> fixed{8, 4, 2};
    EXPECT_EQ(program("every.comp", ProgramKind::compute).interface.local_size, fixed);

    write("graph/spec.comp", R"(#version 460
layout(local_size_x = 16, local_size_y = 2) in;
layout(local_size_x_id = 7) in;
buffer Out { uint n; };
void main() { n = gl_WorkGroupSize.x; }
)");
    const ShaderInterface spec = program("spec.comp", ProgramKind::compute).interface;
    const std::array<uint32_t, 3> specialised{16, 2, 1};
    EXPECT_EQ(spec.local_size, specialised);
}

TEST_F(Interface, raster_inputs_outputs_and_flags) {
    write("shaders/geo/geo.vert", R"(#version 460
layout(location = 2) in vec2 uv;
layout(location = 0) in vec3 position;
layout(location = 1) in uvec4 joints;
layout(location = 0) out vec2 vUv;
void main() { vUv = uv + vec2(joints.xy); gl_Position = vec4(position, 1); }
)");
    write("shaders/geo/geo.frag", R"(#version 460
layout(location = 0) in vec2 vUv;
layout(location = 1) out vec2 normal;
layout(location = 0) out vec4 albedo;
layout(location = 2) out uint id;
void main() { if (vUv.x < 0.5) discard; albedo = vec4(vUv, 0, 1); normal = vUv; id = 1; gl_FragDepth = 0.5; }
)");
    const ShaderProgram geo = program("geo", ProgramKind::raster);
    ASSERT_EQ(geo.modules.size(), 2u);
    EXPECT_EQ(geo.modules[0].stage, ShaderStage::vertex);
    const ShaderInterface& interface = geo.interface;
    EXPECT_EQ(interface.stages, stage_bit(ShaderStage::vertex) | stage_bit(ShaderStage::fragment));
    ASSERT_EQ(interface.vertex_inputs.size(), 3u);
    EXPECT_EQ(interface.vertex_inputs[0].name, "position");
    EXPECT_EQ(interface.vertex_inputs[0].components, 3u);
    EXPECT_EQ(interface.vertex_inputs[1].scalar, ScalarType::u32);
    ASSERT_EQ(interface.fragment_outputs.size(), 3u);
    EXPECT_EQ(interface.fragment_outputs[1].name, "normal");
    EXPECT_EQ(interface.fragment_outputs[1].components, 2u);
    EXPECT_EQ(interface.fragment_outputs[2].scalar, ScalarType::u32);
    EXPECT_TRUE(interface.discards);
    EXPECT_TRUE(interface.writes_depth);
}

TEST_F(Interface, no_discard_no_depth_without_the_words) {
    write("graph/plain.frag", R"(#version 460
in vec2 uv;
out vec4 color;
void unused() { discard; }
void main() { color = vec4(uv, 0, 1); }
)");
    const ShaderInterface interface = program("plain.frag", ProgramKind::fullscreen).interface;
    EXPECT_FALSE(interface.discards);
    EXPECT_FALSE(interface.writes_depth);
    ASSERT_EQ(interface.fragment_outputs.size(), 1u);
    EXPECT_EQ(interface.fragment_outputs[0].location, 0u);
}

}  // namespace
}  // namespace weft
