// The views of tests/golden/views.txt, for all tests that render them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace weft::test {

struct GoldenView {
    std::string graph, scene, camera;
    std::vector<std::string> options;

    [[nodiscard]] std::string name() const { return graph + "-" + scene + "-" + camera; }
    [[nodiscard]] std::filesystem::path picture() const;
    // `weft render` with the view's options, except for `graph_file`. Also writes a statistics file beside
    // `picture`.
    [[nodiscard]] std::vector<std::string> render(const std::filesystem::path& graph_file,
                                                  const std::filesystem::path& picture) const;
};

[[nodiscard]] std::vector<GoldenView> golden_views();

}  // namespace weft::test
