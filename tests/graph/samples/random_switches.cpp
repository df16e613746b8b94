#include "tests/graph/samples/random_switches.h"

#include <random>
#include <set>
#include <vector>

#include "tests/graph/samples/fake_shaders.h"

namespace weft::test {
namespace {

class SwitchGenerator {
 public:
    explicit SwitchGenerator(uint32_t seed) : random_(seed) { made_.switches = 1 + below(kMostSwitches); }

    RandomSwitches run() {
        add_base();
        const uint32_t steps = 4 + below(8);
        for (uint32_t i = 0; i < steps; ++i) add_step(i < made_.switches ? i : below(made_.switches));
        for (size_t i = 0; i < images_.size(); ++i)
            if (chance(50) || i + 1 == images_.size() || watched_.contains(i))
                pass("see" + std::to_string(i), R"("type": "readback", "in": [")" + images_[i] + "\"]");
        std::string params;
        for (uint32_t s = 0; s < made_.switches; ++s)
            params += (s == 0 ? "\"s" : ", \"s") + std::to_string(s) + "\": true";
        made_.text = R"("params": {)" + params + R"(}, "resources": {)" + joined(resources_) +
                     R"(}, "passes": {)" + joined(passes_) + "}";
        return std::move(made_);
    }

 private:
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    bool chance(uint32_t percent) { return below(100) < percent; }
    const std::string& any_image() { return images_[below(static_cast<uint32_t>(images_.size()))]; }

    static std::string joined(const std::vector<std::string>& items) {
        std::string all;
        for (const std::string& item : items) all += (all.empty() ? "" : ",\n") + item;
        return all;
    }

    std::string fresh(const char* what) { return what + std::to_string(names_++); }

    void pass(const std::string& name, const std::string& body) {
        passes_.push_back("\"" + name + "\": {" + body + "}");
    }
    std::string resource(const char* what, const std::string& more = "") {
        std::string name = fresh(what);
        resources_.push_back("\"" + name + R"(": {"format": "rgba16f", "size": 64)" + more + "}");
        return name;
    }
    std::string queue() {
        if (chance(55)) return "";
        return chance(60) ? R"(, "queue": "async")" : R"(, "queue": "graphics")";
    }
    std::string switched(uint32_t s) const {
        return std::string(R"(, "switch": ")") + (inverted_ ? "!s" : "s") + std::to_string(s) + "\"";
    }

    // Returns the keys of a pass that reads `input` and writes all of `target`. Some of the passes draw, and
    // some read the input as a storage image, so that layouts differ.
    std::string copy_of(const std::string& input, const std::string& target) {
        const uint32_t roll = below(3);
        const char* shader = roll == 0 ? "s1.frag" : roll == 1 ? "i1.comp" : "s1.comp";
        return std::string(R"("type": ")") + (roll == 0 ? "fullscreen" : "compute") + R"(", "shader": ")" +
               shader + R"(", "in": {"a": ")" + input + R"("}, "out": {"dst": ")" + target + "\"}" +
               (roll == 0 ? "" : queue());
    }

    void add_base() {
        const std::string image = resource("base");
        pass(fresh("fill"), R"("type": "compute", "shader": "s0.comp", "out": {"dst": ")" + image + "\"}");
        images_.push_back(image);
    }

    void add_step(uint32_t s) {
        inverted_ = chance(25);
        const uint32_t roll = below(100);
        if (roll < 25) return modify(s);
        if (roll < 40) return overwrite(s);
        if (roll < 65) return replace(s);
        if (roll < 80) return keep(s);
        if (roll < 90) return chain(s);
        read_anything();
    }

