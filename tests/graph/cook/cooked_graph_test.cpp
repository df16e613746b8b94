// Tests cooked graphs: all fields of a graph and its shaders survive, and damaged bytes are errors.
#include "weft/cooked_graph.h"

#include <gtest/gtest.h>

#include "tests/graph/samples/random_graph.h"
#include "weft/compile.h"

namespace weft {
namespace {

ShaderCatalog made_up_shaders() {
    ShaderProgram program;
    program.reference = "blur.comp";
    program.content_hash = 0x123456789ABCDEF0;
    program.modules = {{ShaderStage::compute, {0x07230203, 1, 2, 0xFFFFFFFF}}};
    program.interface.stages = stage_bit(ShaderStage::compute);
    program.interface.local_size = {8, 4, 2};
    program.interface.discards = true;
    program.interface.needs_texture_tables = true;
    BlockMember inner;
    inner.name = "weight";
    BlockMember outer;
    outer.name = "weights";
    outer.members = {inner};
    ShaderBinding binding;
    binding.name = "words";
    binding.set = 1;
    binding.binding = 3;
    binding.kind = BindingKind::storage_buffer;
    binding.members = {outer};
    binding.is_runtime_array = true;
    program.interface.bindings = {binding};
    program.interface.frame_ranges = {{1, 2, 3}};
    program.interface.spec_constants = {{"TAPS", 4, ScalarType::i32, 5}};
    program.interface.vertex_inputs = {{"position", 1, ScalarType::f32, 3}};
    return {{"blur.comp", program}};
}

std::string plan_of(const ResolvedGraph& graph) {
    return plan_hash(compile(graph, content_needs(graph), {}));
}

TEST(CookedGraph, AllFieldsOfRandomGraphsSurvive) {
    for (uint32_t seed = 0; seed < 50; ++seed) {
        const ResolvedGraph graph = test::random_graph(seed, test::all_features());
        const Result<CookedGraph> read = read_cooked(cook(graph, {}), "random");
        ASSERT_TRUE(read) << to_text(read.errors());
        EXPECT_EQ(plan_of(read->graph), plan_of(graph)) << "seed " << seed;
        EXPECT_EQ(read->graph.frames, graph.frames);
    }
}

TEST(CookedGraph, AllFieldsOfAShaderSurvive) {
    const ShaderCatalog shaders = made_up_shaders();
    const ShaderProgram& wanted = shaders.at("blur.comp");
    const Result<CookedGraph> read = read_cooked(cook({}, shaders), "shaders");
    ASSERT_TRUE(read) << to_text(read.errors());
    ASSERT_EQ(read->shaders.size(), 1u);
    const ShaderProgram& found = read->shaders.at("blur.comp");
    EXPECT_EQ(found.content_hash, wanted.content_hash);
    ASSERT_EQ(found.modules.size(), 1u);
    EXPECT_EQ(found.modules[0].stage, ShaderStage::compute);
    EXPECT_EQ(found.modules[0].spirv, wanted.modules[0].spirv);
    EXPECT_EQ(found.interface.bindings, wanted.interface.bindings);
    EXPECT_EQ(found.interface.frame_ranges, wanted.interface.frame_ranges);
    EXPECT_EQ(found.interface.local_size, wanted.interface.local_size);
    EXPECT_TRUE(found.interface.discards);
    EXPECT_TRUE(found.interface.needs_texture_tables);
    EXPECT_EQ(found.interface.spec_constants.at(0).name, "TAPS");
    EXPECT_EQ(found.interface.spec_constants.at(0).default_bits, 5u);
    EXPECT_EQ(found.interface.vertex_inputs.at(0).components, 3);
    // The bytes of the same content are the same.
    EXPECT_EQ(cook({}, read->shaders), cook({}, shaders));
}

std::string fault_of(const std::vector<std::byte>& bytes) {
    const Result<CookedGraph> read = read_cooked(bytes, "disc.cooked");
    if (read) return "none";
    EXPECT_EQ(read.errors().size(), 1u);
    EXPECT_FALSE(read.errors()[0].help.empty());
    EXPECT_NE(read.errors()[0].message.find("\"disc.cooked\""), std::string::npos);
    return read.errors()[0].code;
}

TEST(CookedGraph, DamagedBytesAreAnError) {
    const std::vector<std::byte> whole = cook(test::random_graph(3), made_up_shaders());
    EXPECT_EQ(fault_of(whole), "none");
    EXPECT_EQ(fault_of({}), "V427");
    for (size_t size = 0; size < whole.size(); size += 1 + size / 7)
        EXPECT_EQ(fault_of({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), "V427")
            << size;
    for (size_t at = 0; at < whole.size(); at += 1 + at / 7) {
        std::vector<std::byte> bytes = whole;
        bytes[at] ^= std::byte{0x10};
        EXPECT_EQ(fault_of(bytes), "V427") << at;
    }
}

}  // namespace
}  // namespace weft
