// Purpose: describes a list of views of a resolved graph: where the matrices of its views come from.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace weft {

// program: the program gives the matrices. mirror: the views of another list in a mirror. cube: the faces of
// a cube. buffer: the GPU reads the constants of view i from element i of a buffer of the graph.
enum class ViewSource : uint8_t { program, mirror, cube, buffer };

// The block with the constants of the view is this binding of descriptor set 0.
inline constexpr uint32_t kViewBinding = 1;

// A list of views. View i has the name "list(i)".
struct ViewListDecl {
    std::string name;
    ViewSource source = ViewSource::program;
    uint32_t count = 1;
    // For a mirror: the view i shows view `first` + i of the list `of`, which can also be "camera". For a
    // buffer: the name of the resource.
    std::string of;
    uint32_t first = 0;
    // The plane of a mirror, (a, b, c, d): points with a x + b y + c z + d = 0. (a, b, c) is a unit vector.
    std::array<double, 4> plane{0, 1, 0, 0};
    // For a cube: its centre, and the distance of the near planes of its faces, in metres.
    std::array<double, 3> at{0, 0, 0};
    double near_m = 0;
};

}  // namespace weft
