#include "skydrop/core/deterministic_math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace skydrop::core::dmath {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPiLow = 0x1.1a62633145c07p-53;  // pi - kPi
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Value and rounding error of a sum, product or quotient: the value to about 106 bits is hi + lo.
struct Pair {
  double hi, lo;
};

Pair fastTwoSum(double big, double small) {  // |big| >= |small| (Dekker 1971)
  const double sum = big + small;
  return {sum, small - (sum - big)};
}

Pair twoSum(double a, double b) {  // Knuth, TAOCP 2, 4.2.2
  const double sum = a + b;
  const double bb = sum - a;
  return {sum, (a - (sum - bb)) + (b - bb)};
}

Pair twoProduct(double a, double b) {     // Veltkamp, Dekker 1971; |a|, |b| < 1e290
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const double ca = a * kSplit, cb = b * kSplit;
  const double ah = ca - (ca - a), bh = cb - (cb - b);
  const double al = a - ah, bl = b - bh;
  const double product = a * b;
  return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

// The reduced angle r = angle - quadrant * pi/2 as a pair, |r| <= pi/4 and a little.
struct ReducedAngle {
  Pair r;
  int quadrant;  // 0..3
};

// pi/2 in pieces of 33 bits, so that a multiple below 2^20 of each is exact, and the rest.
constexpr double kHalfPi1 = 0x1.921fb54400000p+0;
constexpr double kHalfPi2 = 0x1.0b4611a600000p-34;
constexpr double kHalfPi3 = 0x1.3198a2e000000p-69;
constexpr double kHalfPi4 = 0x1.b839a252049c1p-104;

// The first 1280 bits of 2/pi.
constexpr std::array<std::uint64_t, 20> kTwoOverPi = {
    0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561, 0xb7246e3a424dd2e0,
    0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4,
    0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab, 0xf0cfbc209af4361d};

// 64 bits of 2/pi from `bit` on (0 is the first behind the binary point).
std::uint64_t twoOverPiBits(int bit) {
  const auto word = static_cast<std::size_t>(bit / 64);
  const int shift = bit % 64;
  const std::uint64_t high = kTwoOverPi[word] << shift;
  return shift == 0 ? high : high | (kTwoOverPi[word + 1] >> (64 - shift));
}

struct Wide {
  std::uint64_t high, low;
};

Wide multiply(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t al = a & 0xffffffff, ah = a >> 32, bl = b & 0xffffffff, bh = b >> 32;
  const std::uint64_t low = al * bl, mid1 = ah * bl + (low >> 32), mid2 = al * bh + (mid1 & 0xffffffff);
  return {ah * bh + (mid1 >> 32) + (mid2 >> 32), (mid2 << 32) | (low & 0xffffffff)};
}

// A fixed-point number of 256 bits, most significant word first.
using Words = std::array<std::uint64_t, 4>;

Words shiftedLeft(const Words& w, int bits) {  // 0 <= bits < 64
  if (bits == 0) return w;
  Words out{};
  for (std::size_t i = 0; i < 4; ++i) out[i] = (w[i] << bits) | (i < 3 ? w[i + 1] >> (64 - bits) : 0);
  return out;
}

Words negated(const Words& w) {
  Words out{};
  std::uint64_t carry = 1;
  for (std::size_t i = 4; i-- > 0;) {
    out[i] = ~w[i] + carry;
    carry = out[i] < carry ? 1 : 0;
  }
  return out;
}

// Payne, Hanek 1983: of angle * 2/pi only two integer bits and the fraction matter, so the leading bits of
// 2/pi whose product with the mantissa is a multiple of 4 are left out. Integers throughout.
ReducedAngle reduceLarge(double angle) {
  const auto bits = std::bit_cast<std::uint64_t>(std::abs(angle));
  const std::uint64_t mantissa = (bits & 0xfffffffffffffull) | (1ull << 52);
  const int exponent =
      static_cast<int>(bits >> 52) - 1023 - 52;  // |angle| = mantissa * 2^exponent; > -34 here
  const int first = exponent > 2 ? exponent - 2 : 0;
  // product = mantissa * (192 bits of 2/pi from `first`); its lowest bit weighs 2^(exponent - first - 192).
  const Wide a = multiply(mantissa, twoOverPiBits(first + 128));
  const Wide b = multiply(mantissa, twoOverPiBits(first + 64));
  const Wide c = multiply(mantissa, twoOverPiBits(first));
  Words w{};
  w[3] = a.low;
  w[2] = b.low + a.high;
  const std::uint64_t carry2 = w[2] < a.high ? 1 : 0;
  w[1] = c.low + b.high;
  std::uint64_t carry1 = w[1] < b.high ? 1 : 0;
  w[1] += carry2;
  carry1 += w[1] < carry2 ? 1 : 0;
  w[0] = c.high + carry1;
  // The bit of weight 2^1 goes to the top: it is bit 193 - (exponent - first) of 256.
  const int up = 62 + exponent - first;  // 29..64
  w = up == 64 ? Words{w[1], w[2], w[3], 0} : shiftedLeft(w, up);
  int quadrant = static_cast<int>(w[0] >> 62);
  w = shiftedLeft(w, 2);  // the fraction, in [0, 1)
  const bool negative = (w[0] >> 63) != 0;
  if (negative) {  // to [-1/2, 1/2)
    quadrant += 1;
    w = negated(w);
  }
  // 106 bits of it as a pair. No double is closer to a multiple of pi/2 than 2^-62 of it (Muller 2006, 11.3),
  // so the leading one is in the first word.
  const int zeros = std::countl_zero(w[0] | 1);
  w = shiftedLeft(w, zeros);
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - zeros) << 52);  // 2^-zeros
  const double top = static_cast<double>(w[0] >> 11) * 0x1p-53 * scale;
  const double rest = static_cast<double>(((w[0] & 0x7ff) << 42) | (w[1] >> 22)) * 0x1p-106 * scale;
  Pair r = twoProduct(top, kHalfPi);
  r = fastTwoSum(r.hi, r.lo + top * (kPiLow / 2) + rest * kHalfPi);
  if (negative) r = {-r.hi, -r.lo};
  if (angle < 0) return {{-r.hi, -r.lo}, (4 - (quadrant & 3)) & 3};
  return {r, quadrant & 3};
}