    // A new image that always exists, and a pass with a switch that modifies it in place.
    void modify(uint32_t s) {
        const std::string image = resource("changed"), made = fresh("make"), changed = fresh("change");
        pass(made, copy_of(any_image(), image));
        pass(changed, R"("type": "compute", "shader": "change.comp", "out": {"dst": ")" + image +
                          R"("}, "after": [")" + made + "\"]" + switched(s) + queue());
        if (chance(40)) {
            // Another pass modifies it again, with another switch or without one.
            inverted_ = chance(25);
            pass(fresh("again"), R"("type": "compute", "shader": "change.comp", "out": {"dst": ")" + image +
                                     R"("}, "after": [")" + changed + "\"]" +
                                     (chance(60) ? switched(below(made_.switches)) : "") + queue());
        }
        images_.push_back(image);
    }

    // A pass with a switch replaces all of an image that always exists.
    void overwrite(uint32_t s) {
        const std::string image = resource("replaced"), made = fresh("make"), over = fresh("over");
        const std::string before = any_image();
        pass(made, copy_of(before, image));
        if (chance(40)) {
            const std::string early = resource("early");
            pass(fresh("look"), copy_of(image + "@" + made, early));
            images_.push_back(early);
        }
        pass(over, copy_of(any_image(), image) + R"(, "after": [")" + made + "\"]" + switched(s));
        images_.push_back(image);
    }

    // A pass with a switch writes a new image; other passes read it with "else" or "optional".
    void replace(uint32_t s) {
        const std::string image = resource("extra"), other = any_image();
        pass(fresh("extra"), copy_of(any_image(), image) + switched(s));
        const uint32_t readers = 1 + below(2);
        for (uint32_t i = 0; i < readers; ++i) {
            const std::string target = resource("seen");
            const bool optional = chance(50);
            const std::string port =
                R"({"ref": ")" + image +
                (optional ? R"(", "optional": true})" : R"(", "else": ")" + other + "\"}");
            pass(fresh("reader"), std::string(R"("type": "compute", "shader": ")") +
                                      (optional ? "o2" : "v2") + R"(.comp", "in": {"a": ")" + any_image() +
                                      R"(", "b": )" + port + R"(}, "out": {"dst": ")" + target + "\"}" +
                                      queue());
            images_.push_back(target);
        }
    }

    // A pass with a switch writes an image that keeps its content.
    void keep(uint32_t s) {
        const std::string image = resource("kept", R"(, "keep": true)"), target = resource("seen");
        pass(fresh("keep"), copy_of(any_image(), image) + switched(s));
        pass(fresh("reader"), R"("type": "compute", "shader": "v2.comp", "in": {"a": ")" + any_image() +
                                  R"(", "b": ")" + image + R"("}, "out": {"dst": ")" + target + "\"}" +
                                  queue());
        images_.push_back(target);
        watched_.insert(images_.size() - 1);
    }

    // Two passes with one switch: the second reads a new image of the first and modifies an older image.
    void chain(uint32_t s) {
        const std::string local = resource("local"), image = resource("changed"), made = fresh("make");
        pass(made, copy_of(any_image(), image));
        pass(fresh("local"), copy_of(any_image(), local) + switched(s));
        pass(fresh("mix"), copy_of(local, image) + R"(, "after": [")" + made + "\"]" + switched(s));
        images_.push_back(image);
    }

    void read_anything() {
        const std::string target = resource("seen");
        pass(fresh("reader"), R"("type": "compute", "shader": "s2.comp", "in": {"a": ")" + any_image() +
                                  R"(", "b": ")" + any_image() + R"("}, "out": {"dst": ")" + target + "\"}" +
                                  queue());
        images_.push_back(target);
    }

    std::mt19937 random_;
    RandomSwitches made_;
    std::vector<std::string> resources_, passes_;
    std::vector<std::string> images_;  // Images that have content in every frame.
    // Indices of images that are always read back. So the passes that keep content are never culled, also not
    // in a graph that has "if" instead of "switch".
    std::set<size_t> watched_;
    uint32_t names_ = 0;
    bool inverted_ = false;
};

}  // namespace

RandomSwitches random_switches(uint32_t seed) {
    return SwitchGenerator(seed).run();
}

ShaderCatalog switch_shaders() {
    ShaderCatalog shaders;
    shaders["s0.comp"] = compute({image_out("dst")});
    shaders["s1.comp"] = compute({sampled("a"), image_out("dst")});
    shaders["i1.comp"] = compute({image_in("a"), image_out("dst")});
    shaders["s0.frag"] = fragment({"dst"});
    shaders["s1.frag"] = fragment({"dst"}, {sampled("a")});
    shaders["s2.comp"] = compute({sampled("a"), sampled("b"), image_out("dst")});
    shaders["v2.comp"] =
        with_params(compute({sampled("a"), sampled("b"), image_out("dst")}), {member("bValid")});
    shaders["o2.comp"] = with_constants(
        with_params(compute({sampled("a"), sampled("b"), image_out("dst")}), {member("bSize", 2)}),
        {{"HAS_b", ScalarType::boolean}});
    shaders["change.comp"] = compute({image_in_out("dst")});
    return shaders;
}

}  // namespace weft::test
