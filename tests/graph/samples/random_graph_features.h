// Purpose: adds the optional features to random frames: resources with history, resources that keep their
// content, mip chains, clears and copies of several mips, depth images as inputs, several draws on one image,
// indirect dispatches and arrays of layers.
#pragma once

#include "tests/graph/samples/random_graph_passes.h"

namespace weft::test {

class RandomFeatures : public RandomPasses {
 public:
    using RandomPasses::RandomPasses;

 protected:
    // Sometimes adds one of the enabled features. Returns true if it has added one.
    bool add_feature();
    void add_after_edges();

 private:
    // Adds a pass that reads images of earlier frames and writes the image of the current frame. The seed of
    // the pass may be a built-in value: the frame number, or a flag (1 if the oldest image is valid,
    // otherwise 0).
    void remember_image();
    void remember_buffer();
    void keep_image();
    void keep_buffer();
    void mip_chain();
    void clear_range();
    void copy_range();
    void divide_buffer();
    void test_against_input();
    void draw_layers();
    void draw_depth_layers();
    void draw_views();
    void dispatch_indirectly();
    void gather_layers();
    void draw_builtin_seed(PassDecl& pass, ResourceId role);

    bool has_views_ = false;  // True if the graph has the list of views that draw_views() uses.
};

}  // namespace weft::test
