#include "scene/pictures/light_picture.h"

#include <algorithm>

#include "scene/pictures/picture_level.h"

namespace weft::scene {

LightPicture light_picture(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> radiance) {
    PictureLevel level = reduced(width_px, height_px, radiance, std::min(width_px, kMostLightWidth_px),
                                 std::min(height_px, kMostLightHeight_px));
    LightPicture picture;
    picture.width_px = level.width_px;
    picture.height_px = level.height_px;
    picture.scale = stored_scale(level.texels);
    picture.brightest = brightest(level.texels);
    picture.mips.push_back(packed(evened_towards_poles(level).texels, picture.scale));
    while (level.width_px > 1 || level.height_px > 1) {
        level = half_of(level.width_px, level.height_px, level.texels);
        picture.mips.push_back(packed(evened_towards_poles(level).texels, picture.scale));
    }
    return picture;
}

}  // namespace weft::scene
