// SPDX-License-Identifier: BSD-3-Clause
#include "octree/octant.h"

#include <gtest/gtest.h>

#include <random>

namespace octet {
namespace {

TEST(Octant, MortonKeysInterleaveWithXLowest) {
  EXPECT_EQ(morton_key({1, 0, 0}), 1u);
  EXPECT_EQ(morton_key({0, 1, 0}), 2u);
  EXPECT_EQ(morton_key({0, 0, 1}), 4u);
  EXPECT_EQ(morton_key({3, 0, 2}), 1u + 8u + 32u);
}

TEST(Octant, KeysAndLatticePointsAreInverse) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Lattice p{static_cast<std::uint32_t>(random()) % (kLatticeExtent + 1),
                    static_cast<std::uint32_t>(random()) % (kLatticeExtent + 1),
                    static_cast<std::uint32_t>(random()) % (kLatticeExtent + 1)};
    EXPECT_EQ(lattice_of(morton_key(p)), p);
  }
  EXPECT_EQ(lattice_of(morton_key({kLatticeExtent, kLatticeExtent, kLatticeExtent})),
            (Lattice{kLatticeExtent, kLatticeExtent, kLatticeExtent}));
}

TEST(Octant, MortonLessComparesAsTheKeysDo) {
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    const unsigned mask = (1u << (1 + random() % 18)) - 1;  // small numbers too, for equal coordinates
    const auto number = [&] { return static_cast<std::uint32_t>(random()) & mask; };
    Lattice a{}, b{};
    for (int axis = 0; axis < 3; ++axis) {
      a[axis] = number();
      b[axis] = number();
    }
    EXPECT_EQ(morton_less(a, b), morton_key(a) < morton_key(b));
    EXPECT_FALSE(morton_less(a, a));
  }
}

TEST(Octant, AChildsKeyHoldsItsParents) {
  const Octant parent = octant_of(5, 1);
  EXPECT_EQ(parent.corner, (Lattice{kLatticeExtent / 2, 0, kLatticeExtent / 2}));
  EXPECT_EQ(octant_of(5 << 3, 2).corner, parent.corner);
  EXPECT_EQ(octant_of(5 << 3 | 7, 2).corner[1], kLatticeExtent / 4);
}

}  // namespace
}  // namespace octet