ReducedAngle reduce(double angle) {
  if (std::abs(angle) <= kPi / 4) return {{angle, 0}, 0};
  if (std::abs(angle) > 1e6) return reduceLarge(angle);
  const double n = std::floor(angle * (2 / kPi) + 0.5);
  // Each product is exact; the sums keep their rounding errors.
  const double a = angle - n * kHalfPi1;
  const Pair b = twoSum(a, -n * kHalfPi2);
  const Pair c = twoSum(b.hi, -n * kHalfPi3);
  const Pair r = fastTwoSum(c.hi, c.lo + b.lo - n * kHalfPi4);
  return {r, static_cast<int>(static_cast<std::int64_t>(n) & 3)};
}

// Taylor series to where the next term is below 2^-64 of the result; the pair's low part enters linearly.
double sineOf(const Pair& r) {
  const double z = r.hi * r.hi;
  const double tail =
      z * (-1 / 6.0 +
           z * (1 / 120.0 +
                z * (-1 / 5040.0 +
                     z * (1 / 362880.0 +
                          z * (-1 / 39916800.0 + z * (1 / 6227020800.0 + z * (-1 / 1307674368000.0 +
                                                                              z / 355687428096000.0)))))));
  return r.hi + (r.hi * tail + r.lo * (1 - 0.5 * z));
}

double cosineOf(const Pair& r) {
  const double z = r.hi * r.hi;
  const double tail =
      z * z *
      (1 / 24.0 +
       z * (-1 / 720.0 +
            z * (1 / 40320.0 + z * (-1 / 3628800.0 + z * (1 / 479001600.0 + z * (-1 / 87178291200.0 +
                                                                                 z / 20922789888000.0))))));
  const double half = 0.5 * z;
  const double lead = 1 - half;  // its rounding error is (1 - lead) - half
  return lead + (((1 - lead) - half) + (tail - r.hi * r.lo));
}

// 2^n for -1022 <= n <= 1023.
double powerOfTwo(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); }

constexpr double kLn2High = 0x1.62e42fef00000p-1;  // 33 bits: a multiple below 2^20 is exact
constexpr double kLn2Low = 0x1.473de6af278edp-34;

