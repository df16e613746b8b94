#include "tests/graph/samples/random_rest.h"

#include <random>
#include <vector>

#include "tests/graph/samples/fake_shaders.h"

namespace weft::test {
namespace {

class RestGenerator {
 public:
    RestGenerator(uint32_t seed, RestShaders shaders, bool has_unwoken)
        : random_(seed), is_real_(shaders == RestShaders::real), has_unwoken_(has_unwoken) {}

    RandomRest run() {
        add_changing("change0", {});
        const uint32_t groups = 1 + below(4);
        for (uint32_t g = 0; g < groups; ++g) {
            add_group(g);
            while (chance(50)) add_reader();
        }
        add_reader();
        for (size_t i = 0; i < kept_.size(); ++i)
            if (chance(60) || i + 1 == kept_.size())
                pass("see" + std::to_string(i), R"("type": "readback", "in": [")" + kept_[i] + "\"]");
        pass("seeLast", R"("type": "readback", "in": [")" + changing_.back() + "\"]");
        const std::string head =
            is_real_ ? R"("params": {)" + params() + "}" : R"("imports": {"noise": "image"})";
        made_.text =
            head + R"(, "resources": {)" + joined(resources_) + R"(}, "passes": {)" + joined(passes_) + "}";
        return std::move(made_);
    }

 private:
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    bool chance(uint32_t percent) { return below(100) < percent; }
    template <class T>
    const T& any(const std::vector<T>& items) {
        return items[below(static_cast<uint32_t>(items.size()))];
    }

    static std::string joined(const std::vector<std::string>& items) {
        std::string all;
        for (const std::string& item : items) all += (all.empty() ? "" : ",\n") + item;
        return all;
    }

    void pass(const std::string& name, const std::string& body) {
        passes_.push_back("\"" + name + "\": {" + body + "}");
    }
    void resource(const std::string& name, const std::string& more) {
        resources_.push_back("\"" + name + R"(": {"format": "rgba16f", "size": 64)" + more + "}");
    }

