#include "viewer/commands/graph_test_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>
#include <map>
#include <set>

#include "graph/diagnostics/quantity_text.h"
#include "graph/parse/parse.h"
#include "graph/syntax/merge.h"
#include "viewer/commands/offline_graph.h"
#include "viewer/commands/session_setup.h"
#include "weft/render/texels.h"
#include "weft/transition.h"

namespace weft::viewer {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

// Results collected while the frames of one test are rendered.
struct Measured {
    // Last contents of each resource that the test reads back. The key is the reference that the test uses in
    // "expect", such as "y.mip(0)".
    std::map<std::string, vk::ReadbackData> resources;
    size_t black_frames = 0;
    // Persistent resources whose contents a change of tier did not keep. The key is the name of the resource,
    // the value is a text with the reason.
    std::map<std::string, std::string> lost;
};

bool is_black(const vk::ReadbackData& output) {
    for (size_t i = 0; i < output.bytes.size(); ++i)
        if (i % 4 != 3 && output.bytes[i] != std::byte{0}) return false;
    return true;
}

class TestRun {
 public:
    TestRun(const std::string& file, const CheckOptions& options, const GraphDesc& graph,
            const GraphTestDesc& test, std::string tier, uint64_t& frames_left)
        : graph_(graph), test_(test), tier_(std::move(tier)), frames_left_(frames_left) {
        options_.request.path = file;
        options_.scene = test.scene.empty() ? "builtin:spheres" : test.scene;
        options_.request.tier = tier_;
        options_.request.size = test.size;
        options_.request.params = options.offline.request.params;
        for (const auto& [name, value] : test.params) options_.request.params[name] = value;
        options_.limits = options.offline.limits;
        options_.graph_path = options.offline.graph_path;
        uint64_t& frame_bytes = options_.limits.graph.transient_bytes;
        frame_bytes = std::min(frame_bytes, options_.limits.graph.test_bytes);
        options_.queues = options.offline.queues;
        options_.device = options.device;
        options_.validate = true;
        options_.quiet = true;
        std::set<std::string> refs;
        for (const ExpectationDesc& expectation : test.expect)
            if (!expectation.ref.empty() && expectation.what != "kept") refs.insert(expectation.ref);
        options_.request.observed.assign(refs.begin(), refs.end());
    }

    Diagnostics run() {
        Result<OpenSession> open = open_session(options_);
        if (!open) return of_a_test(open.take_errors());
        input_ = open->frame;
        input_.delta_time_s = kFrame_s;
        if (!check_readbacks(open->session->plan())) return std::move(failed_);
        const Status drawn = test_.swap.empty() ? draw(*open->session) : draw_swapping(*open->session);
        if (!drawn) return drawn.errors();
        if (has_errors(failed_)) return std::move(failed_);
        check_all(*open->session);
        open->session.reset();
        check_messages(vk::destroy_device(std::move(open->device)));
        return std::move(failed_);
    }

 private:
    // Adds a hint to errors about too much memory: a test of a graph may use less memory than a frame of
    // other commands, so the hint names the limit of the test.
    Diagnostics of_a_test(Diagnostics faults) const {
        for (Diagnostic& fault : faults)
            if (fault.code == "W143" || fault.code == "W125")
                fault.help.push_back("a test of a graph may use at most " +
                                     limit_bytes_text(options_.limits.graph.test_bytes) + ", " +
                                     raise_limit_text("graph.testBytes"));
        return faults;
    }

    // Checks that the resources that the test reads back fit into the limit for memory, because this program
    // stores their contents. If they do not fit, the function adds an error and returns false.
    bool check_readbacks(const FramePlan& plan) {
        const uint64_t most = options_.limits.graph.test_bytes;
        uint64_t bytes = 0;
        for (const PassDecl& pass : plan.graph.passes)
            if (pass.kind == PassKind::readback && pass.name.starts_with("observe:") && !pass.uses.empty())
                bytes += content_bytes(plan.graph.resources[pass.uses.front().resource]);
        if (bytes <= most) return true;
        Diagnostic d = graph_.sources.error(
            test_.loc, "W125",
            "the test reads back more than " + limit_bytes_text(most) + ", the limit for one test");
        d.tier = tier_;
        d.help.push_back("check fewer or smaller resources in \"expect\", " +
                         raise_limit_text("graph.testBytes"));
        failed_.push_back(std::move(d));
        return false;
    }

