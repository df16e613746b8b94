// The fault is here, two files below the graph.
vec3 darkened(vec3 color) {
    const float amount = 0.5;
    return color * /*here*/amuont;
}
