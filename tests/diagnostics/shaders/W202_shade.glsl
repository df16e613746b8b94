// The fault is in a file that the shader includes.
vec4 shade(float amount) {
    return vec4(amuont);
    //          ^ W202
}