// exp(x.hi + x.lo) for any finite hi, |lo| far below 1.
double expOf(const Pair& x) {
  if (x.hi > 709.79) return kInfinity;
  if (x.hi < -745.14) return 0;
  const double n = std::floor(x.hi * (1 / 0.693147180559945309417) + 0.5);
  const double high = x.hi - n * kLn2High;  // exact
  const Pair r = twoSum(high, -n * kLn2Low);
  const double t = r.hi;
  const double low = r.lo + x.lo;
  double tail = 1 / 87178291200.0;  // 1/14!
  for (const double c : {1 / 6227020800.0, 1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0, 1 / 362880.0,
                         1 / 40320.0, 1 / 5040.0, 1 / 720.0, 1 / 120.0, 1 / 24.0, 1 / 6.0, 0.5}) {
    tail = tail * t + c;
  }
  // exp = 1 + t + t^2 tail + low (1 + t)
  const Pair lead = fastTwoSum(1, t);
  const double value = lead.hi + (lead.lo + (t * t * tail + low * (1 + t)));
  const int k = static_cast<int>(n);
  if (k > 1023) return value * 2 * powerOfTwo(k - 1);
  if (k < -1021) return value * powerOfTwo(k + 100) * 0x1p-100;
  return value * powerOfTwo(k);
}

// log(x) for finite x > 0 as a pair, relative error below 2^-59.
Pair logOf(double x) {
  int exponent = 0;
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    exponent = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0xfffffffffffffull) | (1023ull << 52));  // [1, 2)
  if (m > 1.4142135623730951) {
    m *= 0.5;
    exponent += 1;
  }
  // log m = 2 atanh(s), s = (m - 1) / (m + 1), |s| < 0.1716
  const double numerator = m - 1;  // exact
  const Pair denominator = fastTwoSum(m > 1 ? m : 1, m > 1 ? 1 : m);
  const double s = numerator / denominator.hi;
  const Pair back = twoProduct(s, denominator.hi);
  const double sLow = ((numerator - back.hi) - back.lo - s * denominator.lo) / denominator.hi;
  const double z = s * s;
  double tail = 1 / 23.0;
  for (const double c :
       {1 / 21.0, 1 / 19.0, 1 / 17.0, 1 / 15.0, 1 / 13.0, 1 / 11.0, 1 / 9.0, 1 / 7.0, 1 / 5.0, 1 / 3.0}) {
    tail = tail * z + c;
  }
  const double correction = 2 * (sLow + s * z * tail);
  const Pair mantissa = fastTwoSum(2 * s, correction);
  const double k = exponent;
  const Pair whole = twoSum(k * kLn2High, mantissa.hi);
  const double low = whole.lo + mantissa.lo + k * kLn2Low;
  return fastTwoSum(whole.hi, low);
}

