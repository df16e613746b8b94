// Classes of tiles by the lighting code that they need. Each class has a separate dispatch.

const uint kTileSky = 0u;          // no surface
const uint kTileDirectional = 1u;  // surfaces, but no listed light
const uint kTilePunctual = 2u;     // points and spots without light functions
const uint kTileAny = 3u;
const uint kTileClasses = 4u;

// A list of tiles in the form of an indirect dispatch: three workgroup counts, with one workgroup per tile,
// then the tiles, row by row.
const uint kTilesBegin = 3u;