    // Subtracts the frames of a run from the frames that all tests together may render. If too few are left,
    // the function adds an error and returns false. The parser already checked the frame counts that are
    // written in tests. A test without "frames" uses the frame count of the graph, which is known only here.
    bool take_frames(uint64_t frames) {
        if (frames <= frames_left_) {
            frames_left_ -= frames;
            return true;
        }
        Diagnostic d =
            graph_.sources.error(test_.loc, "W125",
                                 "the tests of the graph render more than " +
                                     std::to_string(options_.limits.graph.test_frames) + " frames");
        d.tier = tier_;
        d.help.push_back("lower \"frames\" in the test, " + raise_limit_text("graph.testFrames"));
        failed_.push_back(std::move(d));
        return false;
    }

    Status draw(render::Session& session) {
        const uint32_t frames = test_.frames > 0 ? test_.frames : session.frames();
        if (!take_frames(frames)) return Unit{};
        for (uint32_t i = 0; i < frames; ++i)
            if (Status s = draw_frame(session); !s) return s;
        return Unit{};
    }

    // Renders frames in one tier after the other. A second thread prepares the next tier while frames are
    // rendered, as a real program would do.
    Status draw_swapping(render::Session& session) {
        if (!take_frames(test_.swap.size() * uint64_t{test_.every})) return Unit{};
        for (size_t i = 0; i < test_.swap.size(); ++i) {
            if (i > 0 || test_.swap[i] != tier_) {
                if (Status s = swap_to(session, test_.swap[i]); !s) return s;
            }
            for (uint32_t frame = 0; frame < test_.every; ++frame)
                if (Status s = draw_frame(session); !s) return s;
        }
        return Unit{};
    }

    Status swap_to(render::Session& session, const std::string& tier) {
        render::Selection selection = session.selection();
        selection.request.tier = tier;
        std::future<render::PrepareResult> made =
            std::async(std::launch::async, [&] { return session.prepare(selection); });
        do {
            if (Status s = draw_frame(session); !s) return s;
        } while (made.wait_for(std::chrono::seconds(0)) != std::future_status::ready);
        render::PrepareResult preparation = made.get();
        if (!preparation.result) return preparation.result.take_errors();
        if (const FramePlan* plan = preparation.result->new_plan(); plan != nullptr)
            note_lost(session.plan(), *plan);
        Result<bool> swapped = session.swap_in(std::move(*preparation.result));
        return swapped ? Status(Unit{}) : Status(swapped.take_errors());
    }

    void note_lost(const FramePlan& from, const FramePlan& to) {
        const TransitionPlan between = transition(from, to);
        for (ResourceId id(0); id < to.graph.resources.size(); ++id) {
            const ResourceDecl& resource = to.graph.resources[id];
            if (resource.ring != id) continue;
            // A resource with history has copies for this frame and for earlier frames. A change of tier
            // keeps only the copies of earlier frames, because the first new frame overwrites its own copy.
            // So a resource counts as lost only if none of its copies is kept.
            const bool carried = std::ranges::any_of(
                between.carried, [&](const ContentCopy& c) { return to.graph.resources[c.to].ring == id; });
            if (!carried)
                measured_.lost.emplace(resource.name, content_text(from, to, between, last_content(to, id)));
        }
    }

    // `ring` is a resource, with its copies for earlier frames if it has a history. Returns the copy that
    // has, between two frames, the content of the last frame.
    static ResourceId last_content(const FramePlan& plan, ResourceId ring) {
        if (plan.graph.resources[ring].history == 0) return ring;
        return find_resource(plan.graph, plan.graph.resources[ring].name + "[-1]");
    }

