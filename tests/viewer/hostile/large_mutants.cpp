#include "tests/viewer/hostile/large_mutants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string_view>

namespace weft::test {
namespace {

constexpr size_t kMostBytes = 1u << 20;

// Texts of the sections of a graph, without the outer braces or brackets of each section.
struct Sections {
    std::string consts, sizes, params, resources, passes, debug, tests, tiers, other;
};

class Maker {
 public:
    explicit Maker(uint32_t seed) : random_(seed) {}

    LargeMutant make(uint32_t seed) {
        using Kind = void (Maker::*)();
        struct Named {
            const char* name;
            Kind fill;
        };
        static constexpr std::array kKinds{Named{"deep values", &Maker::deep_values},
                                           Named{"deep expression", &Maker::deep_expression},
                                           Named{"wide constants", &Maker::wide_constants},
                                           Named{"wide parameters", &Maker::wide_params},
                                           Named{"wide resources", &Maker::wide_resources},
                                           Named{"wide passes", &Maker::wide_passes},
                                           Named{"wide ports", &Maker::wide_ports},
                                           Named{"wide tiers", &Maker::wide_tiers},
                                           Named{"wide tests", &Maker::wide_tests},
                                           Named{"wide views", &Maker::wide_views},
                                           Named{"wide repeats", &Maker::wide_repeats},
                                           Named{"wide expressions", &Maker::wide_expressions},
                                           Named{"wide ranges", &Maker::wide_ranges},
                                           Named{"wide orders", &Maker::wide_orders},
                                           Named{"chained constants", &Maker::chained_names},
                                           Named{"chained passes", &Maker::chained_passes},
                                           Named{"chained orders", &Maker::chained_orders},
                                           Named{"chained pins", &Maker::chained_pins},
                                           Named{"misspelt resources", &Maker::misspelt_resources},
                                           Named{"misspelt passes", &Maker::misspelt_passes},
                                           Named{"misspelt names", &Maker::misspelt_names},
                                           Named{"misspelt keys", &Maker::misspelt_keys}};
        bytes_ = static_cast<size_t>(std::exp2(10 + 10 * fraction()));
        const Named& kind = kKinds[below(kKinds.size())];
        (this->*kind.fill)();
        LargeMutant mutant{seed, kind.name, assemble()};
        mutant.text.resize(std::min(mutant.text.size(), kMostBytes));
        mutant.how += ", " + std::to_string(mutant.text.size()) + " bytes";
        for (size_t damage = below(3); damage > 0; --damage) mutant.how += ", " + spoil(mutant.text);
        return mutant;
    }

 private:
    size_t below(size_t n) { return static_cast<size_t>(random_() % std::max<size_t>(n, 1)); }
    double fraction() { return static_cast<double>(random_() % 1'000'003) / 1'000'003; }
    bool once_in(size_t n) { return below(n) == 0; }
    static std::string text_of(size_t i) { return std::to_string(i); }

    // Appends members until the section has at least bytes_ bytes, a randomly chosen size. `member` returns
    // the text of the member with the given index, starting at 0.
    void fill(std::string& section, const std::function<std::string(size_t)>& member) {
        for (size_t i = 0; section.size() < bytes_; ++i) section += (i == 0 ? "" : ",\n") + member(i);
    }

    std::string a_word(size_t bytes) {
        std::string word(1, 'a');
        while (word.size() < bytes) word += "abcdefgh_0123"[below(13)];
        return word;
    }
    // Removes, inserts or changes one letter of the word.
    std::string misspell(std::string word) {
        const size_t at = below(word.size());
        switch (below(3)) {
            case 0:
                word.erase(at, 1);
                break;
            case 1:
                word.insert(at, 1, 'x');
                break;
            default:
                word[at] = 'q';
        }
        return word;
    }
    std::string clear_pass(const std::string& name, const std::string& target, const std::string& more = "") {
        return "\"" + name + "\": { \"type\": \"clear\", \"out\": [\"" + target + "\"]" + more + " }";
    }
    std::string copy_pass(const std::string& name, const std::string& from, const std::string& to,
                          const std::string& more = "") {
        return "\"" + name + "\": { \"type\": \"copy\", \"in\": [\"" + from + "\"], \"out\": [\"" + to +
               "\"]" + more + " }";
    }

