// Classes of tiles, by the lighting code that a tile needs. Each class has a separate dispatch.

const uint kTileSky = 0u;          // The tile shows only sky.
const uint kTileDirectional = 1u;  // The tile has surfaces. Only directional lights without light function reach it.
const uint kTilePunctual = 2u;     // The list has only points and spots. No light function is used.
const uint kTileAny = 3u;          // All other tiles: a capsule, a rectangle or a light function is used.
const uint kTileClasses = 4u;

// Layout of a list of tiles. Words 0 to 2: workgroup counts x, y, z of the indirect dispatch: (number of tiles, 1, 1).
// From word kTilesBegin on: the number of each tile of the class. Tiles are numbered row by row from 0.
const uint kTilesBegin = 3u;
