// Usage: same_picture PICTURE.png PICTURE.ppm
// Returns 0 if both pictures have the same size and the same RGB values. The program is compiled only with
// the flags that pkg-config gives for the installed Weft, so it also tests these flags.
#include <weft/scene/image_decode.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

std::vector<uint8_t> bytes_of(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const weft::scene::DecodedImage png = weft::scene::decode_image(bytes_of(argv[1]));
    const std::string header =
        "P6\n" + std::to_string(png.size.width_px) + " " + std::to_string(png.size.height_px) + "\n255\n";
    std::vector<uint8_t> expected(header.begin(), header.end());
    for (size_t i = 0; i < png.rgba.size(); ++i)
        if (i % 4 != 3) expected.push_back(png.rgba[i]);
    const auto [least, most] = std::minmax_element(png.rgba.begin(), png.rgba.end());
    if (png.rgba.empty() || *least == *most)
        return std::fputs("an empty picture proves nothing\n", stderr), 1;
    if (expected != bytes_of(argv[2])) return std::fputs("the pictures differ\n", stderr), 1;
    return 0;
}
