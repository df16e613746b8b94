#include "tests/graph/samples/random_groups.h"

#include <random>

#include "tests/graph/samples/fake_shaders.h"

namespace weft::test {
namespace {

std::string joined(const std::vector<std::string>& items) {
    std::string all;
    for (const std::string& item : items) all += (all.empty() ? "" : ",\n") + item;
    return all;
}

class GroupGenerator {
 public:
    GroupGenerator(uint32_t seed, bool pure, RestShaders shaders)
        : random_(seed), pure_(pure), is_real_(shaders == RestShaders::real) {}

    RandomGroups run() {
        resource("image0", "");
        pass("change0", compute({}, "image0"));
        changing_ = "image0";
        const uint32_t groups = 1 + below(2);
        for (uint32_t g = 0; g < groups; ++g) {
            add_group(g);
            if (chance(50)) add_reader();
            if (chance(40)) add_resting_reader();
        }
        add_reader();
        for (size_t i = 0; i < kept_.size(); ++i)
            pass("see" + std::to_string(i), R"("type": "readback", "in": [")" + kept_[i] + "\"]");
        pass("seeLast", R"("type": "readback", "in": [")" + changing_ + "\"]");
        std::string params;
        for (uint32_t i = 0; i < made_.params; ++i)
            params +=
                (i == 0 ? "\"p" : ", \"p") + std::to_string(i) + R"(": {"default": 0, "range": [0, 1]})";
        std::string imports;
        for (const std::string& order : made_.turns) imports += ", \"" + order + R"(": "turns")";
        const std::string head =
            is_real_ ? R"("params": {)" + params + "}" : R"("imports": {"noise": "image")" + imports + "}";
        made_.text = head + R"(, "resources": {)" + joined(resources_) + R"(}, "groups": {)" +
                     joined(groups_) + R"(}, "passes": {)" + joined(passes_) + "}";
        return std::move(made_);
    }

 private:
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    bool chance(uint32_t percent) { return below(100) < percent; }
    const std::string& any(const std::vector<std::string>& items) {
        return items[below(static_cast<uint32_t>(items.size()))];
    }

    void pass(const std::string& name, const std::string& body) {
        passes_.push_back("\"" + name + "\": {" + body + "}");
    }
    void resource(const std::string& name, const std::string& more) {
        resources_.push_back("\"" + name + R"(": {"format": "rgba16f", "size": 64)" + more + "}");
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

    // Returns the keys of a pass that reads at most two inputs and writes all of `target`.
    std::string work(const std::vector<std::string>& inputs, const std::string& target, bool draws) {
        std::string ports;
        size_t single = 0;
        bool has_array = false;
        for (const std::string& input : inputs) {
            const bool is_array =
                input.find("probes") != std::string::npos && input.find('.') == std::string::npos;
            const std::string port = is_array ? "w" : single++ == 0 ? "a" : "b";
            ports += (ports.empty() ? "\"" : ", \"") + port + "\": " + reference(input);
            has_array |= is_array;
        }
        const char kind = !draws && chance(30) ? 'i' : 's';  // Storage images or sampled images as inputs.
        return std::string(R"("type": ")") + (draws ? "fullscreen" : "compute") + R"(", "shader": ")" + kind +
               std::to_string(single) + (has_array ? "w" : "") + (draws ? ".frag" : ".comp") + "\"" +
               (ports.empty() ? "" : R"(, "in": {)" + ports + "}") + R"(, "out": {"dst": ")" + target +
               "\"}" + param();
    }

    // Returns the key that gives a shader its parameter.
    std::string param() {
        if (!is_real_) return "";
        return R"(, "params": {"value": "p)" + std::to_string(made_.params++) + "\"}";
    }
    std::string compute(const std::vector<std::string>& inputs, const std::string& target) {
        return work(inputs, target, false) + queue();
    }

    // Returns up to `most` inputs from outside the group.
    std::vector<std::string> outside_inputs(bool rests, size_t most) {
        std::vector<std::string> inputs;
        const auto add = [&](const std::string& input) {
            if (inputs.size() < most && (inputs.empty() || inputs.front() != input)) inputs.push_back(input);
        };
        if (!pure_ && chance(40)) add((rests ? "?" : "") + changing_);
        if (!is_real_ && chance(30)) add("noise");
        if (!still_.empty() && chance(50)) add(any(still_));
        return inputs;
    }

    // Adds a group. Its rounds write the layers of an image, through none, one or two images of their own.
    void add_group(uint32_t number) {
        const std::string id = std::to_string(number), image = "probes" + id;
        const uint32_t rounds = 2 + below(2);
        const bool rests = pure_ || chance(60);
        resource(image, R"(, "keep": true, "layers": )" + std::to_string(rounds + 1));
        std::vector<std::string> members, locals;
        std::vector<std::string> inputs = outside_inputs(rests, 2);
        // The group may also read results of its other rounds: a fixed layer, or the whole image.
        const uint32_t steps = below(3);
        if (!pure_ && steps > 0 && inputs.size() < 2 && chance(50))
            inputs.push_back("?" + image + (chance(50) ? ".layer(0)" : ""));
        for (uint32_t step = 0; step < steps; ++step) {
            const std::string local = "raw" + std::to_string(step);
            locals.push_back("\"" + local + R"(": {"format": "rgba16f", "size": 64})");
            add_member(members, "step" + std::to_string(step), inputs, local);
            if (chance(30))
                members.push_back(R"("again)" + std::to_string(step) +
                                  R"(": {"type": "compute", "shader": "change.comp", "out": {"dst": ")" +
                                  local + R"("}, "after": ["step)" + std::to_string(step) + "\"]" + queue() +
                                  "}");
            inputs = {local};
            if (chance(40))
                for (const std::string& more : outside_inputs(rests, 1)) inputs.push_back(more);
            if (chance(20)) made_.observed.push_back("group" + id + "::" + local);
        }
        add_member(members, "store", inputs, image + ".layer(i)");
        groups_.push_back("\"group" + id + R"(": {"repeat": {"i": "0..)" + std::to_string(rounds - 1) +
                          "\"}" + (rests ? R"(, "rest": true)" : "") + turn_keys(id, rests) +
                          R"(, "resources": {)" + joined(locals) + R"(}, "passes": {)" + joined(members) +
                          "}}");
        pass("last" + id, work({}, image + ".layer(" + std::to_string(rounds) + ")", false));
        for (uint32_t layer = 0; layer < rounds; ++layer) {
            kept_.push_back(image + ".layer(" + std::to_string(layer) + ")");
            if (rests) still_.push_back(kept_.back());
        }
    }

    // Returns keys that limit the rounds of each frame.
    std::string turn_keys(const std::string& id, bool rests) {
        std::string keys;
        if (pure_) return keys;
        if (chance(50)) keys += R"(, "perFrame": )" + std::to_string(below(3));
        if (chance(40)) keys += R"(, "warmUp": )" + std::to_string(below(3));
        if (rests && chance(40)) keys += R"(, "settle": )" + std::to_string(1 + below(2));
        if (!chance(40)) return keys;
        made_.turns.push_back("order" + id);
        return keys + R"(, "turns": "order)" + id + "\"";
    }

    void add_member(std::vector<std::string>& members, const std::string& name,
                    const std::vector<std::string>& inputs, const std::string& target) {
        const bool draws = chance(25);
        members.push_back("\"" + name + "\": {" + work(inputs, target, draws) + (draws ? "" : queue()) + "}");
    }

    // Adds a pass that runs in every frame and reads results of groups.
    void add_reader() {
        const std::string id = std::to_string(readers_++);
        resource("read" + id, "");
        std::vector<std::string> inputs{changing_};
        inputs.insert(inputs.begin() + below(2), chance(50) ? any(kept_) : whole(any(kept_)));
        pass("reader" + id, compute(inputs, "read" + id));
        changing_ = "read" + id;
    }

    static std::string whole(const std::string& part) { return part.substr(0, part.find('.')); }

    // Adds a pass with "rest" outside the groups.
    void add_resting_reader() {
        if (still_.empty()) return;
        const std::string id = std::to_string(readers_++);
        resource("still" + id, R"(, "keep": true)");
        pass("rests" + id, compute({any(still_)}, "still" + id) + R"(, "rest": true)");
        still_.push_back("still" + id);
        kept_.push_back("still" + id);
    }

    std::mt19937 random_;
    bool pure_, is_real_;
    RandomGroups made_;
    std::vector<std::string> resources_, groups_, passes_;
    std::vector<std::string> kept_;   // Parts that keep their content.
    std::vector<std::string> still_;  // Those of them whose content changes only if a unit with "rest" runs.
    std::string changing_;            // A transient that a pass writes in every frame.
    uint32_t readers_ = 0;
};

ShaderBinding sampled_array(std::string name) {
    ShaderBinding binding = sampled(std::move(name));
    binding.arrayed = true;
    return binding;
}

}  // namespace

ShaderCatalog group_shaders() {
    ShaderCatalog shaders = rest_shaders();
    for (const char* kind : {"s", "i"}) {
        const std::string name(kind);
        const auto single = [&](const char* port) { return name == "s" ? sampled(port) : image_in(port); };
        shaders[name + "0w.comp"] = weft::test::compute({sampled_array("w"), image_out("dst")});
        shaders[name + "1w.comp"] = weft::test::compute({single("a"), sampled_array("w"), image_out("dst")});
    }
    shaders["s0w.frag"] = fragment({"dst"}, {sampled_array("w")});
    shaders["s1w.frag"] = fragment({"dst"}, {sampled("a"), sampled_array("w")});
    return shaders;
}

RandomGroups random_groups(uint32_t seed, bool pure, RestShaders shaders) {
    return GroupGenerator(seed, pure, shaders).run();
}

}  // namespace weft::test
