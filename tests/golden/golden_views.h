// Purpose: reads the views of tests/golden/views.txt, for all tests that render them.
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
    // Returns the arguments of `weft render` for this view, with `graph_file` as the graph and `picture` as
    // the output. The command also writes a statistics file beside the picture.
    [[nodiscard]] std::vector<std::string> render(const std::filesystem::path& graph_file,
                                                  const std::filesystem::path& picture) const;
};

[[nodiscard]] std::vector<GoldenView> golden_views();

}  // namespace weft::test