    void deep_values() {
        const std::array kOpen{"[", "{\"a\":", "[{\"a\":"};
        std::string deep;
        const char* open = kOpen[below(3)];
        while (deep.size() < bytes_) deep += open;
        parts_.other = "\"extra\": " + deep;
    }
    void deep_expression() {
        const std::array kOpen{"(", "-", "max(1,", "min(", "1+("};
        const char* open = kOpen[below(5)];
        fill(parts_.consts, [&](size_t i) {
            std::string deep;
            for (size_t n = below(4000); deep.size() < n;) deep += open;
            return "\"c" + text_of(i) + "\": \"" + deep + "1" + std::string(below(200), ')') + "\"";
        });
    }
    void wide_constants() {
        const size_t length = 1 + below(200);
        fill(parts_.consts, [&](size_t i) { return "\"c" + text_of(i) + a_word(length) + "\": 1"; });
    }
    void wide_params() {
        fill(parts_.params, [&](size_t i) {
            return "\"p" + text_of(i) + "\": " + (once_in(2) ? "1" : "{ \"default\": 2, \"range\": [0, 1] }");
        });
    }
    void wide_resources() {
        const std::array kKinds{"\"rgba8\"", "{ \"format\": \"r8|rgba8|bad\", \"mips\": \"full\" }",
                                "{ \"format\": \"r8\", \"history\": 16 }", "{ \"buffer\": \"u32\" }",
                                "{ \"format\": \"r8\", \"size\": \"output / 0\" }"};
        const size_t kinds = 1 + below(kKinds.size());
        fill(parts_.resources, [&](size_t i) { return "\"r" + text_of(i) + "\": " + kKinds[below(kinds)]; });
    }
    void wide_passes() {
        parts_.resources = "\"x\": \"rgba8\", \"y\": \"rgba8\"";
        const bool ordered = once_in(2);
        fill(parts_.passes, [&](size_t i) {
            if (once_in(3)) return copy_pass("p" + text_of(i), "x", "y");
            const std::string before = "\"p" + text_of(i - 1) + "\"";
            return clear_pass("p" + text_of(i), "x", i > 0 && ordered ? ", \"after\": [" + before + "]" : "");
        });
    }
    void wide_ports() {
        const size_t resources = 1 + below(3000);
        for (size_t i = 0; i < resources; ++i)
            parts_.resources += (i == 0 ? "\"r" : ", \"r") + text_of(i) + "\": \"rgba8\"";
        const size_t ports = 1 + below(once_in(2) ? 256 : 60'000);
        fill(parts_.passes, [&](size_t i) {
            std::string list;
            for (size_t port = 0; port < ports && list.size() < bytes_; ++port)
                list += (port == 0 ? "\"q" : ", \"q") + text_of(port) + "\": \"r" +
                        text_of(below(resources)) + "\"";
            return "\"p" + text_of(i) + "\": { \"type\": \"" + (once_in(2) ? "clear" : "readback") +
                   "\", \"" + (once_in(4) ? "in" : "out") + "\": {" + list + "} }";
        });
    }
    void wide_tiers() {
        parts_.resources = "\"x\": \"rgba8|rgba16f\"";
        parts_.passes = clear_pass("p", "x");
        const std::string patch = once_in(2) ? "{}" : "{ \"patch\": { \"resources\": { \"x\": \"r8\" } } }";
        const size_t tiers = once_in(2) ? 16 : SIZE_MAX;
        for (size_t i = 0; i < tiers && parts_.tiers.size() < bytes_; ++i)
            parts_.tiers += (i == 0 ? "\"t" : ", \"t") + text_of(i) + "\": " + patch;
        fill(parts_.params, [&](size_t i) { return "\"v" + text_of(i) + "\": 1"; });
    }
    void wide_tests() {
        parts_.tiers = "\"low\": {}, \"high\": {}";
        fill(parts_.tests, [&](size_t i) {
            return once_in(2) ? std::string("{ \"tiers\": \"*\", \"frames\": 10000 }")
                              : "{ \"expect\": { \"finite\": [\"r" + text_of(i) + "\"] } }";
        });
    }
    void wide_views() {
        parts_.resources = "\"x\": \"rgba8\"";
        parts_.passes = clear_pass("p", "x");
        fill(parts_.debug, [&](size_t i) { return "\"v" + text_of(i) + "\": \"x\""; });
    }
    void wide_repeats() {
        parts_.resources = "\"x\": { \"format\": \"r8\", \"size\": 16, \"layers\": 64, \"mips\": \"full\" }";
        fill(parts_.passes, [&](size_t i) {
            std::string indices;
            for (size_t n = 1 + below(once_in(3) ? 30'000 : 8), k = 0; k < n; ++k)
                indices += (k == 0 ? "\"i" : ", \"i") + text_of(k) + "\": \"0.." + text_of(below(3)) + "\"";
            return clear_pass("p" + text_of(i), once_in(2) ? "x" : "x.layer(i0)",
                              ", \"repeat\": {" + indices + "}");
        });
    }
    void wide_expressions() {
        fill(parts_.sizes, [&](size_t i) {
            const std::string part = once_in(2) ? "1" : once_in(2) ? "output.x" : "nix" + text_of(i);
            std::string sum = part;
            for (size_t n = below(700), k = 0; k < n && sum.size() < 4000; ++k) sum += "+" + part;
            return "\"s" + text_of(i) + "\": \"" + sum + "\"";
        });
    }
    void wide_ranges() {
        const std::string layers = text_of(1 + below(2048));
        for (size_t i = 0, n = 1 + below(200); i < n; ++i)
            parts_.resources += (i == 0 ? "\"r" : ", \"r") + text_of(i) +
                                R"(": { "format": "r8", "size": 32, "mips": "full", "layers": )" + layers +
                                " }";
        fill(parts_.passes, [&](size_t i) {
            const std::string target = "r" + text_of(i % 200) + ".layer(" + text_of(below(2048)) + ")";
            return once_in(4) ? copy_pass("p" + text_of(i), target, target + ".mip(1)")
                              : clear_pass("p" + text_of(i), target);
        });
    }
    void wide_orders() {
        parts_.resources = "\"x\": \"rgba8\"";
        const std::string times = text_of(below(2048));
        fill(parts_.passes, [&](size_t i) {
            return clear_pass("p" + text_of(i), "x",
                              ", \"repeat\": { \"i\": \"0.." + times + "\" }, \"after\": [\"p" +
                                  text_of(below(i + 1)) + "\", \"p0\"]");
        });
    }
    void chained_names() {
        std::string& section = once_in(2) ? parts_.consts : parts_.sizes;
        const bool circle = once_in(2);
        const size_t count = once_in(2) ? 4000 : SIZE_MAX;
        for (size_t i = 0; i < count && section.size() < bytes_; ++i)
            section += "\"c" + text_of(i) + "\": \"c" + text_of(i + 1) + " + 1\",\n";
        section += "\"last\": " + std::string(circle ? "\"c0\"" : "1");
    }
    void chained_passes() {
        const bool circle = once_in(2);
        fill(parts_.passes, [&](size_t i) {
            const std::string n = text_of(i);
            parts_.resources += (i == 0 ? "\"r" : ", \"r") + n + "\": \"rgba8\"";
            if (i == 0 && !circle) return clear_pass("p0", "r0");
            return copy_pass("p" + n, "r" + (i == 0 ? std::string("1") : text_of(i - 1)), "r" + n);
        });
    }
    void chained_orders() {
        fill(parts_.passes, [&](size_t i) {
            const std::string n = text_of(i);
            parts_.resources += (i == 0 ? "\"r" : ", \"r") + n + "\": \"rgba8\"";
            return clear_pass("p" + n, "r" + n, ", \"after\": [\"p" + text_of(i + 1) + "\"]");
        });
    }
    void chained_pins() {
        parts_.resources = "\"x\": { \"format\": \"rgba8\", \"history\": 2 }, \"y\": \"rgba8\"";
        fill(parts_.passes, [&](size_t i) {
            const std::string before = i == 0 ? "x[-1]" : "x@p" + text_of(i - 1);
            return copy_pass("p" + text_of(i), before, "x", once_in(3) ? ", \"if\": \"0\"" : "");
        });
    }
    void misspelt_resources() {
        const std::string stem = a_word(1 + below(100));
        fill(parts_.passes, [&](size_t i) {
            const std::string name = stem + text_of(i);
            parts_.resources += (i == 0 ? "\"" : ", \"") + name + "\": \"rgba8\"";
            return copy_pass("p" + text_of(i), misspell(name), name);
        });
    }
    void misspelt_passes() {
        const std::string stem = a_word(1 + below(100));
        parts_.resources = "\"x\": \"rgba8\"";
        fill(parts_.passes, [&](size_t i) {
            return clear_pass(stem + text_of(i), "x",
                              ", \"after\": [\"" + misspell(stem + text_of(i)) + "\"]");
        });
    }
    void misspelt_names() {
        const std::string stem = a_word(1 + below(100));
        fill(parts_.consts, [&](size_t i) {
            return "\"" + stem + text_of(i) + "\": \"" + misspell(stem + text_of(i + 1)) + " + 1\"";
        });
    }
    void misspelt_keys() {
        fill(parts_.passes, [&](size_t i) {
            return "\"p" + text_of(i) + "\": { \"" + misspell("type") + "\": \"clear\", \"" +
                   misspell("after") + "\": [], \"" + misspell("repeat") + "\": 1 }";
        });
    }

    std::string assemble() const {
        std::string text = "{ \"version\": 1, \"imports\": { \"backbuffer\": \"output\" }";
        const auto add = [&](const char* key, const std::string& members, char open, char close) {
            if (!members.empty()) text += ",\n\"" + std::string(key) + "\": " + open + members + close;
        };
        add("consts", parts_.consts, '{', '}');
        add("sizes", parts_.sizes, '{', '}');
        add("params", parts_.params, '{', '}');
        add("resources", parts_.resources, '{', '}');
        add("debug", parts_.debug, '{', '}');
        add("tests", parts_.tests, '[', ']');
        add("tiers", parts_.tiers, '{', '}');
        text += ",\n\"passes\": {" + parts_.passes + (parts_.passes.empty() ? "" : ",\n") +
                R"("show": { "type": "clear", "out": ["backbuffer"] } })";
        if (!parts_.other.empty()) text += ",\n" + parts_.other;
        return text + " }";
    }

    std::string spoil(std::string& text) {
        const size_t at = below(text.size());
        switch (below(5)) {
            case 0:
                text[at] = static_cast<char>(random_() & 0xFF);
                return "a byte changed";
            case 1:
                text[at] = "{}[]\",:\n"[below(8)];
                return "a mark set";
            case 2:
                text.resize(at);
                return "cut off";
            case 3:
                text.erase(at, below(100));
                return "a piece cut out";
            default:
                std::ranges::replace(text, '\n', ' ');
                return "all on one line";
        }
    }

    std::mt19937 random_;
    size_t bytes_ = 0;
    Sections parts_;
};

}  // namespace

LargeMutant make_large_mutant(uint32_t seed) {
    return Maker(seed).make(seed);
}

}  // namespace weft::test
