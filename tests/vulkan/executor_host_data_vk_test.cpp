// Purpose: tests data from the host: parameters and uploads. The data that the program sets for a frame must
// be visible in this frame and in no other frame, with several frames in flight.
#include "tests/vulkan/executor_fixture.h"
#include "weft/pass.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;
using ExecutorHostDataVk = ExecutorTest;

constexpr uint32_t kHostDataFrames = 7;

constexpr const char* kEcho = R"(
layout(local_size_x = 1) in;
layout(std430) writeonly buffer Words { uint words[]; } dst;
BLOCK Params { uint frame; float exposure; vec2 pair; int negative; bool yes; } params;
void main() {
    dst.words[0] = params.frame;
    dst.words[1] = floatBitsToUint(params.exposure);
    dst.words[2] = floatBitsToUint(params.pair.x);
    dst.words[3] = floatBitsToUint(params.pair.y);
    dst.words[4] = uint(params.negative);
    dst.words[5] = params.yes ? 1u : 0u;
})";

std::vector<ParamWrite> echo_params(const ShaderInterface& interface) {
    std::vector<ParamWrite> writes;
    for (const BlockMember& member : interface.params.members) {
        ParamWrite write;
        write.member = member.name;
        write.offset_bytes = member.offset_bytes;
        write.scalar = member.scalar;
        write.components = member.rows;
        if (member.name == "frame") write.builtin = Builtin::frame_index;
        if (member.name == "exposure") write.builtin = Builtin::pre_exposure;
        if (member.name == "pair") write.value = {1.5, -2.25, 0, 0};
        if (member.name == "negative") write.value[0] = -3;
        if (member.name == "yes") write.value[0] = 1;
        writes.push_back(write);
    }
    return writes;
}

class ParamsVk : public ExecutorTest, public testing::WithParamInterface<bool> {};

TEST_P(ParamsVk, reach_the_frame_they_were_given_for) {
    std::string source = kEcho;
    source.replace(source.find("BLOCK"), 5, GetParam() ? "layout(push_constant) uniform" : "uniform");
    write_shader("echo.comp", source);
    GraphBuilder builder;
    const ResourceId words = builder.buffer("words", 24);
    PassDecl& pass = builder.compute("echo", {{"dst", words, Access::storage_write, {}, kNoId}});
    use_shader(pass, "echo.comp", ProgramKind::compute);
    ASSERT_EQ(pass.params_push, GetParam());
    pass.params = echo_params(interface_of("echo.comp"));
    builder.pass("read", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    FrameInput first;
    first.frame_index = 1000;
    first.pre_exposure = 0.5F;
    const std::vector<ReadbackData> read = run_frames(*executor, kHostDataFrames, first);
    ASSERT_EQ(read.size(), kHostDataFrames);
    for (uint32_t i = 0; i < kHostDataFrames; ++i) {
        EXPECT_EQ(read[i].frame_index, 1000u + i);
        const std::vector<uint32_t> expected{1000 + i, 0x3F000000, 0x3FC00000, 0xC0100000, 0xFFFFFFFD, 1};
        EXPECT_EQ(values_of<uint32_t>(read[i]), expected);
    }
}

INSTANTIATE_TEST_SUITE_P(PushAndUniform, ParamsVk, testing::Bool(),
                         [](const auto& kind) { return kind.param ? "push" : "uniform"; });

// A pass in C++ that uploads words to one port and fills another port. On purpose, the pass also uploads one
// word too many and uploads to a port that does not exist. The executor must ignore the extra word
// and the upload to the missing port.
struct UploadWords {
    static constexpr std::string_view kType = "upload_words";
    static constexpr std::array<PortDecl, 2> kPorts{Out{"words", Access::copy_write},
                                                    Out{"rest", Access::clear_write}};
    static constexpr std::array<ParamDecl, 1> kParams{ParamDecl{"scale", 1, 0, 10, ""}};
    static Status check(const PassDecl&, const ResolvedGraph&) { return Unit{}; }
    static void prepare(const PassContext& context, const HostInputs& host, Uploads& uploads) {
        const auto* start = host.get<uint32_t>("start");
        if (start == nullptr) return;
        std::vector<uint32_t> words;
        for (uint32_t i = 0; i <= uploads.capacity("words") / 4; ++i)
            words.push_back(static_cast<uint32_t>(context.param("scale")) * (*start + i));
        uploads.put("words", std::as_bytes(std::span(words)));
        uploads.put("no such port", std::as_bytes(std::span(words)));
    }
    static void record(const PassContext&, Recorder& recorder) {
        recorder.copy_upload("words");
        recorder.fill_buffer("rest", 0xABCDu);
    }
};

TEST_F(ExecutorHostDataVk, uploads_of_a_pass_reach_their_frame) {
    GraphBuilder builder;
    const ResourceId words = builder.buffer("words", 16);
    const ResourceId rest = builder.buffer("rest", 8);
    PassDecl& upload = builder.pass(
        "upload", PassKind::custom,
        {{"words", words, Access::copy_write, {}, kNoId}, {"rest", rest, Access::clear_write, {}, kNoId}});
    upload.type = "upload_words";
    upload.custom_params = {{"scale", 2}};
    builder.pass("read_rest", PassKind::readback, {{"src", rest, Access::copy_read, {}, kNoId}});
    builder.pass("read_words", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
    const PassCatalog passes{{"upload_words", pass_type<UploadWords>()}};
    ExecutorInput input = input_for(compile_plan(builder));
    input.passes = &passes;
    const auto executor = executor_for(std::move(input));
    ASSERT_NE(executor, nullptr);
    for (uint32_t i = 0; i < kHostDataFrames; ++i) {
        ASSERT_TRUE(executor->begin_frame().ok());
        const uint32_t start = 10 * i;
        HostInputs host;
        host.set("start", start);
        FrameInput frame;
        frame.frame_index = i;
        frame.host = &host;
        ASSERT_TRUE(executor->run(frame).ok());
    }
    ASSERT_TRUE(executor->finish().ok());
    uint32_t seen = 0;
    for (const ReadbackData& data : executor->take_readbacks()) {
        if (data.pass == "read_rest") {
            EXPECT_EQ(values_of<uint32_t>(data), (std::vector<uint32_t>{0xABCD, 0xABCD}));
            continue;
        }
        const uint32_t start = 20 * static_cast<uint32_t>(data.frame_index);
        EXPECT_EQ(values_of<uint32_t>(data), (std::vector<uint32_t>{start, start + 2, start + 4, start + 6}));
        ++seen;
    }
    EXPECT_EQ(seen, kHostDataFrames);
}

}  // namespace
}  // namespace weft::vk
