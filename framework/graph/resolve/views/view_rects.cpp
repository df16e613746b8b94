#include "graph/resolve/views/view_rects.h"

namespace weft {
namespace {

Diagnostic fault(const std::string& message, const std::string& help) {
    Diagnostic d;
    d.message = message;
    d.help = {help};
    return d;
}

std::string extent_of(const Extent3D& extent) {
    return std::to_string(extent.width) + " x " + std::to_string(extent.height) + " px";
}

Result<RectPx> written_rect(const std::array<Expr, 4>& expressions, const Evaluator& evaluator) {
    constexpr double kMost = 1u << 30;
    std::array<double, 4> numbers{};
    for (size_t i = 0; i < 4; ++i) {
        const std::optional<double> number =
            evaluator.number(expressions[i], "a number of \"rect\"", i < 2 ? 0 : 1, kMost);
        if (!number) return Diagnostics{};
        numbers[i] = *number;
    }
    return RectPx{static_cast<int32_t>(numbers[0]), static_cast<int32_t>(numbers[1]),
                  static_cast<uint32_t>(numbers[2]), static_cast<uint32_t>(numbers[3])};
}

Result<RectPx> grid_cell(uint32_t count, uint32_t number, const Extent3D& extent) {
    uint32_t columns = 1;
    while (columns * columns < count) ++columns;
    const uint32_t rows = (count + columns - 1) / columns;
    const uint32_t width = extent.width / columns, height = extent.height / rows;
    if (width == 0 || height == 0)
        return fault("its attachments have " + extent_of(extent) + ", which is too small for " +
                         std::to_string(count) + " views",
                     "make the attachments larger");
    return RectPx{static_cast<int32_t>(number % columns * width),
                  static_cast<int32_t>(number / columns * height), width, height};
}

bool lies_inside(const RectPx& rect, const Extent3D& extent) {
    return rect.x >= 0 && rect.y >= 0 && uint64_t{rect.width} + static_cast<uint64_t>(rect.x) <= extent.width &&
           uint64_t{rect.height} + static_cast<uint64_t>(rect.y) <= extent.height;
}

}  // namespace

Result<RectPx> view_rect(const ViewList& list, uint32_t number, const Extent3D& extent,
                         const Evaluator& evaluator) {
    const size_t index = size_t{list.first} + number;
    const bool given = list.import != nullptr && index < list.import->rects.size();
    Result<RectPx> rect = list.desc != nullptr && list.desc->rect ? written_rect(*list.desc->rect, evaluator)
                          : given ? Result<RectPx>(list.import->rects[index])
                                  : grid_cell(list.count, number, extent);
    if (!rect || lies_inside(*rect, extent)) return rect;
    return fault("the rectangle of view " + std::to_string(number) + " is " + std::to_string(rect->width) +
                     " x " + std::to_string(rect->height) + " px at " + std::to_string(rect->x) + ", " +
                     std::to_string(rect->y) + ", but the attachments have " + extent_of(extent),
                 "choose a rectangle inside the attachments, or make the attachments larger");
}

}  // namespace weft