// atan(i / 16) as pairs.
constexpr std::array<Pair, 17> kArcTangent = {{{0x0.0p+0, 0x0.0p+0},
                                               {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
                                               {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                               {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
                                               {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                               {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
                                               {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                               {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
                                               {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                               {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
                                               {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                               {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
                                               {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                               {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
                                               {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                               {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
                                               {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

// atan(small / big) for 0 <= small <= big, big normal and both far from the ends of the range.
Pair arcTangentOf(double small, double big) {
  const double ratio = small / big;
  const auto i = static_cast<std::size_t>(ratio * 16 + 0.5);
  const double c = static_cast<double>(i) * 0.0625;
  // tan(a - atan c) = (small - c big) / (big + c small); the numerator cancels, so c big is taken exactly
  // (c has 5 bits) with its rounding error.
  const Pair cBig = twoProduct(c, big);
  const Pair numerator = twoSum(small, -cBig.hi);
  const double top = numerator.hi + (numerator.lo - cBig.lo);
  const double bottom = big + c * small;
  const double t = top / bottom;
  const double z = t * t;
  const double tail =
      z * (-1 / 3.0 + z * (1 / 5.0 + z * (-1 / 7.0 + z * (1 / 9.0 + z * (-1 / 11.0 + z / 13.0)))));
  return fastTwoSum(kArcTangent[i].hi, kArcTangent[i].lo + (t + t * tail));
}

}  // namespace

double sin(double angleRad) {
  if (!std::isfinite(angleRad)) return kNaN;
  if (std::abs(angleRad) < 1e-8) return angleRad;  // x - x^3/6 rounds to x; keeps -0
  const ReducedAngle a = reduce(angleRad);
  const double value = (a.quadrant & 1) ? cosineOf(a.r) : sineOf(a.r);
  return (a.quadrant & 2) ? -value : value;
}

double cos(double angleRad) {
  if (!std::isfinite(angleRad)) return kNaN;
  const ReducedAngle a = reduce(angleRad);
  const double value = (a.quadrant & 1) ? sineOf(a.r) : cosineOf(a.r);
  return ((a.quadrant + 1) & 2) ? -value : value;
}

double tan(double angleRad) {
  if (!std::isfinite(angleRad)) return kNaN;
  if (std::abs(angleRad) < 1e-8) return angleRad;
  const ReducedAngle a = reduce(angleRad);
  const double s = sineOf(a.r), c = cosineOf(a.r);
  return (a.quadrant & 1) ? -c / s : s / c;
}

double exp(double x) {
  if (x != x) return x;
  return expOf({x, 0});
}

double log(double x) {
  if (x != x || x < 0) return kNaN;
  if (x == 0) return -kInfinity;
  if (x == kInfinity) return x;
  const Pair value = logOf(x);
  return value.hi + value.lo;
}

double atan2(double y, double x) {
  if (x != x || y != y) return kNaN;
  const double ay = std::abs(y), ax = std::abs(x);
  const bool behind = std::signbit(x);
  Pair angle{0, 0};  // of (|x|, |y|)
  if (ay == 0) {
    angle = {0, 0};
  } else if (ax == 0) {
    angle = {kHalfPi, kPiLow / 2};
  } else if (ax == kInfinity || ay == kInfinity) {
    angle = ax != kInfinity ? Pair{kHalfPi, kPiLow / 2} : ay != kInfinity ? Pair{0, 0} : kArcTangent[16];
  } else {
    // Bring both into the middle of the range, where splitting and division are safe.
    double sy = ay, sx = ax;
    const double largest = sy > sx ? sy : sx;
    if (largest > 1e150) sy *= 0x1p-600, sx *= 0x1p-600;
    if (largest < 1e-150) sy *= 0x1p600, sx *= 0x1p600;
    if (sy <= sx) {
      angle = arcTangentOf(sy, sx);
      if (!behind && sy / sx < 1e-8) return std::copysign(ay / ax, y);  // keeps tiny and denormal angles
    } else {
      const Pair other = arcTangentOf(sx, sy);
      const Pair sum = twoSum(kHalfPi, -other.hi);
      angle = {sum.hi, sum.lo + (kPiLow / 2 - other.lo)};
    }
  }
  if (behind) {
    const Pair sum = twoSum(kPi, -angle.hi);
    angle = {sum.hi, sum.lo + (kPiLow - angle.lo)};
  }
  return std::copysign(angle.hi + angle.lo, y);
}

double asin(double x) {
  if (!(std::abs(x) <= 1)) return kNaN;
  return atan2(x, std::sqrt((1 - x) * (1 + x)));
}

double acos(double x) {
  if (!(std::abs(x) <= 1)) return kNaN;
  return atan2(std::sqrt((1 - x) * (1 + x)), x);
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (x != x || y != y) return kNaN;
  const double magnitude = std::abs(x);
  const bool integer = std::floor(y) == y;
  const bool odd = integer && std::abs(y) < 0x1p53 && (static_cast<std::int64_t>(y) & 1) != 0;
  if (std::abs(y) == kInfinity) {
    if (magnitude == 1) return 1;
    return (magnitude > 1) == (y > 0) ? kInfinity : 0;
  }
  if (magnitude == 0 || magnitude == kInfinity) {
    const double value = (magnitude == 0) == (y > 0) ? 0 : kInfinity;
    return odd && std::signbit(x) ? -value : value;
  }
  if (x < 0 && !integer) return kNaN;
  const Pair logarithm = logOf(magnitude);
  double value = 0;
  if (std::abs(y) > 1e18) {  // log is at least 1e-16: the result is 0 or infinite
    value = (magnitude > 1) == (y > 0) ? kInfinity : 0;
  } else {
    const Pair product = twoProduct(y, logarithm.hi);
    const Pair exponent = fastTwoSum(product.hi, product.lo + y * logarithm.lo);
    value = expOf(exponent);
  }
  return odd && x < 0 ? -value : value;
}

}  // namespace skydrop::core::dmath
