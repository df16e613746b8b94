// Numbers within pictures: digits of 3 × 5 pixels, 4 apart.

// Fifteen bits from the upper left, the first one the highest.
const uint kDigits[10] = uint[](0x7B6Fu, 0x2C97u, 0x73E7u, 0x73CFu, 0x5BC9u, 0x79CFu, 0x79EFu, 0x7292u, 0x7BEFu, 0x7BCFu);

bool is_digit(uint digit, ivec2 at) {
    if (any(lessThan(at, ivec2(0))) || at.x > 2 || at.y > 4) return false;
    return (kDigits[digit] >> (14 - at.y * 3 - at.x) & 1u) == 1u;
}

int digits_of(uint number) { return number < 10u ? 1 : number < 100u ? 2 : number < 1000u ? 3 : number < 10000u ? 4 : 5; }

// Whether the pixel, counted from the number's upper left, is a part of it.
bool is_number(uint number, ivec2 at) {
    const int count = digits_of(number), place = at.x >> 2;
    if (at.x < 0 || place >= count) return false;
    for (int i = count - 1; i > place; --i) number /= 10u;
    return is_digit(number % 10u, ivec2(at.x & 3, at.y));
}