    Status draw_frame(render::Session& session) {
        input_.time_s = frame_++ * kFrame_s;
        if (Status s = session.render_frame(input_); !s) return s;
        if (Status s = session.finish(); !s) return s;
        for (vk::ReadbackData& data : session.take_readbacks())
            measured_.resources[data.pass.substr(data.pass.find(':') + 1)] = std::move(data);
        static_cast<void>(session.take_timings());
        if (!session.has_output()) return Unit{};
        const Result<vk::ReadbackData> output = session.read_output();
        if (!output) return output.errors();
        measured_.black_frames += is_black(*output) ? 1 : 0;
        return Unit{};
    }

    void fail(const ExpectationDesc& expectation, const char* code, const std::string& message,
              std::string help) {
        Diagnostic d = graph_.sources.error(expectation.loc, code, message);
        d.tier = tier_;
        d.help.push_back(std::move(help));
        failed_.push_back(std::move(d));
    }

    void at_most(const ExpectationDesc& expectation, double found, const std::string& what) {
        if (found <= expectation.most) return;
        fail(expectation, "W161",
             "found " + number_text(found) + " " + what + ", the test allows at most " +
                 number_text(expectation.most),
             "look at the output of `weft plan` and `weft explain`, or raise the number in the test");
    }

    void check_all(const render::Session& session) {
        const FramePlan& plan = session.plan();
        for (const ExpectationDesc& e : test_.expect) {
            if (e.what == "passes") at_most(e, static_cast<double>(plan.schedule.order.size()), "passes");
            if (e.what == "barriers") at_most(e, plan.barriers.emitted, "barriers");
            if (e.what == "submissions")
                at_most(e, static_cast<double>(plan.submissions.batches.size()), "submissions");
            if (e.what == "transientBytes")
                at_most(e, static_cast<double>(plan.memory.heap_bytes), "bytes of transient memory");
            if (e.what == "blackFrames")
                at_most(e, static_cast<double>(measured_.black_frames), "black pictures");
            if (e.what == "pipelinesOnFrameThread")
                at_most(e, static_cast<double>(session.pipelines_made_between_frames()),
                        "pipelines for which a frame had to wait");
            if (e.what == "kept") check_kept(e, plan.graph);
            if (e.what == "finite" || e.what == "range" || e.what == "mean") check_values(e);
        }
    }

    // Decodes the data in pieces and calls visit(values, index of the first value) for each piece. Pieces are
    // necessary because a decoded texel has 16 bytes, and an encoded one may have only 1 byte. The 32-bit
    // words of a buffer are interpreted as floats. The function stops early if visit() returns false.
    template <class F>
    static void visit_values(const vk::ReadbackData& data, F visit) {
        constexpr size_t kTexelsAtOnce = 1u << 16;
        const Format format = data.format == Format::undefined ? Format::r32f : data.format;
        const size_t texel_bytes = std::max<size_t>(1, format_info(format).bytes_per_texel);
        const size_t piece = kTexelsAtOnce * texel_bytes;
        for (size_t begin = 0; begin + texel_bytes <= data.bytes.size(); begin += piece) {
            const std::span<const std::byte> bytes =
                std::span(data.bytes).subspan(begin, std::min(piece, data.bytes.size() - begin));
            if (!visit(render::decode_texels(format, bytes), begin / texel_bytes)) return;
        }
    }

    void check_kept(const ExpectationDesc& expectation, const ResolvedGraph& graph) {
        const std::string name = "\"" + expectation.ref + "\"";
        if (const auto lost = measured_.lost.find(expectation.ref); lost != measured_.lost.end())
            return fail(expectation, "W161",
                        "a change of tier loses the content of " + name + ": " + lost->second,
                        "give " + name +
                            " the same size and format in all tiers, or set \"onResize\": \"resample\"; if a "
                            "tier does not use it, write \"keep\": \"shared\"");
        const ResourceId id = find_resource(graph, expectation.ref);
        if (id == kNoId || graph.resources[id].lifetime != ResourceLifetime::persistent)
            fail(expectation, "W161", name + " has no content between two frames",
                 "name a resource with \"keep\" or \"history\"");
    }

    static bool is_bad(const ExpectationDesc& expectation, float value) {
        if (expectation.what == "mean") return false;
        if (expectation.what == "finite") return !std::isfinite(value);
        return !(value >= expectation.least && value <= expectation.most);
    }

