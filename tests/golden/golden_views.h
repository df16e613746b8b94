// The views of tests/golden/views.txt, for every test that draws them.
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
    // `weft render` with the view's options, but for `graph_file`. A file of statistics is written beside `picture`.
    [[nodiscard]] std::vector<std::string> render(const std::filesystem::path& graph_file,
                                                  const std::filesystem::path& picture) const;
};

[[nodiscard]] std::vector<GoldenView> golden_views();

}  // namespace weft::test
