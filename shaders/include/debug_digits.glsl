// Draws numbers into pictures. A digit has 3 × 5 pixels and starts 4 pixels to the right of the previous digit.
#ifndef WEFT_DEBUG_DIGITS
#define WEFT_DEBUG_DIGITS

// The 3 × 5 pixels of each digit as 15 bits, row by row from the upper left. The first pixel is the highest bit.
const uint kDigits[10] = uint[](0x7B6Fu, 0x2C97u, 0x73E7u, 0x73CFu, 0x5BC9u, 0x79CFu, 0x79EFu, 0x7292u, 0x7BEFu, 0x7BCFu);

bool is_digit(uint digit, ivec2 at) {
    if (any(lessThan(at, ivec2(0))) || at.x > 2 || at.y > 4) return false;
    return (kDigits[digit] >> (14 - at.y * 3 - at.x) & 1u) == 1u;
}

int digits_of(uint number) {
    int count = 1;
    for (; number >= 10u; number /= 10u) ++count;
    return count;
}

// Returns true if the pixel is part of the drawn number. `at` is relative to the upper left corner of the number.
bool is_number(uint number, ivec2 at) {
    const int count = digits_of(number), place = at.x >> 2;
    if (at.x < 0 || place >= count) return false;
    for (int i = count - 1; i > place; --i) number /= 10u;
    return is_digit(number % 10u, ivec2(at.x & 3, at.y));
}

// A decimal number: all its digits as an integer, and how many of them are after the decimal point.
struct Decimal {
    uint digits;
    int places;
};

// Rounds to three significant digits or to an integer, whichever keeps more digits. Uses at most six decimal places,
// and fewer if the error is at most 0.05 % (0.5 has one place).
Decimal decimal_of(float number) {
    float scaled = abs(number);
    int places = 0;
    for (; places < 6 && scaled < 99.5 && abs(scaled - round(scaled)) > 5e-4 * scaled; ++places) scaled *= 10.0;
    return Decimal(uint(min(round(scaled), 4e9)), places);
}

uint power_of_ten(int exponent) {
    uint power = 1u;
    for (int i = 0; i < exponent; ++i) power *= 10u;
    return power;
}

// Returns the width of the drawn number in pixels, with the gap after it.
int decimal_width(float number) {
    const Decimal d = decimal_of(number);
    const int point = d.places > 0 ? 2 + 4 * d.places : 0;
    return (number < 0.0 ? 4 : 0) + 4 * digits_of(d.digits / power_of_ten(d.places)) + point;
}

// Returns true if the pixel is part of the drawn number. `at` is relative to the upper left corner of the number.
bool is_decimal(float number, ivec2 at) {
    const Decimal d = decimal_of(number);
    if (number < 0.0) {
        if (at.y == 2 && at.x >= 0 && at.x < 3) return true;
        at.x -= 4;
    }
    const uint whole = d.digits / power_of_ten(d.places);
    if (is_number(whole, at)) return true;
    at.x -= 4 * digits_of(whole);
    if (d.places == 0 || at.x < 0) return false;
    if (at.x < 2) return at == ivec2(0, 4);
    at.x -= 2;
    const int place = at.x >> 2;
    return place < d.places && is_digit(d.digits / power_of_ten(d.places - 1 - place) % 10u, ivec2(at.x & 3, at.y));
}
#endif
