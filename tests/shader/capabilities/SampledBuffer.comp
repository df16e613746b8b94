// interface: reflection must reject this shader, because no pass can bind its variable.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform samplerBuffer source;  // expected error line
void main() {
    data.items[0] = uint(texelFetch(source, 0).x);
}