    void check_values(const ExpectationDesc& expectation) {
        const auto data = measured_.resources.find(expectation.ref);
        if (data == measured_.resources.end())
            return fail(expectation, "W161", "\"" + expectation.ref + "\" was not written in the last frame",
                        "name a resource that a pass of this tier writes");
        const int channels =
            data->second.format == Format::undefined ? 1 : format_info(data->second.format).components;
        const uint32_t width = std::max(1u, data->second.extent.width);
        double sum = 0;
        size_t count = 0;
        std::optional<std::pair<size_t, float>> bad;
        visit_values(data->second, [&](const std::vector<glm::vec4>& values, size_t first) {
            for (size_t i = 0; i < values.size() && !bad; ++i) {
                for (int c = 0; c < channels; ++c) {
                    sum += double{values[i][c]};
                    if (!bad && is_bad(expectation, values[i][c])) bad = {first + i, values[i][c]};
                }
            }
            count += values.size();
            return !bad;
        });
        if (bad)
            return fail(expectation, "W161",
                        "\"" + expectation.ref + "\" contains " + number_text(double{bad->second}) + " at (" +
                            std::to_string(bad->first % width) + ", " + std::to_string(bad->first / width) +
                            ")",
                        "look at \"" + expectation.ref +
                            "\": `weft render --resource` writes an .exr file, `--debug` a picture");
        if (expectation.what != "mean" || count == 0) return;
        const double mean = sum / (static_cast<double>(count) * channels);
        if (mean >= expectation.least && mean <= expectation.most) return;
        fail(expectation, "W161",
             "the mean of \"" + expectation.ref + "\" is " + number_text(mean) + ", not between " +
                 number_text(expectation.least) + " and " + number_text(expectation.most),
             "look at \"" + expectation.ref + "\": `weft render --resource` writes an .exr file");
    }

    void check_messages(const std::vector<vk::Message>& messages) {
        const auto allowed = std::ranges::find(test_.expect, "validation", &ExpectationDesc::what);
        const double most = allowed != test_.expect.end() ? allowed->most : 0;
        if (static_cast<double>(messages.size()) <= most) return;
        report_messages(messages);
        ExpectationDesc here = allowed != test_.expect.end() ? *allowed : ExpectationDesc{};
        if (allowed == test_.expect.end()) here.loc = test_.loc;
        fail(here, "W162",
             "found " + count_text(messages.size(), "validation message") + ", the test allows at most " +
                 number_text(most),
             "correct the causes of the messages; `weft render --validate` shows the messages");
    }

    RenderOptions options_;
    const GraphDesc& graph_;
    const GraphTestDesc& test_;
    std::string tier_;
    uint64_t& frames_left_;  // Number of frames that all remaining test runs together may render.
    uint64_t frame_ = 0;
    render::FrameInput input_;
    Measured measured_;
    Diagnostics failed_;
};

}  // namespace

Diagnostics run_graph_tests(const std::string& file, const CheckOptions& options) {
    Result<JsonDoc> document = read_offline(file, options.offline);
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(*document));
    if (!merged) return merged.take_errors();
    const Result<GraphDesc> graph = parse(*merged, options.offline.limits.graph);
    if (!graph) return graph.errors();
    Diagnostics failed;
    uint64_t frames_left = options.offline.limits.graph.test_frames;
    for (size_t i = 0; i < graph->tests.size(); ++i) {
        const GraphTestDesc& test = graph->tests[i];
        std::vector<std::string> tiers = test.tiers;
        if (!test.swap.empty()) tiers = {test.swap.front()};
        for (const std::string& tier : tiers) {
            Diagnostics found = TestRun(file, options, *graph, test, tier, frames_left).run();
            std::fprintf(stderr, "%s: test %zu%s%s%s: %s\n", file.c_str(), i + 1,
                         tier.empty() ? "" : ", tier ", tier.c_str(),
                         test.swap.empty() ? "" : ", then other tiers", has_errors(found) ? "failed" : "ok");
            failed.insert(failed.end(), found.begin(), found.end());
        }
    }
    if (graph->tests.empty()) std::fprintf(stderr, "%s: the graph has no tests\n", file.c_str());
    return failed;
}

}  // namespace weft::viewer
