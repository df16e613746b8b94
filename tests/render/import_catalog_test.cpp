#include "weft/render/import_catalog.h"

#include <gtest/gtest.h>

namespace weft::render {
namespace {

// The program may copy or blit the output between frames. So the import's exit state must make the frame's
// writes visible to these copies and blits. The import's entry state must make the next frame wait until they
// have finished.
TEST(ImportCatalog, TheOutputMayBeCopiedAndBlittedBetweenFrames) {
    const ImportCatalog catalog = scene_imports({64, 64, 1});
    const ResourceDecl& output = catalog.imports.at("backbuffer").resource;
    ASSERT_TRUE(output.import);
    for (const AccessState& state : {output.import->entry, output.import->exit}) {
        EXPECT_EQ(state.stages, stage::kCopy | stage::kBlit);
        EXPECT_EQ(state.access, access::kTransferRead);
    }
    EXPECT_EQ(output.import->exit.layout, Layout::transfer_src);
}

}  // namespace
}  // namespace weft::render
