#include "tests/viewer/pictures/pfm_image.h"

#include <fstream>

namespace weft::test {

std::optional<PfmImage> read_pfm(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    float scale = 0;
    PfmImage image;
    file >> magic >> image.width_px >> image.height_px >> scale;
    file.get();
    if (!file || magic != "PF" || scale >= 0 || image.width_px > 16384 || image.height_px > 16384)
        return std::nullopt;
    image.texels.resize(size_t{image.width_px} * image.height_px);
    for (uint32_t y = image.height_px; y-- > 0;) {
        auto* row = reinterpret_cast<char*>(&image.texels[size_t{y} * image.width_px]);
        file.read(row, static_cast<std::streamsize>(image.width_px * sizeof image.texels[0]));
    }
    if (!file) return std::nullopt;
    return image;
}

}  // namespace weft::test
