// interface: reflection must reject this shader, because no pass can bind its variable.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(rgba8) writeonly uniform imageBuffer target;  // expected error line
void main() {
    imageStore(target, 0, vec4(1));
}
