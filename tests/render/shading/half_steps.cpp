#include "tests/render/shading/half_steps.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/render/session_fixture.h"

namespace weft::test {

std::optional<std::string> read_quantized(const std::string& path) {
    std::optional<std::string> text = read_text(path);
    const std::string off = "\"quantized\": 0", on = "\"quantized\": 1";
    if (text && text->find(off) != std::string::npos) text->replace(text->find(off), off.size(), on);
    return text;
}

int most_half_steps(const std::string& name, std::span<const uint16_t> a, std::span<const uint16_t> b) {
    size_t channels = 0, differ = 0, far = 0;
    int worst = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (i % 4 == 3) continue;
        // The bits of non-negative half floats, compared as integers, count the steps.
        const int off = std::abs(int{a[i]} - int{b[i]});
        ++channels;
        differ += off > 0 ? 1 : 0;
        far += off > 16 ? 1 : 0;
        worst = std::max(worst, off);
    }
    std::printf("%s: %zu of %zu values differ, %zu by more than 16 steps of a half float, by %d at most\n",
                name.c_str(), differ, channels, far, worst);
    return worst;
}

}  // namespace weft::test
