#include "tests/golden/golden_views.h"

#include <fstream>
#include <sstream>

namespace weft::test {
namespace {

const std::filesystem::path kFolder = WEFT_SOURCE_DIR "/tests/golden";

}  // namespace

std::filesystem::path GoldenView::picture() const {
    return kFolder / (name() + ".png");
}

std::vector<std::string> GoldenView::render(const std::filesystem::path& graph_file,
                                            const std::filesystem::path& picture) const {
    std::vector<std::string> words{
        "render", "builtin:" + scene, "--graph", graph_file.string(), "--camera", camera,
        "--size", "320x180",          "-o",      picture.string(),    "--stats",  picture.string() + ".json"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

std::vector<GoldenView> golden_views() {
    std::ifstream file(kFolder / "views.txt");
    std::vector<GoldenView> found;
    for (std::string line; std::getline(file, line);) {
        GoldenView view;
        std::istringstream words(line);
        if (line.starts_with("#") || !(words >> view.graph >> view.scene >> view.camera)) continue;
        for (std::string option; words >> option;) view.options.push_back(option);
        found.push_back(view);
    }
    return found;
}

}  // namespace weft::test
