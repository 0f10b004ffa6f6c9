// Numbers of the page of `talus view`.
#include <gtest/gtest.h>

#include <cmath>

#include "output/view_pack.h"
#include "output/vtk_reader.h"

namespace talus {
namespace {

TEST(ViewPack, Base64IsThatOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(ViewPack, DeflatedIsZlib) {
  const std::string packed = deflated(std::string(10000, 'a'));
  EXPECT_LT(packed.size(), 100u);
  EXPECT_EQ(packed[0], '\x78');  // RFC 1950: deflate, 32 kB window
}

TEST(ViewPack, BytesOfOneWeightStandTogether) {
  // 1 = 0x3f800000, −2 = 0xc0000000: heaviest bytes 3f c0, then 80 00, then 00 00.
  EXPECT_EQ(packed_floats({1, -2}, 3), base64(deflated(std::string("\x3f\xc0\x80\x00\x00\x00", 6))));
  EXPECT_EQ(packed_whole({1, -1}), base64(deflated(std::string("\x00\xff\x00\xff\x00\xff\x01\xff", 8))));
}

TEST(ViewPack, ShortNumbersAreRoundedToTwelveBits) {
  // 1 + 2^-13 is half-way between two such numbers: up to 1 + 2^-12 = 0x3f800800.
  EXPECT_EQ(packed_floats({1 + std::ldexp(1.f, -13)}, 3), packed_floats({1 + std::ldexp(1.f, -12)}, 3));
  EXPECT_EQ(packed_floats({1 + std::ldexp(1.f, -14)}, 3), packed_floats({1}, 3));
  EXPECT_EQ(packed_floats({INFINITY}, 3), base64(deflated(std::string("\x7f\x80\x00", 3))));
}

}  // namespace
}  // namespace talus