    std::string params() const {
        std::string all;
        for (uint32_t i = 0; i < made_.params; ++i)
            all += (i == 0 ? "\"p" : ", \"p") + std::to_string(i) + R"(": {"default": 0, "range": [0, 1]})";
        return all;
    }

    // Returns the key that gives a shader its parameter.
    std::string param() {
        if (!is_real_) return "";
        return R"(, "params": {"value": "p)" + std::to_string(made_.params++) + "\"}";
    }

    std::string queue() {
        if (chance(55)) return "";
        return chance(60) ? R"(, "queue": "async")" : R"(, "queue": "graphics")";
    }

    // Returns the value of an input port. The sign "?" before a name means "wakes": false.
    static std::string reference(const std::string& input) {
        if (input.front() != '?') return "\"" + input + "\"";
        return R"({"ref": ")" + input.substr(1) + R"(", "wakes": false})";
    }

    // Returns the keys of a pass that reads `inputs` (at most two) and writes all of `target`.
    std::string work(const std::vector<std::string>& inputs, const std::string& target) {
        const bool draws = chance(25);
        std::string ports;
        for (size_t i = 0; i < inputs.size(); ++i)
            ports +=
                (i == 0 ? "" : ", ") + std::string(i == 0 ? "\"a\": " : "\"b\": ") + reference(inputs[i]);
        const char kind = !draws && chance(30) ? 'i' : 's';  // Storage images or sampled images as inputs.
        const std::string shader =
            std::string(1, kind) + std::to_string(inputs.size()) + (draws ? ".frag" : ".comp");
        return std::string(R"("type": ")") + (draws ? "fullscreen" : "compute") + R"(", "shader": ")" +
               shader + "\"" + (ports.empty() ? "" : R"(, "in": {)" + ports + "}") + R"(, "out": {"dst": ")" +
               target + "\"}" + param() + (draws ? "" : queue());
    }

    void resting(const std::string& name, const std::string& body) {
        pass(name, body + R"(, "rest": true)");
        ++made_.rest_passes;
    }

    // Returns up to two inputs whose content changes only if a unit runs.
    std::vector<std::string> still_inputs() {
        std::vector<std::string> inputs;
        if (has_unwoken_ && chance(40)) inputs.push_back("?" + any(changing_));
        while (inputs.size() < 2 && chance(60)) {
            if (is_real_ && final_.empty()) break;
            if (final_.empty() || (!is_real_ && chance(30)))
                inputs.emplace_back("noise");
            else
                inputs.push_back(any(final_));
        }
        if (inputs.size() == 2 && inputs[0] == inputs[1]) inputs.pop_back();
        return inputs;
    }

    void add_group(uint32_t number) {
        const std::string id = std::to_string(number);
        const std::string image = "kept" + id;
        const uint32_t layers = 1 + below(3);
        resource(image, ", \"keep\": true" + (layers > 1 ? ", \"layers\": " + std::to_string(layers) : ""));
        std::vector<std::string> inputs = still_inputs();
        if (chance(60)) {
            resource("local" + id, "");
            resting("first" + id, work(inputs, "local" + id));
            inputs = {"local" + id};
            if (!final_.empty() && chance(40)) inputs.push_back(any(final_));
            if (chance(20)) made_.observed.push_back("local" + id);
        }
        for (uint32_t layer = 0; layer < layers; ++layer) {
            const std::string part = layers > 1 ? image + ".layer(" + std::to_string(layer) + ")" : image;
            const std::string name = "make" + id + "_" + std::to_string(layer);
            resting(name, layer > 0 && chance(15) ? R"("type": "clear", "out": [")" + part + "\"]"
                                                  : work(inputs, part));
            if (chance(30))
                resting("again" + id + "_" + std::to_string(layer),
                        R"("type": "compute", "shader": "change.comp", "out": {"dst": ")" + part +
                            "\"}, \"after\": [\"" + name + "\"]" + queue());
            if (chance(50)) inputs = {part};
            final_.push_back(part);
            kept_.push_back(part);
        }
    }

    void add_changing(const std::string& name, const std::vector<std::string>& inputs) {
        resource(name + "Image", "");
        pass(name, work(inputs, name + "Image"));
        changing_.push_back(name + "Image");
    }

    // Adds a pass that runs in every frame.
    void add_reader() {
        std::vector<std::string> inputs{any(changing_)};
        if (!final_.empty() && chance(80)) inputs.insert(inputs.begin() + below(2), any(final_));
        if (!final_.empty() && chance(20)) inputs = {any(final_) + "@change0"};
        add_changing("reader" + std::to_string(readers_++), inputs);
    }

    std::mt19937 random_;
    bool is_real_, has_unwoken_;
    RandomRest made_;
    std::vector<std::string> resources_, passes_;
    std::vector<std::string> final_,
        kept_;                           // Parts of kept images; all passes that write them have been added.
    std::vector<std::string> changing_;  // Transients that passes without "rest" have written.
    uint32_t readers_ = 0;
};

}  // namespace

RandomRest random_rest(uint32_t seed, RestShaders shaders, bool has_unwoken) {
    return RestGenerator(seed, shaders, has_unwoken).run();
}

ShaderCatalog rest_shaders() {
    ShaderCatalog shaders;
    shaders["s0.comp"] = compute({image_out("dst")});
    shaders["s1.comp"] = compute({sampled("a"), image_out("dst")});
    shaders["s2.comp"] = compute({sampled("a"), sampled("b"), image_out("dst")});
    shaders["i0.comp"] = compute({image_out("dst")});
    shaders["i1.comp"] = compute({image_in("a"), image_out("dst")});
    shaders["i2.comp"] = compute({image_in("a"), sampled("b"), image_out("dst")});
    shaders["s0.frag"] = fragment({"dst"});
    shaders["s1.frag"] = fragment({"dst"}, {sampled("a")});
    shaders["s2.frag"] = fragment({"dst"}, {sampled("a"), sampled("b")});
    shaders["change.comp"] = compute({image_in_out("dst")});
    return shaders;
}

}  // namespace weft::test
