// Tests that a plan does not depend on the order in which the parts of the graph are declared, nor on the
// thread that compiles the graph.
#include <algorithm>
#include <random>
#include <set>
#include <thread>

#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ShuffledGraph : public ResolveTest {
 protected:
    ShuffledGraph() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["mix.comp"] = compute({sampled("a"), sampled("b"), image_out("dst")});
        for (int i = 0; i < 24; ++i) {
            const std::string id = std::to_string(i);
            const std::string history = i % 5 == 0 ? R"(, "history": 1)" : "";
            resources_.push_back("\"image" + id + R"(": {"format": "rgba16f")" + history + "}");
            const std::string queue = i % 3 == 0 ? R"("queue": "async", )" : "";
            const std::string b = i % 5 == 2 ? "image" + std::to_string(i - i % 5) + "[-1]"
                                             : "image" + std::to_string(std::max(0, i - 7));
            passes_.push_back(
                i == 0 ? R"("pass0": {"type": "compute", "shader": "make.comp", "out": {"dst": "image0"}})"
                       : "\"pass" + id + R"(": {"type": "compute", )" + queue +
                             R"("shader": "mix.comp", "in": {"a": "image)" + std::to_string(i - 1) +
                             R"(", "b": ")" + b + R"("}, "out": {"dst": "image)" + id + R"("}})");
        }
        passes_.push_back(
            R"("show": {"type": "copy", "in": {"src": "image23"}, "out": {"dst": "backbuffer"}})");
        queues_.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 1}};
    }

    std::string body(std::mt19937& random) {
        std::shuffle(resources_.begin(), resources_.end(), random);
        std::shuffle(passes_.begin(), passes_.end(), random);
        return R"("imports": {"backbuffer": "output"}, "resources": {)" + joined(resources_) +
               R"(}, "passes": {)" + joined(passes_) + "}";
    }

    static std::string joined(const std::vector<std::string>& parts) {
        std::string text;
        for (const std::string& part : parts) text += (text.empty() ? "" : ",\n") + part;
        return text;
    }

    [[nodiscard]] std::string hash_of(const ResolvedGraph& graph, uint32_t queues) const {
        CompileOptions options;
        options.queues = logical_queues(queues_, queues);
        return plan_hash(compile(graph, content_needs(graph), options));
    }

    std::vector<std::string> resources_, passes_;
    DeviceProfile queues_;
};

TEST_F(ShuffledGraph, GivesOnePlanHashOnEveryThread) {
    imports.imports["backbuffer"].resource.format = Format::rgba16f;
    std::mt19937 random(1);
    for (const uint32_t queues : {1u, 2u}) {
        std::set<std::string> hashes;
        for (int run = 0; run < 20; ++run) {
            const ResolvedGraph graph = good(body(random));
            ASSERT_EQ(graph.passes.size(), 25u);
            for (const size_t threads : {1u, 2u}) {
                std::vector<std::string> found(threads);
                std::vector<std::thread> workers;
                for (std::string& hash : found)
                    workers.emplace_back([&, queues] { hash = hash_of(graph, queues); });
                for (std::thread& worker : workers) worker.join();
                hashes.insert(found.begin(), found.end());
            }
        }
        EXPECT_EQ(hashes.size(), 1u) << queues << " queues";
    }
}

}  // namespace
}  // namespace weft::test
